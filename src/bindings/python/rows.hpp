// Work on the rows of an argument, on several threads, with errors that name the row.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <touchstone/error.hpp>

#include "python/background.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::python {

constexpr std::size_t kFirst = 2048;  // queries of the first chunk: less than a millisecond, but for degenerate ones

/// Works on rows [first, last). An InvalidQuery becomes one that names the row: ask(q) throws it for row q again.
template <class Work, class Ask>
void naming_the_row(std::size_t first, std::size_t last, const Work& work, const Ask& ask) {
  try {
    work();
  } catch (const InvalidQuery&) {
    for (std::size_t q = first; q < last; ++q) {
      try {
        ask(q);
      } catch (const InvalidQuery& error) {
        throw InvalidQuery("row " + std::to_string(q) + ": " + error.what());
      }
    }
    throw;
  }
}

/// Calls ask(q), on several threads, for each row q below `count`.
template <class Ask>
void for_each_row(std::size_t count, int threads, const Ask& ask) {
  constexpr std::size_t kAtATime = 64;
  in_chunks(count, kFirst, [&](std::size_t first, std::size_t last) {
    const auto work = [&] {
      threads::for_each_range(last - first, kAtATime, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = first + begin; q < first + end; ++q) ask(q);
      });
    };
    naming_the_row(first, last, work, ask);
  });
}

}  // namespace touchstone::python

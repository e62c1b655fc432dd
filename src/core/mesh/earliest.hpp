// The contacts that begin first, of many that are found in any order.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/contact_times.hpp>

#include "threads/for_each_range.hpp"

namespace touchstone::mesh {

/// A pair in contact, and the distance that it was to keep.
template <class Pair>
struct Found {
  Pair pair;
  double distance;
  bool operator<(const Found& other) const { return pair < other.pair; }
};

/// The contacts that begin first, of those that were told so far, and the contacts at the start. Any thread may tell.
template <class Pair>
class Earliest {
 public:
  explicit Earliest(double t_max) : until_(t_max) {}

  /// Nothing after this time can change the result.
  const std::atomic<double>& until() const noexcept { return until_; }

  void tell(const Pair& pair, double distance, const Answer& answer) {
    const std::lock_guard<std::mutex> guard(lock_);
    if (answer.starts_within) {
      at_start_.push_back({pair, distance});
      return;
    }
    const auto told = std::tuple(answer.toi, answer.toi_upper), known = std::tuple(toi_, toi_upper_);
    if (told > known) return;
    if (told < known) {
      first_.clear();
      std::tie(toi_, toi_upper_) = told;
      until_.store(toi_upper_, std::memory_order_relaxed);  // it is at most t_max
    }
    first_.push_back({pair, distance});
  }

  double toi() const noexcept { return toi_; }
  double toi_upper() const noexcept { return toi_upper_; }
  std::vector<Found<Pair>>& first() noexcept { return first_; }
  std::vector<Found<Pair>>& at_start() noexcept { return at_start_; }

 private:
  std::mutex lock_;
  std::atomic<double> until_;
  double toi_ = std::numeric_limits<double>::infinity();
  double toi_upper_ = std::numeric_limits<double>::infinity();
  std::vector<Found<Pair>> first_, at_start_;
};

constexpr std::size_t kContactsAtATime = 16;

/// Of contacts whose times lie between two neighbouring doubles, those whose time is exactly the least.
/// @param time_of  the exact time of a contact
template <class Contact, class TimeOf>
void keep_exactly_first(std::vector<Contact>& contacts, int threads, const TimeOf& time_of) {
  if (contacts.size() < 2 || contacts[0].answer.toi == contacts[0].answer.toi_upper) return;
  std::vector<std::optional<ExactTime>> times(contacts.size());
  threads::for_each_range(contacts.size(), kContactsAtATime, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) times[i] = time_of(contacts[i]);
  });
  std::vector<Contact> earliest;
  const ExactTime* least = nullptr;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const int order = least == nullptr ? -1 : times[i]->compare(*least);
    if (order > 0) continue;
    if (order < 0) {
      earliest.clear();
      least = &*times[i];
    }
    earliest.push_back(contacts[i]);
  }
  contacts = std::move(earliest);
}

}  // namespace touchstone::mesh

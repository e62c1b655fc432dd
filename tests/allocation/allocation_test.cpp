// solve allocates memory for long numbers only: the test counts calls of operator new and of GMP's allocators.
// SPDX-License-Identifier: MIT
#include <gmp.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

#include <touchstone/solve.hpp>

#include "exact/common_scale.hpp"
#include "support/report.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted_allocation_or_null(std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size == 0 ? 1 : size);
}

void* counted_allocation(std::size_t size) {
  if (void* memory = counted_allocation_or_null(size)) return memory;
  throw std::bad_alloc();
}

void* counted_allocation(std::size_t size, std::align_val_t alignment) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}

void* gmp_allocate(std::size_t size) { return counted_allocation(size); }
void* gmp_reallocate(void* memory, std::size_t, std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return std::realloc(memory, size);
}
void gmp_free(void* memory, std::size_t) { std::free(memory); }

const bool gmp_is_counted = [] {
  mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
  return true;
}();

}  // namespace

void* operator new(std::size_t size) { return counted_allocation(size); }
void* operator new[](std::size_t size) { return counted_allocation(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted_allocation_or_null(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted_allocation_or_null(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return counted_allocation(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return counted_allocation(size, alignment); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 31;

TEST_CASE("the counter sees what operator new and GMP allocate") {
  const std::size_t before = allocations;
  ::operator delete(::operator new(8));
  ::operator delete(::operator new(64, std::align_val_t(64)), std::align_val_t(64));
  CHECK(allocations == before + 2);
  REQUIRE(gmp_is_counted);
  mpz_t number;
  mpz_init_set_ui(number, 1);
  mpz_mul_2exp(number, number, 10000);
  mpz_clear(number);
  CHECK(allocations > before + 2);
}

TEST_CASE("solve allocates nothing before exact arithmetic, and hardly ever for numbers below 3,072 bits") {
  Report report;
  std::array<std::size_t, 4> by_filter{};
  std::size_t by_bracket = 0;
  std::array<std::size_t, 2> short_exact{}, long_exact{};  // without and with allocations
  for_each_case(
      kSeed, 1000, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        const std::size_t before = allocations;
        const Answer answer = solve(query);
        const std::size_t during = allocations - before;
        // Coordinates of so many bits make coefficients of three times as many, and signs at roots of a few times
        // those.
        constexpr int kShortBits = 120;
        const bool is_long = exact::coordinate_span(query).bits() > kShortBits;
        if (answer.level == Level::exact || (answer.level == Level::bracket && is_long)) {
          ++(is_long ? long_exact : short_exact)[during > 0];
          return;
        }
        if (answer.level == Level::filter) ++by_filter[static_cast<std::size_t>(id.kind)];
        if (answer.level == Level::bracket) ++by_bracket;
        report.add(id, query,
                   during == 0 ? "" : std::to_string(during) + " allocations by " + std::string(name_of(answer.level)));
      });
  if (!chosen_case()) {
    for (const Kind kind : kKinds) {
      std::printf("%-12s %zu queries decided by a filter\n", name_of(kind).data(),
                  by_filter[static_cast<std::size_t>(kind)]);
      CHECK(by_filter[static_cast<std::size_t>(kind)] > 0);
    }
    std::printf("bracket, short: %zu; exact, short: %zu without allocations, %zu with; both, long: %zu and %zu\n",
                by_bracket, short_exact[0], short_exact[1], long_exact[0], long_exact[1]);
    CHECK(by_bracket > 0);
    // Roots that doubles cannot tell apart are told apart by GMP's floating-point numbers.
    CHECK(short_exact[0] > 0);
    CHECK(short_exact[1] * 1000 <= short_exact[0]);
    CHECK(long_exact[1] > 0);  // or the counter sees nothing
    CHECK(long_exact[1] < long_exact[0]);
  }
  report.finish();
}

TEST_CASE("a batch into the caller's memory allocates nothing when filters decide") {
  std::vector<Query> queries;
  for_each_case(
      kSeed, 200, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        if (solve(query).level == Level::filter) queries.push_back(query);
      });
  std::vector<Answer> answers(queries.size());
  const std::size_t before = allocations;
  solve_batch(queries.data(), queries.size(), answers.data());
  CHECK(allocations == before);
  CHECK_FALSE(queries.empty());
}

}  // namespace
}  // namespace touchstone::tests

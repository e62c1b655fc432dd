// The bytes for each element that the header states: of a mesh, and of the questions about it. The test counts what
// operator new hands out.
// SPDX-License-Identifier: MIT
#include <malloc.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

namespace {

std::atomic<std::size_t> held{0}, most_held{0};

void* note(void* memory, std::size_t size) noexcept {
  if (memory == nullptr) return nullptr;
  const std::size_t now = held += size;
  std::size_t most = most_held;
  while (most < now && !most_held.compare_exchange_weak(most, now)) {
  }
  return memory;
}

void* counted_or_null(std::size_t size) noexcept {
  void* const memory = std::malloc(size == 0 ? 1 : size);
  return note(memory, memory == nullptr ? 0 : malloc_usable_size(memory));
}

void* or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* counted(std::size_t size) { return or_throw(counted_or_null(size)); }

void release(void* memory) noexcept {
  if (memory == nullptr) return;
  held -= malloc_usable_size(memory);
  std::free(memory);
}

/// Of aligned memory, what was asked for counts: the rest of its usable size is address space up to the alignment,
/// which nobody touches.
struct AlignedMemory {
  void* hand_out(std::size_t size, std::size_t alignment) {
    const std::lock_guard<std::mutex> guard(lock);
    const auto free = std::find_if(all.begin(), all.end(), [](const auto& one) { return one.first == nullptr; });
    if (free == all.end()) throw std::bad_alloc();
    *free = {or_throw(note(std::aligned_alloc(alignment, size), size)), size};
    return free->first;
  }
  void take_back(void* memory) noexcept {
    if (memory == nullptr) return;
    const std::lock_guard<std::mutex> guard(lock);
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == memory; });
    held -= found->second;
    *found = {};
    std::free(memory);
  }
  std::mutex lock;
  std::array<std::pair<void*, std::size_t>, 1024> all{};
} aligned_memory;

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted_or_null(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted_or_null(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return aligned_memory.hand_out(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory, std::align_val_t) noexcept { aligned_memory.take_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { aligned_memory.take_back(memory); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

using namespace touchstone;

namespace {

/// The most bytes that are held during `work`, beyond those held before it.
template <class Work>
std::size_t most_bytes(const Work& work) {
  const std::size_t before = held;
  most_held = before;
  work();
  return most_held - before;
}

struct Case {
  const char* name;
  MeshElements elements;
  std::vector<double> x0, x1;
};

/// A waving sheet of n x n squares.
Case sheet(std::size_t n) {
  Case one{"sheet", {}, {}, {}};
  one.elements.vertex_count = (n + 1) * (n + 1);
  const auto number = [n](std::size_t i, std::size_t j) { return static_cast<MeshIndex>(i * (n + 1) + j); };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      one.elements.faces.push_back({number(i, j), number(i + 1, j), number(i, j + 1)});
      one.elements.faces.push_back({number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  seeded::Rng random(1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      for (const double x : {static_cast<double>(i), static_cast<double>(j), 0.0}) {
        one.x0.push_back(x + 0.1 * random.symmetric());
        one.x1.push_back(one.x0.back() + 0.1 * random.symmetric());
      }
    }
  }
  return one;
}

/// Elements without order: `count` faces, or edges, or points, that are small and apart.
Case scattered(const char* name, std::size_t corners, std::size_t count) {
  Case one{name, {}, {}, {}};
  one.elements.vertex_count = corners * count;
  seeded::Rng random(2);
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<MeshIndex>(corners * i);
    if (corners == 3) one.elements.faces.push_back({first, first + 1, first + 2});
    if (corners == 2) one.elements.edges.push_back({first, first + 1});
    const double at[3] = {100 * random.unit(), 100 * random.unit(), 100 * random.unit()};
    for (std::size_t c = 0; c < corners; ++c) {
      for (const double x : at) {
        one.x0.push_back(x + 0.1 * random.symmetric());
        one.x1.push_back(one.x0.back() + 0.1 * random.symmetric());
      }
    }
  }
  return one;
}

/// A sheet from which a chain of edges grows, and a loose point.
Case sheet_with_chain(std::size_t n) {
  Case one = sheet(n);
  one.name = "sheet, chain and point";
  const std::size_t links = n * n / 2;
  for (std::size_t i = 0; i <= links; ++i) {
    const auto last = static_cast<MeshIndex>(one.elements.vertex_count++);
    if (i > 0) one.elements.edges.push_back({last - 1, last});
    for (const double x : {static_cast<double>(i), static_cast<double>(i % 2), 50.0}) {
      one.x0.push_back(x);
      one.x1.push_back(x);
    }
  }
  ++one.elements.vertex_count;
  one.x0.insert(one.x0.end(), 3, -50.0);
  one.x1.insert(one.x1.end(), 3, -50.0);
  return one;
}

}  // namespace

TEST_CASE("a mesh and its questions need the stated number of bytes for each element") {
  const std::size_t size = TOUCHSTONE_SLOW_BUILD ? 40 : 150;
  for (Case& one : std::vector<Case>{sheet(size), sheet_with_chain(size), scattered("faces", 3, size * size),
                                     scattered("edges", 2, size * size), scattered("points", 1, size * size)}) {
    const std::size_t faces = one.elements.faces.size(), given_edges = one.elements.edges.size();
    const std::size_t vertices = one.elements.vertex_count;
    const std::size_t before = held;
    Mesh mesh;
    const std::size_t making = most_bytes([&] { mesh = Mesh(one.elements); });
    const std::size_t kept = held - before;
    const std::size_t edges = mesh.edges().size(), points = mesh.points().size();
    const std::size_t wires = given_edges;
    const std::size_t slack = 4096;
    const std::size_t boxes = faces + wires + points;
    const std::size_t of_mesh = 28 * faces + 8 * edges + 28 * wires + 4 * vertices + 20 * points;
    std::printf("%s: %zu faces, %zu edges, %zu vertices: the mesh %zu bytes, %zu while it is made", one.name, faces,
                edges, vertices, kept, making);
    CAPTURE(one.name);
    CHECK(kept <= of_mesh + slack);
    CHECK(kept > of_mesh - of_mesh / 5);  // a chain alone needs all of it
    CHECK(making <= of_mesh + 40 * faces + 28 * given_edges + 8 * vertices + slack);

    const Positions x0(one.x0, 3), x1(one.x1, 3);
    for (const int threads : {1, 2}) {
      FirstContactOptions options;
      options.threads = threads;
      std::size_t contacts = 0;
      const std::size_t asking = most_bytes([&] { contacts = first_contact(mesh, x0, x1, options).earliest.size(); });
      const double each = static_cast<double>(asking - std::min(asking, 48 * vertices)) / static_cast<double>(boxes);
      std::printf("; first_contact on %d threads: %zu, 48 a vertex and %.0f a box", threads, asking, each);
      CHECK(asking > 100 * boxes);  // or nothing is counted
      if (size > 100) CHECK(each <= 240);
    }
    std::printf("\n");
  }
}

TEST_CASE("a question that is like the one before takes next to no memory, and so no page faults") {
  const Case one = sheet(TOUCHSTONE_SLOW_BUILD ? 40 : 150);
  const Mesh mesh(one.elements);
  MeshSteps steps(mesh);
  const Positions x(one.x0, 3);
  const std::size_t first = most_bytes([&] { steps.first_contact(x, x); });
  const std::size_t second = most_bytes([&] { steps.first_contact(x, x); });
  std::printf("the first question takes %zu bytes, the second %zu\n", first, second);
  CHECK(steps.searches() == 1);
  CHECK(first > 100 * mesh.faces().size());
  CHECK(second <= 16'384);
}

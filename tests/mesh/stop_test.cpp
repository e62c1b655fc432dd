// Work that an exception ends on several threads. With the thread sanitizer these are tests of the handover: what the
// work has written by then is the caller's, without a race.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include <touchstone/mesh.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::tests {
namespace {

/// Two sheets of g by g vertices, one above the other, that pass through each other.
struct Sheets {
  explicit Sheets(MeshIndex g) {
    seeded::Rng random(7);
    elements.vertex_count = std::size_t{2} * g * g;
    for (MeshIndex v = 0; v < 2 * g * g; ++v) {
      const MeshIndex layer = v / (g * g), i = v / g % g, j = v % g;
      for (const MeshIndex at : {i, j, layer}) x0.push_back(at + random.uniform(0, 0.1));
      if (i + 1 == g || j + 1 == g) continue;
      elements.faces.push_back({v, v + 1, v + g});
      elements.faces.push_back({v + 1, v + g + 1, v + g});
    }
    for (const double x : x0) x1.push_back(x + random.symmetric());
  }

  MeshElements elements;
  std::vector<double> x0, x1;
};

}  // namespace

TEST_CASE("one thread or several: what work wrote before an exception ended it is there") {
  for (int round = 0; round < 20; ++round) {
    std::vector<int> written(4096, 0);
    CHECK_THROWS_AS(
        threads::for_each_range(written.size(), 8, 4,
                                [&](std::size_t first, std::size_t last) {
                                  std::this_thread::sleep_for(std::chrono::microseconds(20));  // so that others join in
                                  for (std::size_t i = first; i < last; ++i) ++written[i];
                                  if (first >= 2048) throw std::runtime_error("no further");
                                }),
        std::runtime_error);
    CHECK(*std::max_element(written.begin(), written.end()) == 1);
    written.assign(written.size(), 0);  // by this thread, after the others
  }
}

TEST_CASE("one thread or several: a stop from another thread leaves the mesh as it was") {
  const Sheets sheets(24);
  const Mesh mesh(sheets.elements);
  FirstContactOptions options;
  options.threads = 4;
  const std::size_t contacts = all_contacts(mesh, {sheets.x0, 3}, {sheets.x1, 3}, options).size();
  CHECK(contacts > 0);
  for (int round = 0; round < 10; ++round) {
    std::atomic<bool> stop{false};
    FirstContactOptions stopped = options;
    stopped.stop = &stop;
    std::thread other([&] { stop = true; });
    std::optional<std::size_t> found;
    try {
      found = all_contacts(mesh, {sheets.x0, 3}, {sheets.x1, 3}, stopped).size();
    } catch (const Stopped&) {
    }
    other.join();
    CHECK(found.value_or(contacts) == contacts);
  }
  CHECK(all_contacts(mesh, {sheets.x0, 3}, {sheets.x1, 3}, options).size() == contacts);
}

}  // namespace touchstone::tests

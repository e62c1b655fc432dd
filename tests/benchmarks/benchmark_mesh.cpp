// Whole meshes: the first contact of a step beside its broad phase alone, on one thread and two, from 10^4 to 10^6
// faces.
//
//     benchmark_mesh [MOST_FACES] [STEPS]
//
// The scene is a stack of waving cloths, half an edge apart, that do not touch. A line has the least seconds of several
// steps: for the broad phase, for first_contact on one thread and on two, and their ratios; then the number of
// candidate pairs, and the greatest memory of the process so far. A second table has the least milliseconds of other
// questions, on one thread: free_step; the six tries of a line search by MeshSteps, each try on the average and the
// last one; free_step that keeps 0.2 of each distance; and intersections; and the page faults of a free step. The last
// line is the exponent of the growth of the time.
// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <vector>

#include <touchstone/mesh.hpp>
#include <touchstone/mesh_steps.hpp>

#include "mesh/candidates.hpp"

namespace touchstone::benchmarks {
namespace {

constexpr std::size_t kSheets = 4;

struct Stack {
  MeshElements elements;
  std::size_t side = 1;  // squares along a side of a sheet
};

Stack make_stack(std::size_t faces) {
  Stack stack;
  stack.side =
      static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(faces) / (2 * static_cast<double>(kSheets)))));
  const std::size_t n = stack.side, each = (n + 1) * (n + 1);
  stack.elements.vertex_count = kSheets * each;
  for (std::size_t sheet = 0; sheet < kSheets; ++sheet) {
    const auto number = [&](std::size_t i, std::size_t j) {
      return static_cast<MeshIndex>(sheet * each + i * (n + 1) + j);
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        stack.elements.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
        stack.elements.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
      }
    }
  }
  return stack;
}

/// The sheets at a time: a step of time 1 moves a vertex by up to about a third of an edge.
std::vector<double> place(const Stack& stack, double time) {
  const double edge = 1 / static_cast<double>(stack.side);
  std::vector<double> x;
  x.reserve(3 * stack.elements.vertex_count);
  for (std::size_t sheet = 0; sheet < kSheets; ++sheet) {
    for (std::size_t i = 0; i <= stack.side; ++i) {
      for (std::size_t j = 0; j <= stack.side; ++j) {
        const double u = edge * static_cast<double>(i), v = edge * static_cast<double>(j), t = edge * time;
        const double wave = std::sin(9 * u + 4 * v + 2 * t) + 0.5 * std::sin(23 * v - 7 * u - 3 * t);
        x.push_back(u + 0.2 * edge * std::sin(31 * v + t));
        x.push_back(v + 0.2 * edge * std::cos(27 * u - t));
        x.push_back(0.06 * wave + 0.5 * edge * static_cast<double>(sheet));
      }
    }
  }
  return x;
}

template <class Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Pairs that the broad phase finds.
std::size_t count_candidates(const Mesh& mesh, const std::vector<double>& x0, const std::vector<double>& x1,
                             int threads) {
  std::atomic<std::size_t> pairs{0};
  const mesh::Motion motion = mesh::motion_of(mesh.impl(), {x0, 3}, {x1, 3}, threads);
  broad_phase::PairSearch search;
  search.threads = threads;
  mesh::for_each_candidate_block(mesh.impl(), motion, mesh::reach_of_separations(mesh.impl()), search,
                                 [&](Kind, const broad_phase::Pair*, std::size_t count) { pairs += count; });
  return pairs;
}

struct Row {
  std::size_t faces = 0;
  double one_thread = 0;
};

long page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Row measure(std::size_t faces, int steps) {
  const Stack stack = make_stack(faces);
  const Mesh mesh(stack.elements);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double broad = kInfinity, broad_two = kInfinity, one = kInfinity, two = kInfinity, ratio = kInfinity;
  std::size_t pairs = 0, contacts = 0;
  for (int step = 0; step < steps; ++step) {
    const std::vector<double> x0 = place(stack, step), x1 = place(stack, step + 1);
    FirstContactOptions options;
    const double broad_now = seconds([&] { pairs = count_candidates(mesh, x0, x1, 1); });
    const double one_now = seconds([&] { contacts += first_contact(mesh, {x0, 3}, {x1, 3}, options).free() ? 0 : 1; });
    options.threads = 2;
    broad_two = std::min(broad_two, seconds([&] { count_candidates(mesh, x0, x1, 2); }));
    two = std::min(two, seconds([&] { first_contact(mesh, {x0, 3}, {x1, 3}, options); }));
    broad = std::min(broad, broad_now);
    one = std::min(one, one_now);
    ratio = std::min(ratio, one_now / broad_now);
  }
  std::printf("%8zu  %9.4f  %13.4f  %5.2f  %9.4f  %8.2f  %9.4f  %8.2f  %10zu  %8zu  %6.0f\n", mesh.faces().size(),
              broad, one, one / broad, two, one / two, broad_two, broad / broad_two, pairs, contacts, peak_megabytes());
  std::fflush(stdout);
  return {mesh.faces().size(), one};
}

void measure_others(std::size_t faces, int steps) {
  const Stack stack = make_stack(faces);
  const Mesh mesh(stack.elements);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr int kTries = 6;
  double free = kInfinity, tries = kInfinity, last = kInfinity, kept = kInfinity, at_rest = kInfinity;
  long faults = 0;
  for (int step = 0; step < steps; ++step) {
    const std::vector<double> x0 = place(stack, step), x1 = place(stack, step + 1);
    const long before = page_faults();
    free = std::min(free, seconds([&] { free_step(mesh, {x0, 3}, {x1, 3}); }));
    faults = page_faults() - before;
    MeshSteps search(mesh);
    double all = 0, now = 0;
    std::vector<double> end = x1;
    for (int i = 0; i < kTries; ++i) {
      for (std::size_t k = 0; k < end.size(); ++k) end[k] = x0[k] + (1 - 0.1 * i) * (x1[k] - x0[k]);
      all += now = seconds([&] { search.first_contact({x0, 3}, {end, 3}); });
    }
    tries = std::min(tries, all / kTries);
    last = std::min(last, now);
    FreeStepOptions options;
    options.kept_fraction = 0.2;
    kept = std::min(kept, seconds([&] { free_step(mesh, {x0, 3}, {x1, 3}, options); }));
    at_rest = std::min(at_rest, seconds([&] { intersections(mesh, {x0, 3}); }));
  }
  std::printf("%8zu  %9.2f  %11.2f  %9.2f  %9.2f  %13.2f  %8ld\n", mesh.faces().size(), 1e3 * free, 1e3 * tries,
              1e3 * last, 1e3 * kept, 1e3 * at_rest, faults);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  const auto most = static_cast<std::size_t>(argc > 1 ? std::atoll(argv[1]) : 1'000'000);
  const int steps = argc > 2 ? std::atoi(argv[2]) : 3;
  std::printf(
      "   faces    broad s  first_contact  ratio  2 threads  speed-up  broad 2 s  speed-up       pairs  contacts"
      "      MB\n");
  std::vector<Row> rows;
  for (std::size_t faces = 10'000; faces <= most; faces *= 10) rows.push_back(measure(faces, steps));
  std::printf("\n   faces  free step  six tries/6  last try  kept 0.2  intersections    faults\n");
  for (std::size_t faces = 1'000; faces <= most; faces *= 10) measure_others(faces, 3 * steps);
  if (rows.size() < 2) return 0;
  const double growth = std::log(rows.back().one_thread / rows.front().one_thread);
  std::printf("exponent: %.3f\n",
              growth / std::log(static_cast<double>(rows.back().faces) / static_cast<double>(rows.front().faces)));
  return 0;
}

}  // namespace
}  // namespace touchstone::benchmarks

int main(int argc, char** argv) {
  try {
    return touchstone::benchmarks::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_mesh: %s\n", error.what());
    return 2;
  }
}

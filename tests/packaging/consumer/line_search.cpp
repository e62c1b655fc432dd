// A program written for Tight-Inclusion: a line search moves a soup of triangles towards a target, in steps of 0.8
// times the first time of impact. Each step is asked about again, from the positions before it to those after it, and
// must be free. It names nothing of Touchstone's. Exit status 0 when the law holds.
// SPDX-License-Identifier: MIT
#include <tight_inclusion/ccd.hpp>
#include <tight_inclusion/interval_root_finder.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {

using Positions = std::vector<ticcd::Vector3>;

constexpr int kTriangles = 12;

/// Pseudo-random numbers in [-1, 1), the same everywhere.
class Random {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }

 private:
  unsigned long long state_ = 1;
};

/// Small triangles at the places of a grid, apart from each other.
Positions apart(double scale, Random& random) {
  Positions x;
  for (int i = 0; i < kTriangles; ++i) {
    const ticcd::Vector3 centre(i % 3, i / 3 % 2, i / 6);
    for (int k = 0; k < 3; ++k) {
      const double a = random(), b = random(), c = random();
      x.push_back(scale * (centre + 0.25 * ticcd::Vector3(a, b, c)));
    }
  }
  return x;
}

/// The first time of impact of any pair of the triangles: infinity for none.
class Search {
 public:
  explicit Search(double scale) {
    std::vector<ticcd::Vector3> box;
    for (const double sign : {-1.0, 1.0}) box.push_back(ticcd::Vector3::Constant(sign * 4 * scale));
    edges_ = ticcd::get_numerical_error(box, false, false);
    faces_ = ticcd::get_numerical_error(box, true, false);
  }

  double first_impact(const Positions& start, const Positions& end) {
    double first = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3 * kTriangles; ++i) {
      for (int j = 0; j < kTriangles; ++j) {
        if (i / 3 == j) continue;
        const auto f = 3 * static_cast<std::size_t>(j);
        const auto v = static_cast<std::size_t>(i);
        double toi = -1, reached = -1;
        const bool hit = ticcd::vertexFaceCCD(start[v], start[f], start[f + 1], start[f + 2], end[v], end[f],
                                              end[f + 1], end[f + 2], faces_, 0, toi, 1e-6, 1, 1000000, reached, true);
        keep(first, hit, toi, reached);
      }
    }
    for (int i = 0; i < 3 * kTriangles; ++i) {
      for (int j = i / 3 * 3 + 3; j < 3 * kTriangles; ++j) {
        const auto a = edge(i), b = edge(j);
        double toi = -1, reached = -1;
        const bool hit = ticcd::edgeEdgeCCD(start[a[0]], start[a[1]], start[b[0]], start[b[1]], end[a[0]], end[a[1]],
                                            end[b[0]], end[b[1]], edges_, 0, toi, 1e-6, 1, 1000000, reached, true);
        keep(first, hit, toi, reached);
      }
    }
    return first;
  }

  int queries = 0;
  int broken = 0;

 private:
  static std::array<std::size_t, 2> edge(int i) {
    return {static_cast<std::size_t>(i), static_cast<std::size_t>(i % 3 == 2 ? i - 2 : i + 1)};
  }

  void keep(double& first, bool hit, double toi, double reached) {
    ++queries;
    // Compared in a way that -ffast-math does not take away.
    const bool time_is_finite = toi >= 0 && toi <= 1;
    if (hit != time_is_finite || (hit && toi == 0) || !(reached > 0)) ++broken;
    if (hit && toi < first) first = toi;
  }

  ticcd::Array3 edges_, faces_;
};

}  // namespace

int main(int count, char** arguments) {
  const int seeds = count > 1 ? std::atoi(arguments[1]) : 4;
  int steps = 0, queries = 0, broken = 0;
  for (const double scale : {0.01, 1.0, 1000.0}) {
    for (int seed = 0; seed < seeds; ++seed) {
      Random random;
      for (int i = 0; i < 1000 * seed; ++i) random();
      Positions x = apart(scale, random);
      Positions target = x;
      for (auto& position : target) {
        const double a = random(), b = random(), c = random();
        position += scale * ticcd::Vector3(a, b, c);
      }
      Search search(scale);
      for (int step = 0; step < 6; ++step) {
        const double toi = search.first_impact(x, target);
        const bool free = !(toi <= 1);
        const double length = free ? 1 : 0.8 * toi;
        Positions next = x;
        for (std::size_t i = 0; i < x.size(); ++i) next[i] = x[i] + length * (target[i] - x[i]);
        ++steps;
        if (search.first_impact(x, next) <= 1) ++search.broken;
        x = next;
        if (free) break;
      }
      queries += search.queries;
      broken += search.broken;
    }
  }
  std::printf("%d steps, %d queries, %d broken laws\n", steps, queries, broken);
  return broken == 0 && steps > 6 * seeds ? 0 : 1;
}

// SPDX-License-Identifier: MIT
#include "generators/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <touchstone/error.hpp>

#include "generators/broad_phase.hpp"
#include "generators/random.hpp"

namespace touchstone::generators {
namespace {

void check(const CandidateOptions& options) {
  if (options.edges < kFewestEdges || options.edges > kMostEdges) {
    throw InvalidQuery("a scene of " + std::to_string(options.edges) + " edges; it must have between " +
                       std::to_string(kFewestEdges) + " and " + std::to_string(kMostEdges));
  }
  if (!(options.speed >= 0 && options.speed <= kGreatestSpeed)) {
    throw InvalidQuery("the speed is " + std::to_string(options.speed) + "; it must be in [0, 1000]");
  }
}

/// Where all corners are at both ends of a step, and the boxes around what moves from one to the other.
class Step {
 public:
  Step(const Scene& scene, double speed, Random random)
      : scene_(scene),
        mesh_(scene.mesh()),
        first_time_(random.between(0, 100)),
        duration_(0.1 * speed * scene.edge_length()) {
    scene_.place_corners(first_time_, end_);
  }

  void advance() {
    ++number_;
    std::swap(start_, end_);
    scene_.place_corners(first_time_ + duration_ * static_cast<double>(number_), end_);
  }

  void for_each_candidate(Kind kind, bool shared_corners, const PairConsumer& found) const {
    if (kind == Kind::edge_edge) {
      for_each_overlap(boxes(mesh_.edges), [&](Index i, Index j) {
        const auto &a = mesh_.edges[i], &b = mesh_.edges[j];
        const bool shared = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
        if (shared_corners || !shared) found(i, j);
      });
    } else {
      for_each_overlap(corner_boxes(), boxes(mesh_.faces), [&](Index i, Index j) {
        const auto& f = mesh_.faces[j];
        const bool shared = f[0] == i || f[1] == i || f[2] == i;
        if (shared_corners || !shared) found(i, j);
      });
    }
  }

  Query query(Kind kind, Index i, Index j) const {
    Query query;
    query.kind = kind;
    std::array<Index, 4> corners;
    if (kind == Kind::edge_edge) {
      corners = {mesh_.edges[i][0], mesh_.edges[i][1], mesh_.edges[j][0], mesh_.edges[j][1]};
    } else {
      corners = {i, mesh_.faces[j][0], mesh_.faces[j][1], mesh_.faces[j][2]};
    }
    for (std::size_t k = 0; k < 4; ++k) {
      query.start[k] = start_[corners[k]];
      query.end[k] = end_[corners[k]];
    }
    return query;
  }

 private:
  template <std::size_t N>
  std::vector<Box> boxes(const std::vector<std::array<Index, N>>& elements) const {
    std::vector<Box> all;
    all.reserve(elements.size());
    for (const auto& element : elements) {
      Box box = empty_box();
      for (const Index corner : element) {
        extend(box, start_[corner]);
        extend(box, end_[corner]);
      }
      all.push_back(box);
    }
    return all;
  }

  std::vector<Box> corner_boxes() const {
    std::vector<std::array<Index, 1>> corners;
    for (std::size_t i = 0; i < start_.size(); ++i) corners.push_back({static_cast<Index>(i)});
    return boxes(corners);
  }

  const Scene& scene_;
  const Mesh& mesh_;
  double first_time_;
  double duration_;
  std::size_t number_ = 0;
  std::vector<Vec3> start_, end_;
};

/// Collects queries and hands them out when there are enough.
class Batches {
 public:
  Batches(const std::function<void(const Batch&)>& take, std::size_t step, Kind kind) : take_(take) {
    batch_.step = step;
    batch_.kind = kind;
  }

  void add(const Query& query) {
    batch_.queries.push_back(query);
    if (batch_.queries.size() == kBatchQueries) flush();
  }

  void flush() {
    if (batch_.queries.empty()) return;
    take_(batch_);
    batch_.queries.clear();
  }

 private:
  const std::function<void(const Batch&)>& take_;
  Batch batch_;
};

/// Hands out `wanted` of the step's candidates, each as likely as any other, or all when there are no more than that
/// (a reservoir: the n-th candidate takes the place of an earlier one with probability wanted / n). @returns how many
std::uint64_t hand_out(const Step& step, Batches& batches, Kind kind, bool shared_corners, std::uint64_t wanted,
                       Random random) {
  std::vector<std::array<Index, 2>> drawn;
  std::uint64_t seen = 0;
  step.for_each_candidate(kind, shared_corners, [&](Index i, Index j) {
    ++seen;
    if (drawn.size() < wanted) {
      drawn.push_back({i, j});
    } else if (const std::uint64_t place = random.below(seen); place < wanted) {
      drawn[place] = {i, j};
    }
  });
  for (const auto& [i, j] : drawn) batches.add(step.query(kind, i, j));
  return drawn.size();
}

}  // namespace

CandidateCounts for_each_batch(const CandidateOptions& options, const std::function<void(const Batch&)>& take) {
  check(options);
  const auto scene = make_scene(options.scene, seed_of_part(options.seed, 0), options.edges);
  Step step(*scene, options.speed, Random(seed_of_part(options.seed, 1)));
  CandidateCounts counts;
  const auto hand_out_kind = [&](Kind kind, std::size_t number, std::uint64_t& handed_out) {
    Batches batches(take, number, kind);
    if (options.count == 0) {
      step.for_each_candidate(kind, options.shared_corners, [&](Index i, Index j) {
        batches.add(step.query(kind, i, j));
        ++handed_out;
      });
    } else {
      // What earlier steps could not fill, later ones may.
      const std::uint64_t steps_left = options.steps - number;
      const std::uint64_t wanted = (options.count - handed_out + steps_left - 1) / steps_left;
      const Random random(seed_of_part(options.seed, 2 + 2 * number + (kind == Kind::edge_edge ? 0 : 1)));
      handed_out += hand_out(step, batches, kind, options.shared_corners, wanted, random);
    }
    batches.flush();
  };
  for (std::size_t number = 0; number < options.steps; ++number) {
    step.advance();
    if (options.edge_edge) hand_out_kind(Kind::edge_edge, number, counts.edge_edge);
    if (options.vertex_face) hand_out_kind(Kind::vertex_face, number, counts.vertex_face);
  }
  return counts;
}

std::vector<Query> candidates(const CandidateOptions& options) {
  std::vector<Query> all;
  for_each_batch(options,
                 [&all](const Batch& batch) { all.insert(all.end(), batch.queries.begin(), batch.queries.end()); });
  return all;
}

}  // namespace touchstone::generators

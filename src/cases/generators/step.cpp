// SPDX-License-Identifier: MIT
#include "generators/step.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "seeded/rng.hpp"

namespace touchstone::generators {

Step::Step(SceneName scene, std::uint64_t seed, std::size_t edges, double speed, double separation, Placement placement)
    : moving_(make_moving_mesh(scene, seeded::seed_of_stream(seed, 0), edges, placement)),
      first_time_(seeded::Rng(seeded::seed_of_stream(seed, 1)).uniform(0, 100)),
      duration_(0.1 * speed * moving_->edge_length()),
      margin_(separation == 0 ? 0 : std::max(separation / 2, std::numeric_limits<double>::min())) {
  moving_->set_corners(first_time_, end_);
  start_ = end_;
}

void Step::advance() {
  ++number_;
  std::swap(start_, end_);
  moving_->set_corners(time(), end_);
}

std::optional<Index> Step::plant_crossing() { return moving_->plant_crossing(time(), end_); }

template <std::size_t N>
std::vector<broad_phase::Box> Step::boxes(const std::vector<std::array<Index, N>>& elements) const {
  std::vector<broad_phase::Box> all;
  all.reserve(elements.size());
  for (const auto& element : elements) {
    broad_phase::Box box = broad_phase::empty_box();
    for (const Index corner : element) {
      broad_phase::extend(box, start_[corner]);
      broad_phase::extend(box, end_[corner]);
    }
    broad_phase::grow(box, margin_);
    all.push_back(box);
  }
  return all;
}

std::vector<broad_phase::Box> Step::corner_boxes() const {
  std::vector<std::array<Index, 1>> corners;
  for (std::size_t i = 0; i < start_.size(); ++i) corners.push_back({static_cast<Index>(i)});
  return boxes(corners);
}

void Step::for_each_candidate(Kind kind, bool shared_corners, const broad_phase::PairConsumer& found) const {
  if (kind == Kind::edge_edge) {
    broad_phase::for_each_overlap(boxes(mesh().edges), [&](Index i, Index j) {
      const auto &a = mesh().edges[i], &b = mesh().edges[j];
      const bool shared = a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
      if (shared_corners || !shared) found(i, j);
    });
  } else {
    broad_phase::for_each_overlap(corner_boxes(), boxes(mesh().faces), [&](Index i, Index j) {
      const auto& f = mesh().faces[j];
      const bool shared = f[0] == i || f[1] == i || f[2] == i;
      if (shared_corners || !shared) found(i, j);
    });
  }
}

Query Step::query(Kind kind, Index i, Index j) const {
  Query query;
  query.kind = kind;
  std::array<Index, 4> corners;
  if (kind == Kind::edge_edge) {
    corners = {mesh().edges[i][0], mesh().edges[i][1], mesh().edges[j][0], mesh().edges[j][1]};
  } else {
    corners = {i, mesh().faces[j][0], mesh().faces[j][1], mesh().faces[j][2]};
  }
  for (std::size_t k = 0; k < 4; ++k) {
    query.start[k] = start_[corners[k]];
    query.end[k] = end_[corners[k]];
  }
  return query;
}

}  // namespace touchstone::generators

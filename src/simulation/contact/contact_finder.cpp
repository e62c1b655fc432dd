// SPDX-License-Identifier: MIT
#include "contact/contact_finder.hpp"

#include <algorithm>

namespace touchstone::sim {
namespace {

// In units of the thickness: the margin grows no further in one substep. Each doubling makes eight times as many pairs.
constexpr double kMostGrowth = 4;

// Fraction of the margin: a particle has room while it is within this distance of its end when pairs were collected.
// The rest is for rounding, which cannot let it leave its box then.
constexpr double kRoom = 0.999;

}  // namespace

void ContactFinder::begin(const VectorX& x0, const VectorX& x1, double margin) {
  x0_ = &x0;
  margin_ = margin;
  most_margin_ = kMostGrowth * margin;
  collect(x1);
}

void ContactFinder::collect(const VectorX& x1) {
  cancel_->check();
  pairs_ = colliders_->candidates(*x0_, x1, margin_);
  asked_.assign(pairs_.size(), 0);
  collected_ = x1;
}

std::vector<Contact> ContactFinder::close(double thickness) const {
  std::vector<Contact> all;
  Contact contact;
  for (const Pair& pair : pairs_) {
    if (proximity(*colliders_, pair, *x0_, thickness, contact)) all.push_back(contact);
  }
  return all;
}

void ContactFinder::find(const VectorX& x1, std::vector<Contact>& found, ResponseCounts& counts) {
  found.clear();
  // Block by block: there are many pairs, and the open ones need not be copied all at once.
  constexpr std::size_t kBlock = 4096;
  std::vector<Pair> open;
  std::vector<std::size_t> indices;
  const auto ask = [&] {
    const LevelCounts levels = solver_.contacts(open, {x0_, &x1}, [&](std::size_t i, const Answer& answer) {
      const bool planar = open[i].kind == Kind::point_edge || open[i].kind == Kind::point_point;
      found.push_back(contact_of(*colliders_, open[i], *x0_, x1, answer, planar || solver_.exact()));
      ++counts.natures[static_cast<std::size_t>(answer.nature)];
      asked_[indices[i]] = 0;  // until it is known to be gone
    });
    counts.queries += open.size();
    count(levels, counts.levels);
    open.clear();
    indices.clear();
  };
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (asked_[i]) continue;
    asked_[i] = 1;
    open.push_back(pairs_[i]);
    indices.push_back(i);
    if (open.size() == kBlock) ask();
  }
  ask();
  counts.contacts += found.size();
  // toi is the largest double that is not later than the exact time, so equal ones are as good as simultaneous.
  std::stable_sort(found.begin(), found.end(), [](const Contact& a, const Contact& b) { return a.time < b.time; });
}

bool ContactFinder::has_room(const VectorX& x1, Index particle) const {
  return ((position(x1, particle) - position(collected_, particle)).array().abs() <= kRoom * margin_).all();
}

void ContactFinder::moved(const VectorX& x1, const std::vector<char>& particles) {
  for (Index p = 0; p < particles.size(); ++p) {
    if (!particles[p] || has_room(x1, p)) continue;
    // A particle that moved once will move again.
    margin_ = std::min(2 * margin_, most_margin_);
    collect(x1);
    return;
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const auto corners = colliders_->corners(pairs_[i]);
    for (std::size_t c = 0; c < corner_count(pairs_[i].kind); ++c) {
      if (particles[corners[c]]) asked_[i] = 0;
    }
  }
}

}  // namespace touchstone::sim

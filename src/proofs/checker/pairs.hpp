// The pairs of a motion's steps for touchstone-check, and how far apart their elements are to be.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/motion.hpp"

namespace checker {

/// A kind of pairs. A fold is that of a wire: a point, and a wire that is joined to it by another one.
struct PairKind : Kind {
  bool is_fold = false;
};

/// A motion file, and the pairs of its current step.
class MotionPairs : public MotionFile {
 public:
  using MotionFile::MotionFile;

  /// Calls the function for each pair of the step, in the order of the proofs: with its kind, the first element, the
  /// second one, and their separation.
  template <class Function>
  void for_each_pair(const Separation& of_file, const Function& function) {
    set_ends();
    Number largest = of_file.distance;  // of the separations
    for (const Radius& radius : radii_) {
      const Number twice = rounded_up(radius.length + radius.length);
      if (compare(twice, largest) > 0) largest = twice;
    }
    for (std::size_t k = 0; k < 3; ++k) set_boxes(k, largest);
    const Separation none;
    for_each_sort([&](const PairKind& kind, const auto& first, const auto& second) {
      for_each_of(kind, first, second, [&](const PairKind&, const Element& a, const Element& b) {
        if (!has_radii()) return function(kind, a, b, only_touches(kind, a, b) ? none : of_file);
        const Separation separation = separation_of(kind, a, b);
        if (are_boxes_near(a, b, separation.distance)) function(kind, a, b, separation);
      });
    });
  }

  /// Whether two elements could meet in a step at all, however far apart they are: the rules leave a pair.
  bool has_pair() const {
    bool found = false;
    for_each_sort([&](const PairKind& kind, const auto& first, const auto& second) {
      const auto all = [&](const auto& holds) {
        return std::all_of(first.begin(), first.end(), holds) && std::all_of(second.begin(), second.end(), holds);
      };
      // Without a look at each pair: nothing moves, or nothing but one body.
      if (found || first.empty() || all([](const Element& e) { return e.is_fixed; })) return;
      const std::uint32_t body = first[0].body;
      if (body != kNoBody && all([&](const Element& e) { return e.body == body; })) return;
      const std::vector<Element> moving = moving_of(second);
      std::set<std::uint32_t> groups;
      for (const Element& b : second) groups.insert(b.groups.begin(), b.groups.begin() + static_cast<long>(b.size));
      std::map<std::uint32_t, bool> known;  // whether a group is asked about with one of these
      const auto has_partner = [&](std::uint32_t group) {
        const auto [entry, is_new] = known.emplace(group, false);
        const auto is_asked = [&](std::uint32_t h) { return ignored_.count(side(group, h)) == 0; };
        if (is_new) entry->second = std::any_of(groups.begin(), groups.end(), is_asked);
        return entry->second;
      };
      found = std::any_of(first.begin(), first.end(), [&](const Element& a) {
        if (std::none_of(a.groups.begin(), a.groups.begin() + static_cast<long>(a.size), has_partner)) return false;
        const std::vector<Element>& partners = a.is_fixed ? moving : second;
        return std::any_of(partners.begin(), partners.end(), [&](const Element& b) { return may_meet(kind, a, b); });
      });
    });
    return found;
  }

 private:
  /// Whether a line `near` names a vertex of each.
  bool are_near(const Element& a, const Element& b) const {
    for (std::size_t i = 0; i < a.size; ++i) {
      for (std::size_t j = 0; j < b.size; ++j) {
        if (near_.count(side(a.vertices[i], b.vertices[j])) > 0) return true;
      }
    }
    return false;
  }
  /// Whether the separation is zero: for folds, and by a line `touching`.
  bool only_touches(const PairKind& kind, const Element& a, const Element& b) const {
    return kind.is_fold || touching_.count({a.size, b.size, a.number, b.number}) > 0;
  }
  /// The sum of the radii, rounded up to a double; zero for those that only touch, and for neighbours.
  Separation separation_of(const PairKind& kind, const Element& a, const Element& b) const {
    Separation separation;
    if (only_touches(kind, a, b) || are_near(a, b)) return separation;
    separation.distance = rounded_up(radii_[a.radius].length + radii_[b.radius].length);
    if (sign(separation.distance) > 0) separation.metric = Metric::euclidean;
    return separation;
  }

  /// Sets the ends of the boxes of vertices, which are those of their motion. That of a body's vertex is a mean of the
  /// quotients of the Bernstein coefficients of x and w, if those of w are positive. These are rounded outwards.
  void set_ends() {
    if (body_count_ > 0) ends_ = frames_;
    const Interval whole({0, 0}, {1, 0});
    for (const Element& vertex : elements_[4]) {
      set(query_, {"", 1, 1}, vertex, vertex);
      const mpz_class unit = set_corners(corners_, query_, {});
      corners_.w[0].resize(4);  // as many as x has
      const Polynomial w = bernstein(corners_.w[0], whole);
      for (std::size_t k = 0, index = index_of(vertex.vertices[0]); k < 3; ++k, ++index) {
        const Polynomial x = bernstein(corners_.x[0][k], whole);
        std::size_t least = 0, greatest = 0;
        for (std::size_t c = 0; c < 4; ++c) {
          lines_.require(w[c] > 0, "a body turns too far in the step that ends before this line");
          if (x[c] * w[least] < x[least] * w[c]) least = c;
          if (x[c] * w[greatest] > x[greatest] * w[c]) greatest = c;
        }
        mpz_class rest;
        ends_[0][index] = rounded_down(x[least], w[least] * unit, rest);
        Number& end = ends_[1][index] = rounded_down(-x[greatest], w[greatest] * unit, rest);
        end.m = -end.m;
      }
    }
  }

  /// The coordinate of an end of a vertex's box. Those of the first ends come before those of the second ones.
  const Number& end_of(std::size_t i, std::size_t k) const {
    return (body_count_ > 0 ? ends_ : frames_)[i / count_][index_of(i % count_) + k];
  }
  /// Whether the boxes of two elements are at most a distance apart along each axis.
  bool are_boxes_near(const Element& a, const Element& b, const Number& distance) const {
    const auto bound = [&](const Element& e, std::size_t k, int side) {  // the greatest one for the side 1
      const Number* found = &end_of(e.vertices[0], k);
      for (std::size_t i = 1; i < 2 * e.size; ++i) {
        const Number& end = end_of(e.vertices[i / 2] + (i % 2) * std::size_t{count_}, k);
        if (compare(end, *found) * side > 0) found = &end;
      }
      return *found;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      if (compare(bound(a, k, -1), bound(b, k, 1) + distance) > 0) return false;
      if (compare(bound(b, k, -1), bound(a, k, 1) + distance) > 0) return false;
    }
    return true;
  }

  /// Sets the boxes along one axis.
  void set_boxes(std::size_t k, const Number& distance) {
    const auto at = [&](std::size_t i) -> const Number& { return end_of(i, k); };
    std::vector<std::uint32_t> order(2 * std::size_t{count_}), rank(order.size()), reach(order.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return compare(at(a), at(b)) < 0; });
    for (std::uint32_t i = 0, end = 0; i < order.size(); ++i) {
      const Number farthest = at(order[i]) + distance;
      while (end < order.size() && compare(at(order[end]), farthest) <= 0) ++end;
      rank[order[i]] = i;
      reach[order[i]] = end;
    }
    for (std::vector<Element>& elements : elements_) {
      for (Element& element : elements) {
        element.low[k] = std::numeric_limits<std::uint32_t>::max();
        element.reach[k] = 0;
        for (std::size_t i = 0; i < 2 * element.size; ++i) {
          const std::size_t v = element.vertices[i / 2] + (i % 2) * std::size_t{count_};
          element.low[k] = std::min(element.low[k], rank[v]);
          element.reach[k] = std::max(element.reach[k], reach[v]);
        }
      }
    }
  }

  /// Calls the function for each sort of pairs, in the order of the proofs: its kind, first and second elements.
  template <class Function>
  void for_each_sort(const Function& function) const {
    const auto& [points, edges, faces, fixed, on_bodies, lone, ends, wires] = elements_;
    function(PairKind{kKinds[0]}, edges, edges);
    function(PairKind{kKinds[1]}, points, faces);
    function(PairKind{kKinds[2]}, lone, edges);
    function(PairKind{kKinds[3]}, lone, lone);
    function(PairKind{kKinds[2], true}, ends, wires);
  }

  static std::vector<Element> moving_of(const std::vector<Element>& elements) {
    std::vector<Element> moving;
    std::copy_if(elements.begin(), elements.end(), std::back_inserter(moving),
                 [](const Element& e) { return !e.is_fixed; });
    return moving;
  }

  /// Elements in the order of the low ends of their boxes along an axis.
  struct Row {
    std::vector<Element> elements;
    std::vector<std::uint32_t> farthest;  ///< the greatest reach of a box and those before it
    Row(std::vector<Element> all, std::size_t axis) : elements(std::move(all)) {
      std::sort(elements.begin(), elements.end(),
                [&](const Element& a, const Element& b) { return a.low[axis] < b.low[axis]; });
      for (const Element& b : elements) {
        farthest.push_back(std::max(b.reach[axis], farthest.empty() ? 0 : farthest.back()));
      }
    }
  };

  /// It holds the partners of one element at a time, not all pairs.
  template <class Function>
  void for_each_of(const PairKind& kind, const std::vector<Element>& first, const std::vector<Element>& second,
                   const Function& function) {
    // The boxes in the order of their low ends, along the axis on which they are narrowest.
    std::array<std::uint64_t, 3> width{};
    for (const Element& b : second) {
      for (std::size_t k = 0; k < 3; ++k) width[k] += b.reach[k] - b.low[k];
    }
    const auto axis = static_cast<std::size_t>(std::min_element(width.begin(), width.end()) - width.begin());
    const Row all(second, axis), moving(moving_of(second), axis);
    for (const Element& a : first) {
      const auto& [row, farthest] = a.is_fixed ? moving : all;  // many may be fixed in one place
      std::vector<const Element*> partners;
      // The boxes before this one end below a, and those behind the last one of the loop begin above it.
      const auto begin = std::upper_bound(farthest.begin(), farthest.end(), a.low[axis]) - farthest.begin();
      for (auto i = static_cast<std::size_t>(begin); i < row.size() && row[i].low[axis] < a.reach[axis]; ++i) {
        if (is_pair(kind, a, row[i]) && (&first != &second || a.number < row[i].number)) partners.push_back(&row[i]);
      }
      std::sort(partners.begin(), partners.end(), [](const auto* x, const auto* y) { return x->number < y->number; });
      for (const Element* b : partners) function(kind, a, *b);
    }
  }

  /// Whether the boxes are near, and the rules leave the pair.
  bool is_pair(const PairKind& kind, const Element& a, const Element& b) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.low[k] >= b.reach[k] || b.low[k] >= a.reach[k]) return false;
    }
    return may_meet(kind, a, b);
  }
  bool may_meet(const PairKind& kind, const Element& a, const Element& b) const {
    for (std::size_t i = 0; i < a.size; ++i) {
      for (std::size_t j = 0; j < b.size; ++j) {
        if (a.vertices[i] == b.vertices[j]) return false;
      }
    }
    if (kind.is_fold && !are_joined(a.vertices[0], b.vertices[0]) && !are_joined(a.vertices[0], b.vertices[1])) {
      return false;
    }
    return !(a.is_fixed && b.is_fixed) && (a.body == kNoBody || a.body != b.body) && is_asked(a, b);
  }
  /// Whether some group of one element is not ignored with some group of the other one.
  bool is_asked(const Element& a, const Element& b) const {
    if (ignored_.empty()) return true;
    for (std::size_t i = 0; i < a.size; ++i) {
      for (std::size_t j = 0; j < b.size; ++j) {
        if (ignored_.count(side(a.groups[i], b.groups[j])) == 0) return true;
      }
    }
    return false;
  }

  Query query_;
  Corners corners_;
};

}  // namespace checker

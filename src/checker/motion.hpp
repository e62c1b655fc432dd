// Motion files for touchstone-check, and the pairs of their steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <unordered_set>

#include "checker/queries.hpp"

namespace checker {

/// A point, an edge or a face, and its box during a step. Along each axis, the coordinates of all vertices at both ends
/// of the step are sorted. `low` is the place of the box's least coordinate, and `reach` the number of the coordinates
/// that are at most D above its greatest one. Boxes a and b are at most D apart if a.low < b.reach and b.low < a.reach.
struct Element {
  std::array<std::uint32_t, 3> vertices{}, low{}, reach{};
  std::size_t size = 0;
  std::size_t number = 0;  ///< among those of its sort
};

/// A mesh, and the two frames of a step.
class MotionFile {
 public:
  static constexpr std::array<std::string_view, 4> kSorts = {"point", "edge", "face", "fixed"};
  static constexpr std::array<std::size_t, 4> kSizes = {1, 2, 3, 1};

  explicit MotionFile(const std::string& name) : lines_(name) {
    lines_.next(words_);
    if (words_ != Words{"touchstone-motion", "1"}) throw expected("\"touchstone-motion 1\"");
    lines_.next(words_);
    if (words_.size() != 2 || words_[0] != "vertices" || !read_count(words_[1], kMostVertices, count_)) {
      throw expected("\"vertices N\" with N below 2^30");
    }
    while (lines_.next(words_) && words_[0] != "frame") read_element();
    if (!next_step()) throw expected("the line \"frame\" of frame 0");
    // There are as many lines as vertices, so memory for each vertex is in proportion to the file.
    is_fixed_.assign(count_, false);
    for (const Element& vertex : elements_[3]) is_fixed_[vertex.vertices[0]] = true;
    std::vector<bool> on_edge(count_, false);
    for (const Element& edge : elements_[1]) on_edge[edge.vertices[0]] = on_edge[edge.vertices[1]] = true;
    for (const Element& point : elements_[0]) {
      if (!on_edge[point.vertices[0]]) elements_[4].push_back(point);
    }
    if (!next_step()) throw expected("the line \"frame\" of frame 1: a motion has at least two frames");
  }

  static std::string name(const Element& element) {
    return std::string(kSorts[element.size - 1]) + " " + std::to_string(element.number);
  }

  /// Reads a frame, whose line "frame" is the current one, and the line after it. @returns false if there is none
  bool next_step() {
    frames_[0].swap(frames_[1]);
    frames_[1].clear();
    if (words_.empty()) return false;
    if (words_ != Words{"frame"}) throw expected("\"frame\" alone, or the end of the file");
    for (std::uint32_t v = 0; v < count_; ++v) {
      lines_.next(words_);
      if (words_.size() != 3) {
        throw expected("the three coordinates of vertex " + std::to_string(v) + " in frame " + std::to_string(frame_));
      }
      for (const std::string_view word : words_) {
        read_number(word, frames_[1].emplace_back(), lines_);
        if (frame_ > 0 && is_fixed_[v] && compare(frames_[0][frames_[1].size() - 1], frames_[1].back()) != 0) {
          throw lines_.bad("vertex " + std::to_string(v) + " is fixed, but has moved in frame " +
                           std::to_string(frame_) + ": the coordinates of the frame before were expected");
        }
      }
    }
    ++frame_;
    lines_.next(words_);
    return true;
  }

  /// Calls function(kind, first element, second element) for each pair of the step, in the order of the proofs.
  template <class Function>
  void for_each_pair(const Number& distance, const Function& function) {
    for (std::size_t k = 0; k < 3; ++k) set_boxes(k, distance);
    const auto& [points, edges, faces, fixed, lone] = elements_;
    for_each_of(kKinds[0], edges, edges, function);
    for_each_of(kKinds[1], points, faces, function);
    for_each_of(kKinds[2], lone, edges, function);
    for_each_of(kKinds[3], lone, lone, function);
  }

  /// Sets the query of a pair: the corners of the first element, then those of the second one.
  void set(Query& query, const Kind& kind, const Element& a, const Element& b) const {
    query.kind = kind;
    for (std::size_t i = 0; i < kind.corners; ++i) {
      const std::size_t vertex = i < a.size ? a.vertices[i] : b.vertices[i - a.size];
      for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t k = 0; k < 3; ++k) {
          query.corners[i].points[end][k] = fraction_of(frames_[end][3 * vertex + k]);
        }
      }
    }
  }

 private:
  BadInput expected(const std::string& what) const { return lines_.bad("here must be " + what); }

  void read_element() {
    const auto sort = static_cast<std::size_t>(std::find(kSorts.begin(), kSorts.end(), words_[0]) - kSorts.begin());
    if (sort == kSorts.size() || words_.size() != kSizes[sort] + 1) {
      throw expected("\"point V\", \"edge V0 V1\", \"face V0 V1 V2\", \"fixed V\" or \"frame\"");
    }
    Element element;
    element.number = elements_[sort].size();
    for (; element.size < kSizes[sort]; ++element.size) {
      const std::string_view word = words_[element.size + 1];
      std::uint32_t v = 0;
      if (!read_count(word, kMostVertices, v) || v >= count_) {
        throw lines_.bad(quoted(word) + " is no vertex: a number below " + std::to_string(count_) +
                         " was expected, without a sign or leading zeros");
      }
      const auto end = element.vertices.begin() + static_cast<long>(element.size);
      lines_.require(std::find(element.vertices.begin(), end, v) == end,
                     "an element has different vertices, but this one has a vertex twice");
      element.vertices[element.size] = v;
    }
    lines_.require(element.size > 1 || single_[sort].insert(element.vertices[0]).second,
                   sort == 0 ? "the vertex is a point already: one line was expected"
                             : "the vertex is fixed already: one line was expected");
    elements_[sort].push_back(element);
  }

  /// Sets the boxes along one axis.
  void set_boxes(std::size_t k, const Number& distance) {
    const auto at = [&](std::size_t i) -> const Number& {  // of a vertex at the start, or at the end
      return frames_[i / count_][3 * (i % count_) + k];
    };
    std::vector<std::uint32_t> order(2 * std::size_t{count_}), place(order.size()), reach(order.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return compare(at(a), at(b)) < 0; });
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Number farthest = at(order[i]) + distance;
      while (end < order.size() && compare(at(order[end]), farthest) <= 0) ++end;
      place[order[i]] = static_cast<std::uint32_t>(i);
      reach[order[i]] = end;
    }
    for (std::vector<Element>& elements : elements_) {
      for (Element& element : elements) {
        element.low[k] = std::numeric_limits<std::uint32_t>::max();
        element.reach[k] = 0;
        for (std::size_t i = 0; i < 2 * element.size; ++i) {
          const std::size_t v = element.vertices[i / 2] + (i % 2) * std::size_t{count_};
          element.low[k] = std::min(element.low[k], place[v]);
          element.reach[k] = std::max(element.reach[k], reach[v]);
        }
      }
    }
  }

  /// It holds the partners of one element at a time, not all pairs.
  template <class Function>
  void for_each_of(const Kind& kind, const std::vector<Element>& first, const std::vector<Element>& second,
                   const Function& function) {
    // The boxes in the order of their low ends, along the axis on which they are narrowest.
    std::array<std::uint64_t, 3> width{};
    for (const Element& b : second) {
      for (std::size_t k = 0; k < 3; ++k) width[k] += b.reach[k] - b.low[k];
    }
    const auto axis = static_cast<std::size_t>(std::min_element(width.begin(), width.end()) - width.begin());
    std::vector<Element> row = second;
    std::sort(row.begin(), row.end(), [&](const Element& a, const Element& b) { return a.low[axis] < b.low[axis]; });
    std::vector<std::uint32_t> farthest;  // the greatest reach of a box and those before it
    for (const Element& b : row) farthest.push_back(std::max(b.reach[axis], farthest.empty() ? 0 : farthest.back()));
    std::vector<const Element*> partners;
    for (const Element& a : first) {
      partners.clear();
      // The boxes before this one end below a, and those behind the last one of the loop begin above it.
      const auto begin = std::upper_bound(farthest.begin(), farthest.end(), a.low[axis]) - farthest.begin();
      for (auto i = static_cast<std::size_t>(begin); i < row.size() && row[i].low[axis] < a.reach[axis]; ++i) {
        if (is_pair(a, row[i]) && (&first != &second || a.number < row[i].number)) partners.push_back(&row[i]);
      }
      std::sort(partners.begin(), partners.end(), [](const auto* x, const auto* y) { return x->number < y->number; });
      for (const Element* b : partners) function(kind, a, *b);
    }
  }

  bool is_pair(const Element& a, const Element& b) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.low[k] >= b.reach[k] || b.low[k] >= a.reach[k]) return false;
    }
    bool all_fixed = true;
    for (std::size_t i = 0; i < a.size; ++i) {
      for (std::size_t j = 0; j < b.size; ++j) {
        if (a.vertices[i] == b.vertices[j]) return false;
        all_fixed = all_fixed && is_fixed_[a.vertices[i]] && is_fixed_[b.vertices[j]];
      }
    }
    return !all_fixed;
  }

  Lines lines_;
  Words words_;
  std::uint32_t count_ = 0;
  std::size_t frame_ = 0;
  std::array<std::vector<Number>, 2> frames_;  ///< three coordinates for each vertex, at the start and at the end
  std::vector<bool> is_fixed_;                 ///< of each vertex
  /// Points, edges, faces, vertices that are fixed, and points that are corners of no edge.
  std::array<std::vector<Element>, 5> elements_;
  std::array<std::unordered_set<std::uint32_t>, 4> single_;  ///< the vertices that are points, and that are fixed
};

}  // namespace checker

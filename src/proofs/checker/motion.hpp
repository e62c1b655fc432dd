// Motion files for touchstone-check, and the pairs of their steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "checker/curved_motion.hpp"
#include "checker/mesh_files.hpp"

namespace checker {

constexpr std::uint32_t kNoBody = kMostVertices;

/// A point, an edge or a face, and its box during a step. Along each axis, the ends of the boxes of all vertices are
/// sorted. `low` is the rank of the box's least coordinate, and `reach` the number of the ends that are at most D
/// above its greatest one. Boxes a and b are at most D apart if a.low < b.reach and b.low < a.reach.
struct Element {
  std::array<std::uint32_t, 3> vertices{}, low{}, reach{};
  std::size_t size = 0, number = 0;  ///< of vertices; among the elements of its sort
  bool is_fixed = false;             ///< all of its vertices are
  std::uint32_t body = kNoBody;      ///< that all of its vertices are on
};

/// A kind of pairs. A fold is that of a wire: a point, and a wire that is joined to it by another one.
struct PairKind : Kind {
  bool is_fold = false;
};

/// A mesh, and the two frames of a step.
class MotionFile {
 public:
  static constexpr std::array<std::string_view, 5> kSorts = {"point", "edge", "face", "fixed", "body"};
  static constexpr std::array<std::size_t, 5> kSizes = {1, 2, 3, 1, 1}, kWords = {2, 3, 4, 2, 6};
  static constexpr std::size_t kPose = 7;  ///< numbers: a quaternion and a position

  explicit MotionFile(const std::string& name) : lines_(name) {
    lines_.next(words_);
    if (words_ != Words{"touchstone-motion", "1"}) throw expected("\"touchstone-motion 1\"");
    lines_.next(words_);
    if (words_.size() != 2 || words_[0] != "vertices" || !read_count(words_[1], kMostVertices, count_)) {
      throw expected("\"vertices N\" with N below 2^30");
    }
    while (lines_.next(words_) && words_[0] != "frame") read_element();
    set_attachments();
    find_wires();
    std::set<std::uint32_t> on_edge, on_wire;
    for (const Element& edge : elements_[1]) on_edge.insert({edge.vertices[0], edge.vertices[1]});
    for (const Element& wire : elements_[7]) on_wire.insert({wire.vertices[0], wire.vertices[1]});
    for (const Element& point : elements_[0]) {
      if (on_edge.count(point.vertices[0]) == 0) elements_[5].push_back(point);
      if (on_wire.count(point.vertices[0]) > 0) elements_[6].push_back(point);
    }
    for (const Element& vertex : elements_[3]) still_.insert(body_of(vertex.vertices[0]));
    if (!next_step()) throw expected("the line \"frame\" of frame 0");
    if (!next_step()) throw expected("the line \"frame\" of frame 1: a motion has at least two frames");
  }

  static std::string name(const Element& element) {
    return std::string(kSorts[element.size - 1]) + " " + std::to_string(element.number);
  }

  Lines& lines() { return lines_; }
  std::size_t frame_count() const { return frame_; }  ///< those that were read

  /// @param end  0 for the first frame of the step, 1 for the second one
  /// @throws Rejected unless that frame is this file, bit by bit, with all of its triangles, lines and points, and their sides
  /// and corners, among the elements
  void compare_frame(const std::string& file, std::size_t end) const {
    const std::string what = file + " and frame " + std::to_string(frame_ - 2 + end) + ": ";
    const auto require = [&](bool holds, const std::string& reason) {
      if (!holds) throw Rejected(what + reason);
    };
    const MeshFile mesh = read_mesh(file);
    require(body_count_ == 0, "a motion with bodies has poses; --frames compares vertices");
    require(mesh.positions.size() == 3 * std::size_t{count_},
            std::to_string(mesh.positions.size() / 3) + " vertices, and " + std::to_string(count_));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      require(compare(mesh.positions[i], frames_[end][i]) == 0,
              "the coordinates of vertex " + std::to_string(i / 3) + ", counted from 0, differ");
    }
    const auto sorted = [](std::array<std::uint32_t, 3> face) {
      std::sort(face.begin(), face.end());
      return face;
    };
    std::set<std::array<std::uint32_t, 3>> faces;
    for (const Element& face : elements_[2]) faces.insert(sorted(face.vertices));
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      require(faces.count(sorted(mesh.faces[i])) > 0,
              "face " + std::to_string(i) + " of the file, counted from 0, is none of the motion");
    }
    std::set<std::array<std::uint32_t, 2>> edges;
    for (const Element& edge : elements_[1]) edges.insert(side(edge.vertices[0], edge.vertices[1]));
    for (const auto& [v, w] : mesh.edges) {
      require(edges.count(side(v, w)) > 0, "a line of the file is no edge of the motion");
    }
    for (const std::uint32_t v : mesh.points)
      require(single_[0].count(v) > 0, "a point of the file is none of the motion");
    const auto [corners, sides] = undeclared();
    require(corners == 0, counted(corners, "corner is no point", "corners are no points"));
    require(sides == 0, counted(sides, "side is no edge", "sides are no edges"));
  }

  /// Reads a frame, whose line "frame" is the current one, and the line after it. @returns false if there is none
  bool next_step() {
    frames_[0].swap(frames_[1]);
    frames_[1].clear();
    if (words_.empty()) return false;
    if (words_ != Words{"frame"}) throw expected("\"frame\" alone, or the end of the file");
    lines_.next(words_);
    for (std::uint32_t b = 0; b < body_count_; ++b) read_row(kPose, "body ", b, still_.count(b) > 0);
    for (std::uint32_t v = 0; v < count_; ++v) {
      if (body_of(v) == kNoBody) {
        read_row(3, "vertex ", v, is_fixed(v));
      } else {
        for (const Number& x : on_bodies_.at(v).second) frames_[1].push_back(x);
      }
    }
    ++frame_;
    return true;
  }

  /// Calls function(kind, first element, second element) for each pair of the step, in the order of the proofs.
  template <class Function>
  void for_each_pair(const Number& distance, const Function& function) {
    set_ends();
    for (std::size_t k = 0; k < 3; ++k) set_boxes(k, distance);
    for_each_sort([&](const PairKind& kind, const auto& first, const auto& second) {
      for_each_of(kind, first, second, function);
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
      found = std::any_of(first.begin(), first.end(), [&](const Element& a) {
        const std::vector<Element>& partners = a.is_fixed ? moving : second;
        return std::any_of(partners.begin(), partners.end(), [&](const Element& b) { return may_meet(kind, a, b); });
      });
    });
    return found;
  }

  /// "7 frames, 121 vertices, 121 points, 320 edges, 200 faces": what the proofs are about, as a person must see.
  std::string contents() const {
    std::string text = counted(frame_, "frame", "frames") + ", " + counted(count_, "vertex", "vertices");
    for (std::size_t sort = 0; sort < 3; ++sort) {
      const std::string one(kSorts[sort]);
      text += ", " + counted(elements_[sort].size(), one, one + "s");
    }
    if (!elements_[3].empty()) text += ", " + counted(elements_[3].size(), "fixed vertex", "fixed vertices");
    if (body_count_ > 0) {
      text +=
          ", " + counted(elements_[4].size(), "vertex", "vertices") + " on " + counted(body_count_, "body", "bodies");
    }
    const auto [corners, sides] = undeclared();
    if (corners > 0) text += ", " + counted(corners, "corner is no point", "corners are no points");
    if (sides > 0) text += ", " + counted(sides, "side is no edge", "sides are no edges");
    return text;
  }

  /// Sets the query of a pair: the corners of the first element, then those of the second one.
  void set(Query& query, const Kind& kind, const Element& a, const Element& b) const {
    query.kind = kind;
    std::array<std::uint32_t, 4> bodies{};
    for (std::size_t i = 0; i < kind.corners; ++i) {
      const std::uint32_t vertex = i < a.size ? a.vertices[i] : b.vertices[i - a.size];
      Corner& corner = query.corners[i];
      bodies[i] = body_of(vertex);
      const bool on_body = bodies[i] != kNoBody;
      const auto first = static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), bodies[i]) - bodies.begin());
      Motion& motion = query.motions[first];
      corner.size = on_body ? 1 : 2;
      corner.motion = on_body ? first : Corner::kOnCurve;
      for (std::size_t end = 0; end < 2; ++end) {
        const auto at = [&](std::size_t n) { return fraction_of(frames_[end][n]); };
        for (std::size_t k = 0; k < 3; ++k) corner.points[end][k] = at(index_of(vertex) + k);
        for (std::size_t c = 0; on_body && c < 4; ++c) motion.q[end][c] = at(kPose * bodies[i] + c);
        for (std::size_t k = 0; on_body && k < 3; ++k) motion.p[end][k] = at(kPose * bodies[i] + 4 + k);
      }
    }
  }

 private:
  BadInput expected(const std::string& what) const { return lines_.bad("here must be " + what); }

  void read_element() {
    const auto sort = static_cast<std::size_t>(std::find(kSorts.begin(), kSorts.end(), words_[0]) - kSorts.begin());
    if (sort == kSorts.size() || words_.size() != kWords[sort]) {
      throw expected(R"("point V", "edge V0 V1", "face V0 V1 V2", "fixed V", "body V B X Y Z" or "frame")");
    }
    Element element;
    element.number = elements_[sort].size();
    for (; element.size < kSizes[sort]; ++element.size) {
      const std::string_view word = words_[element.size + 1];
      std::uint32_t v = 0;
      if (!read_count(word, kMostVertices, v) || v >= count_)
        throw lines_.bad(quoted(word) + " is no vertex, such as 0 or 12, below " + std::to_string(count_));
      const auto end = element.vertices.begin() + static_cast<long>(element.size);
      lines_.require(std::find(element.vertices.begin(), end, v) == end,
                     "an element has different vertices, but this one has a vertex twice");
      element.vertices[element.size] = v;
    }
    lines_.require(element.size > 1 || single_[sort].insert(element.vertices[0]).second,
                   "the vertex has such a line already: one was expected");
    elements_[sort].push_back(element);
    if (kSorts[sort] != "body") return;
    auto& [body, point] = on_bodies_[element.vertices[0]];
    if (!read_count(words_[2], kNoBody - 1, body)) throw expected("the number of a body, below 2^30 - 1");
    for (std::size_t k = 0; k < 3; ++k) read_number(words_[3 + k], point[k], lines_);
    body_count_ = std::max(body_count_, body + 1);
  }

  /// Reads the numbers of a body or of a vertex in the frame, and the line after them.
  void read_row(std::size_t size, const char* of, std::uint32_t number, bool is_fixed) {
    const auto name = [&] { return of + std::to_string(number) + " in frame " + std::to_string(frame_); };
    if (words_.size() != size) throw expected("the " + std::to_string(size) + " numbers of " + name());
    for (const std::string_view word : words_) {
      read_number(word, frames_[1].emplace_back(), lines_);
      if (frame_ > 0 && is_fixed && compare(frames_[0][frames_[1].size() - 1], frames_[1].back()) != 0) {
        throw lines_.bad(name() + " is fixed, but has moved: the numbers of the frame before were expected");
      }
    }
    lines_.next(words_);
  }

  /// Sets whether the elements are fixed, and the bodies that they are on.
  void set_attachments() {
    for (std::vector<Element>& elements : elements_) {
      for (Element& e : elements) {
        const auto end = e.vertices.begin() + static_cast<long>(e.size);
        e.is_fixed = std::all_of(e.vertices.begin(), end, [&](std::uint32_t v) { return is_fixed(v); });
        e.body = body_of(e.vertices[0]);
        if (std::any_of(e.vertices.begin(), end, [&](std::uint32_t v) { return body_of(v) != e.body; }))
          e.body = kNoBody;
      }
    }
  }

  /// The numbers of corners of edges and faces that have no line of their own, and of sides of faces likewise.
  std::array<std::size_t, 2> undeclared() const {
    std::set<std::uint32_t> corners;
    std::set<std::array<std::uint32_t, 2>> sides;
    for (const std::size_t sort : {1, 2}) {
      for (const Element& e : elements_[sort]) {
        for (std::size_t k = 0; k < e.size; ++k) {
          if (single_[0].count(e.vertices[k]) == 0) corners.insert(e.vertices[k]);
          if (sort == 2) sides.insert(side(e.vertices[k], e.vertices[(k + 1) % 3]));
        }
      }
    }
    for (const Element& edge : elements_[1]) sides.erase(side(edge.vertices[0], edge.vertices[1]));
    return {corners.size(), sides.size()};
  }

  static std::array<std::uint32_t, 2> side(std::uint32_t v, std::uint32_t w) {
    return {std::min(v, w), std::max(v, w)};
  }

  /// Sets the edges that are no sides of faces, and the pairs of vertices that they join.
  void find_wires() {
    std::vector<std::array<std::uint32_t, 2>> sides;
    for (const Element& face : elements_[2]) {
      for (std::size_t k = 0; k < 3; ++k) sides.push_back(side(face.vertices[k], face.vertices[(k + 1) % 3]));
    }
    std::sort(sides.begin(), sides.end());
    for (const Element& edge : elements_[1]) {
      const auto ends = side(edge.vertices[0], edge.vertices[1]);
      if (std::binary_search(sides.begin(), sides.end(), ends)) continue;
      elements_[7].push_back(edge);
      joined_.push_back(ends);
    }
    std::sort(joined_.begin(), joined_.end());
  }
  bool are_joined(std::uint32_t v, std::uint32_t w) const {
    return std::binary_search(joined_.begin(), joined_.end(), side(v, w));
  }

  std::uint32_t body_of(std::uint32_t vertex) const {
    const auto found = on_bodies_.find(vertex);
    return found == on_bodies_.end() ? kNoBody : found->second.first;
  }
  bool is_fixed(std::uint32_t vertex) const { return single_[3].count(vertex) > 0; }
  /// Of its coordinates in a frame.
  std::size_t index_of(std::size_t vertex) const { return kPose * body_count_ + 3 * vertex; }

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

  /// Sets the boxes along one axis.
  void set_boxes(std::size_t k, const Number& distance) {
    const auto& ends = body_count_ > 0 ? ends_ : frames_;
    const auto at = [&](std::size_t i) -> const Number& { return ends[i / count_][index_of(i % count_) + k]; };
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
    return !(a.is_fixed && b.is_fixed) && (a.body == kNoBody || a.body != b.body);
  }

  Lines lines_;
  Words words_;
  std::uint32_t count_ = 0, body_count_ = 0;
  std::size_t frame_ = 0;
  /// At the start and at the end: the numbers of each body's pose, and three for each vertex, which are its point if it
  /// is on a body; and, with bodies, the ends of the boxes of vertices in the same places.
  std::array<std::vector<Number>, 2> frames_, ends_;
  std::map<std::uint32_t, std::pair<std::uint32_t, std::array<Number, 3>>> on_bodies_;  ///< by vertex
  std::set<std::uint32_t> still_;  ///< bodies that have fixed vertices
  /// Points, edges, faces, vertices that are fixed and on bodies, points that are corners of no edge, points that are
  /// corners of wires, and wires: edges that are no sides of faces.
  std::array<std::vector<Element>, 8> elements_;
  std::vector<std::array<std::uint32_t, 2>> joined_;  ///< the corners of wires, sorted
  std::array<std::set<std::uint32_t>, 5> single_;     ///< the vertices that have a line of each sort
  Query query_;
  Corners corners_;
};

}  // namespace checker

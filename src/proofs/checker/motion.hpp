// Motion files for touchstone-check: the elements of a mesh, and its frames.
// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "checker/curved_motion.hpp"

namespace checker {

constexpr std::uint32_t kNoBody = kMostVertices, kNoGroup = kMostVertices + 1;

/// A point, an edge or a face, and its box during a step. Along each axis, the ends of the boxes of all vertices are
/// sorted. `low` is the rank of the box's least coordinate, and `reach` the number of the ends that are at most D
/// above its greatest one. Boxes a and b are at most D apart if a.low < b.reach and b.low < a.reach. With radii D is
/// the largest separation.
struct Element {
  std::array<std::uint32_t, 3> vertices{}, groups{}, low{}, reach{};
  std::size_t size = 0, number = 0;  ///< of vertices; among the elements of its sort
  bool is_fixed = false;             ///< all of its vertices are
  std::uint32_t body = kNoBody;      ///< that all of its vertices are on
  std::uint32_t radius = 0;          ///< the number of its radius, a place in a list
};

struct Radius {
  Number length;
  std::string word;
};

/// "vertex 5", "vertices 0 to 7".
inline std::string vertices(std::size_t first, std::size_t last) {
  return first == last ? "vertex " + std::to_string(first)
                       : "vertices " + std::to_string(first) + " to " + std::to_string(last);
}

/// Two numbers in ascending order.
inline std::array<std::uint32_t, 2> side(std::uint32_t v, std::uint32_t w) { return {std::min(v, w), std::max(v, w)}; }

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

  bool has_radii() const { return radii_.size() > 1; }

  std::uint32_t vertex_count() const { return count_; }
  std::uint32_t body_count() const { return body_count_; }
  /// Points, edges or faces.
  const std::vector<Element>& elements(std::size_t sort) const { return elements_[sort]; }
  /// The coordinates of the vertices, at the start or the end of the step, in a motion without bodies.
  const std::vector<Number>& coordinates(std::size_t end) const { return frames_[end]; }

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

  /// "7 frames, 121 vertices, 121 points, 320 edges, 200 faces": what the proofs are about, as a person must see.
  std::string contents() const {
    std::string text = counted(frame_, "frame", "frames") + ", " + counted(count_, "vertex", "vertices");
    for (std::size_t sort = 0; sort < 3; ++sort) {
      const std::string one(kSorts[sort]);
      text += ", " + counted(elements_[sort].size(), one, one + "s");
    }
    if (has_radii()) {
      std::uint64_t count = 0;
      const Radius *least = nullptr, *greatest = nullptr;
      for (std::size_t sort = 0; sort < 3; ++sort) {
        for (const Element& e : elements_[sort]) {
          const Radius& radius = radii_[e.radius];
          if (sign(radius.length) == 0) continue;
          if (++count == 1) least = greatest = &radius;
          if (compare(radius.length, least->length) < 0) least = &radius;
          if (compare(radius.length, greatest->length) > 0) greatest = &radius;
        }
      }
      text += ", " + counted(count, "element", "elements") + " with radii";
      if (count > 0) text += " from " + least->word + " to " + greatest->word;
      if (!near_.empty()) text += ", " + counted(near_.size(), "pair of neighbours", "pairs of neighbours");
    }
    if (!elements_[3].empty()) text += ", " + counted(elements_[3].size(), "fixed vertex", "fixed vertices");
    if (body_count_ > 0) {
      Runs bodies;
      for (const auto& [vertex, on_body] : on_bodies_) add_to_run(bodies[on_body.first], vertex);
      text += ", " + counted(elements_[4].size(), "vertex", "vertices") + " on " +
              counted(bodies.size(), "body", "bodies") + ", where ";
      std::set<std::uint32_t> named;
      for (const auto& [body, runs] : bodies) named.insert(body);
      text += text_of_runs(bodies, named);
    }
    text += touching() + ignored();
    const auto [corners, sides] = undeclared();
    if (corners > 0) text += ", " + counted(corners, "corner is no point", "corners are no points");
    if (sides > 0) text += ", " + counted(sides, "side is no edge", "sides are no edges");
    std::set<std::uint32_t> used;
    for (std::size_t sort = 0; sort < 3; ++sort) {
      for (const Element& e : elements_[sort])
        used.insert(e.vertices.begin(), e.vertices.begin() + static_cast<long>(e.size));
    }
    const std::size_t unused = count_ - used.size();
    if (unused > 0) text += ", " + counted(unused, "vertex is in no element", "vertices are in no element");
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

 protected:
  BadInput expected(const std::string& what) const { return lines_.bad("here must be " + what); }

  void read_element() {
    if (words_[0] == "radius") return read_radius();
    if (words_[0] == "near") return read_near();
    if (words_[0] == "group") return read_group();
    if (words_[0] == "ignore") return read_ignored();
    if (words_[0] == "touching") return read_touching();
    const auto sort = static_cast<std::size_t>(std::find(kSorts.begin(), kSorts.end(), words_[0]) - kSorts.begin());
    if (sort == kSorts.size() || words_.size() != kWords[sort]) {
      throw expected(
          R"("point V", "edge V0 V1", "face V0 V1 V2", "fixed V", "body V B X Y Z", "radius R", "near V W", )"
          R"("group V G", "ignore G H", "touching KIND I J" or "frame")");
    }
    Element element;
    element.number = elements_[sort].size();
    element.radius = static_cast<std::uint32_t>(radii_.size() - 1);
    for (; element.size < kSizes[sort]; ++element.size) {
      const std::uint32_t v = read_vertex(words_[element.size + 1]);
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

  std::uint32_t read_vertex(std::string_view word) const {
    std::uint32_t v = 0;
    if (!read_count(word, kMostVertices, v) || v >= count_)
      throw lines_.bad(quoted(word) + " is no vertex, such as 0 or 12, below " + std::to_string(count_));
    return v;
  }

  /// The radius of the elements after this line.
  void read_radius() {
    if (words_.size() != 2) throw expected("\"radius R\"");
    Radius radius;
    radius.word = words_[1];
    read_number(words_[1], radius.length, lines_);
    lines_.require(sign(radius.length) >= 0, "a radius must not be negative");
    radii_.push_back(radius);
  }
  void read_near() {
    if (words_.size() != 3) throw expected("\"near V W\"");
    const std::uint32_t v = read_vertex(words_[1]), w = read_vertex(words_[2]);
    lines_.require(v != w && near_.insert(side(v, w)).second,
                   "two different vertices that are not near yet were expected");
  }
  std::uint32_t read_group_number(std::string_view word) const {
    std::uint32_t group = 0;
    if (!read_count(word, kMostVertices, group)) throw lines_.bad(quoted(word) + " is no group, such as 0, below 2^30");
    return group;
  }
  void read_group() {
    if (words_.size() != 3) throw expected("\"group V G\"");
    const std::uint32_t v = read_vertex(words_[1]), group = read_group_number(words_[2]);
    lines_.require(groups_.emplace(v, group).second, "the vertex has such a line already: one was expected");
  }
  void read_ignored() {
    if (words_.size() != 3) throw expected("\"ignore G H\"");
    lines_.require(ignored_.insert(side(read_group_number(words_[1]), read_group_number(words_[2]))).second,
                   "two groups that are not ignored yet were expected");
  }
  /// Two elements: their numbers of vertices, and their own numbers.
  using Numbers = std::array<std::size_t, 4>;
  void read_touching() {
    const auto is_it = [&](const Kind& kind) { return words_.size() == 4 && words_[1] == kind.name; };
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(), is_it);
    std::uint32_t a = 0, b = 0;
    if (kind == kKinds.end() || !read_count(words_[2], kMostVertices, a) || !read_count(words_[3], kMostVertices, b)) {
      throw expected("\"touching KIND I J\"");
    }
    const std::size_t second = kind->corners - kind->first;
    lines_.require((kind->first != second || a < b) && touching_.insert(Numbers{kind->first, second, a, b}).second,
                   "two elements in their order, which have no such line, were expected");
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

  /// Sets whether the elements are fixed, the bodies that they are on, and the groups of their vertices.
  void set_attachments() {
    for (std::vector<Element>& elements : elements_) {
      for (Element& e : elements) {
        const auto end = e.vertices.begin() + static_cast<long>(e.size);
        e.is_fixed = std::all_of(e.vertices.begin(), end, [&](std::uint32_t v) { return is_fixed(v); });
        e.body = body_of(e.vertices[0]);
        if (std::any_of(e.vertices.begin(), end, [&](std::uint32_t v) { return body_of(v) != e.body; }))
          e.body = kNoBody;
        std::transform(e.vertices.begin(), end, e.groups.begin(), [&](std::uint32_t v) {
          const auto found = groups_.find(v);
          return found == groups_.end() ? kNoGroup : found->second;
        });
      }
    }
  }

  /// Of groups or bodies the first and the last vertex of each run, in ascending order.
  using Run = std::array<std::uint32_t, 2>;
  using Runs = std::map<std::uint32_t, std::vector<Run>>;
  static void add_to_run(std::vector<Run>& runs, std::uint32_t vertex) {
    if (runs.empty() || runs.back()[1] + 1 < vertex) runs.push_back({vertex, vertex});
    runs.back()[1] = vertex;
  }
  /// "0 has vertices 0 to 7 and vertex 9, 5 has no vertex".
  static std::string text_of_runs(Runs& all, const std::set<std::uint32_t>& named) {
    std::string text;
    for (const std::uint32_t number : named) {
      text += (text.empty() ? "" : ", ") + std::to_string(number) + " has ";
      const std::vector<Run>& runs = all[number];
      if (runs.empty()) text += "no vertex";
      for (std::size_t i = 0; i < runs.size(); ++i) text += (i > 0 ? " and " : "") + vertices(runs[i][0], runs[i][1]);
    }
    return text;
  }

  /// ", 4 pairs asked about touching alone, 1 of them joined by no edges", if there are some.
  std::string touching() const {
    if (touching_.empty()) return "";
    std::vector<std::uint32_t> root(count_);  // of trees of vertices that edges join
    std::iota(root.begin(), root.end(), 0U);
    const auto root_of = [&](std::uint32_t v) {
      while (root[v] != v) v = root[v] = root[root[v]];
      return v;
    };
    for (const Element& edge : elements_[1]) root[root_of(edge.vertices[0])] = root_of(edge.vertices[1]);
    const auto one_of = [&](std::size_t size, std::size_t number) {  // a vertex of the element, which may not exist
      const std::vector<Element>& elements = elements_[size - 1];
      return number < elements.size() ? root_of(elements[number].vertices[0]) : kNoGroup;
    };
    const auto apart = std::count_if(touching_.begin(), touching_.end(), [&](const Numbers& pair) {
      return one_of(pair[0], pair[2]) != one_of(pair[1], pair[3]);
    });
    return ", " + counted(touching_.size(), "pair", "pairs") + " asked about touching alone" +
           (apart > 0 ? ", " + std::to_string(apart) + " of them joined by no edges" : "");
  }

  /// ", 2 groups of vertices, 1 pair of groups not asked about: 0-1, where 0 has vertices 0 to 7, 1 vertex 8", if there
  /// are some.
  std::string ignored() const {
    if (ignored_.empty()) return "";
    Runs groups;
    for (const auto& [vertex, group] : groups_) add_to_run(groups[group], vertex);
    std::string text = ", " + counted(groups.size(), "group", "groups") + " of vertices, " +
                       counted(ignored_.size(), "pair", "pairs") + " of groups not asked about:";
    std::set<std::uint32_t> named;
    for (const auto& [g, h] : ignored_) {
      text += " " + std::to_string(g) + "-" + std::to_string(h);
      named.insert({g, h});
    }
    return text + ", where " + text_of_runs(groups, named);
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
  std::vector<Radius> radii_ = {Radius()};            ///< 0, and those of the lines `radius`
  std::set<std::array<std::uint32_t, 2>> near_;
  std::map<std::uint32_t, std::uint32_t> groups_;  ///< by vertex
  std::set<Numbers> touching_;
  std::set<std::array<std::uint32_t, 2>> ignored_;  ///< pairs of groups
};

}  // namespace checker

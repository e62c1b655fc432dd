// The four queries in exact arithmetic: moving corners, when two elements touch and where. Everything is a sign of a
// polynomial in t of degree at most 3 at an exact time, or just after it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>

#include "exact/exact.hpp"
#include "exact/lazy.hpp"
#include "geometry/vector.hpp"
#include "numbers/real_root.hpp"

namespace touchstone::exact {

using numbers::Exact;
using numbers::RealRoot;
using Linear = numbers::Polynomial<Exact, 1>;
using Quadratic = numbers::Polynomial<Exact, 2>;
using Cubic = numbers::Polynomial<Exact, 3>;
using Point = geometry::Vector<Linear>;  ///< a moving corner: start + t (end - start)

/// Signs at a root or just after it; may keep a record for `explain`.
class Moment {
 public:
  static Moment at(const RealRoot& root, std::vector<CandidateStory::Condition>* record = nullptr) {
    return Moment(root, false, record);
  }
  static Moment just_after(const RealRoot& root) { return Moment(root, true, nullptr); }

  /// The sign of q at this moment. The name and the axis (0, 1, 2; -1 for none) are for the record.
  int sign(numbers::Coefficients q, const char* name, int axis = -1) const;

 private:
  Moment(const RealRoot& root, bool after, std::vector<CandidateStory::Condition>* record)
      : root_(root), after_(after), record_(record) {}

  const RealRoot& root_;
  bool after_;
  std::vector<CandidateStory::Condition>* record_;
};

/// A point and an edge x y: they touch iff (p - x) x (y - x) = 0 and (p - x) . (p - y) <= 0.
class PointOnEdge {
 public:
  struct Names {
    const char* cross;
    const char* dot;
  };
  PointOnEdge(const Point& p, const Point& x, const Point& y, Names names);

  bool touching(const Moment& moment) const;

  /// Where on the edge a touching point is: 0 at x, 1 at y, 2 between. x wins where both coincide.
  int place(const RealRoot& root) const;

  /// The weights (x, y) of a touching point, supported on its place.
  std::array<double, 3> weights(const RealRoot& root) const;

  /// Appends polynomials among whose roots are all times at which touching may begin or end.
  void append_events(std::vector<Quadratic>& events) const;

 private:
  Point from_x_, from_y_, edge_;
  geometry::Vector<Quadratic> cross_;
  Names names_;
};

/// Edge a0 a1 against edge b0 b1.
class EdgeEdgeElements {
 public:
  static constexpr bool kHasCubic = true;
  explicit EdgeEdgeElements(const std::array<Point, 4>& corners);

  const Cubic& coplanarity() const { return coplanarity_; }
  bool touching(const Moment& moment) const;  ///< given that the four corners are coplanar at the moment
  void locate(const RealRoot& root, Answer& answer) const;
  std::vector<Quadratic> events() const;  ///< complete when the corners are always coplanar

 private:
  enum Pair { a0_on_b, a1_on_b, b0_on_a, b1_on_a };
  const PointOnEdge& pair(Pair which) const;
  void locate_parallel(const RealRoot& root, Answer& answer) const;
  void locate_overlap(const RealRoot& root, Answer& answer) const;

  std::array<Point, 4> corners_;
  Point u_, w_, r_;
  geometry::Vector<Quadratic> n_;
  Cubic coplanarity_;
  mutable std::array<Lazy<PointOnEdge>, 4> pairs_;
};

/// Vertex v against triangle f0 f1 f2.
class VertexFaceElements {
 public:
  static constexpr bool kHasCubic = true;
  explicit VertexFaceElements(const std::array<Point, 4>& corners);

  const Cubic& coplanarity() const { return coplanarity_; }
  bool touching(const Moment& moment) const;
  void locate(const RealRoot& root, Answer& answer) const;
  std::vector<Quadratic> events() const;

 private:
  const PointOnEdge& side(std::size_t which) const;  // f01, f12, f20
  void locate_flat(const RealRoot& root, Answer& answer) const;

  std::array<Point, 4> corners_;
  Point u_, w_, r_;
  geometry::Vector<Quadratic> n_;
  Cubic coplanarity_;
  mutable std::array<Lazy<PointOnEdge>, 3> sides_;
};

/// Point p against edge e0 e1.
class PointEdgeElements {
 public:
  static constexpr bool kHasCubic = false;
  explicit PointEdgeElements(const std::array<Point, 4>& corners);

  bool touching(const Moment& moment) const { return point_.touching(moment); }
  void locate(const RealRoot& root, Answer& answer) const;
  std::vector<Quadratic> events() const;

 private:
  PointOnEdge point_;
};

/// Point p against point q.
class PointPointElements {
 public:
  static constexpr bool kHasCubic = false;
  explicit PointPointElements(const std::array<Point, 4>& corners);

  bool touching(const Moment& moment) const;
  void locate(const RealRoot& root, Answer& answer) const;
  std::vector<Quadratic> events() const;

 private:
  Point difference_;
};

}  // namespace touchstone::exact

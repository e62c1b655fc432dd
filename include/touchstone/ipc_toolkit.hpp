// Touchstone: an exact narrow phase for ipc-toolkit. Include it beside touchstone.hpp; it needs ipc-toolkit and Eigen
// 3.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <ipc/ccd/narrow_phase_ccd.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include <touchstone/distance.hpp>
#include <touchstone/eigen.hpp>
#include <touchstone/error.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

namespace detail {

/// The type of the first argument of a member function.
template <typename Function>
struct FirstArgument;

/// The type itself.
template <typename Class, typename First, typename... Rest>
struct FirstArgument<bool (Class::*)(First, Rest...) const> {
  using type = First;  ///< the type of the first argument
};

/// ipc-toolkit passes a position in two or three dimensions as this type: a constant reference to a vector in version
/// 1.3, to an Eigen::Ref later.
using IpcPosition = typename FirstArgument<decltype(&ipc::NarrowPhaseCCD::point_point_ccd)>::type;

/// The same of a position in three dimensions.
using IpcPosition3 = typename FirstArgument<decltype(&ipc::NarrowPhaseCCD::edge_edge_ccd)>::type;

/// ipc::NarrowPhaseCCD with the member conservative_rescaling, which it has itself since version 1.6.
template <typename Base, typename = void>
class WithRescaling : public Base {
 public:
  double conservative_rescaling = 1.0;  ///< see ExactNarrowPhaseCCD
};

/// The base class itself where it has the member.
template <typename Base>
class WithRescaling<Base, std::void_t<decltype(std::declval<Base&>().conservative_rescaling)>> : public Base {};

}  // namespace detail

/// A narrow phase for ipc-toolkit, exact, with Euclidean distances. An object may be used by several threads.
///
/// Each of the four functions answers for the two elements while t goes from 0 to tmax, 0 <= tmax <= 1. The elements
/// are in contact while their distance is at most min_distance. With the rescaling 1, a function returns true exactly
/// when there is contact in [0, tmax]. Then toi is 0 if the elements are in contact at t = 0. Otherwise toi is strictly
/// before the first contact, and greater than 0 if some double is. The step x0 + toi (x1 - x0), rounded to doubles, is
/// free of contact: that very step was asked about. Where x1 - x0 overflows, half of it stands in its place. Without
/// contact toi is infinity.
///
/// With a rescaling s below 1, toi is the first time at which the distance is down to min_distance + (1 - s) (d0 -
/// min_distance), where d0 is the distance at t = 0, or up to s 2^-10 of that gap more. ipc-toolkit passes the least
/// toi so far as the tmax of the next pair. So that the least toi does not depend on the order of the pairs, such an
/// object also returns true if the first contact is in (tmax, 1] and toi is less than tmax. For tmax = 1 it returns
/// true exactly when there is contact.
class ExactNarrowPhaseCCD : public detail::WithRescaling<ipc::NarrowPhaseCCD> {
 public:
  /// The default rescaling: the times are exact, so no fraction of the step is given away.
  static constexpr double DEFAULT_CONSERVATIVE_RESCALING = 1.0;

  /// @param rescaling  the member conservative_rescaling, 0 < rescaling <= 1
  /// @throws InvalidQuery  for a rescaling outside (0, 1]
  explicit ExactNarrowPhaseCCD(double rescaling = DEFAULT_CONSERVATIVE_RESCALING) {
    this->conservative_rescaling = rescaling;
    check_rescaling();
  }

  /// Two points, in two or three dimensions.
  /// @param p0_t0         the first point at t = 0
  /// @param p1_t0         the second point at t = 0
  /// @param p0_t1         the first point at t = 1
  /// @param p1_t1         the second point at t = 1
  /// @param toi           becomes a time before the first contact, 0 for contact at t = 0, infinity without contact
  /// @param min_distance  the elements are in contact while their distance is at most this, >= 0
  /// @param tmax          the end of the time range, 0 <= tmax <= 1
  /// @return whether the elements come into contact
  /// @throws InvalidQuery  for a coordinate that is NaN or infinite, positions that have not two or three coordinates
  ///                       each, a min_distance that is negative or not finite, a tmax outside [0, 1], a
  ///                       conservative_rescaling outside (0, 1]
  bool point_point_ccd(detail::IpcPosition p0_t0, detail::IpcPosition p1_t0, detail::IpcPosition p0_t1,
                       detail::IpcPosition p1_t1, double& toi, const double min_distance = 0.0,
                       const double tmax = 1.0) const override {
    check_sizes(p0_t0, p1_t0, p0_t1, p1_t1);
    return answer(point_point(p0_t0, p1_t0, p0_t1, p1_t1), toi, min_distance, tmax);
  }

  /// A point and an edge, in two or three dimensions. The last three parameters, the result and the errors are those of
  /// point_point_ccd.
  bool point_edge_ccd(detail::IpcPosition p_t0, detail::IpcPosition e0_t0, detail::IpcPosition e1_t0,
                      detail::IpcPosition p_t1, detail::IpcPosition e0_t1, detail::IpcPosition e1_t1, double& toi,
                      const double min_distance = 0.0, const double tmax = 1.0) const override {
    check_sizes(p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1);
    return answer(point_edge(p_t0, e0_t0, e1_t0, p_t1, e0_t1, e1_t1), toi, min_distance, tmax);
  }

  /// A point and a triangle. The last three parameters, the result and the errors are those of point_point_ccd.
  bool point_triangle_ccd(detail::IpcPosition3 p_t0, detail::IpcPosition3 t0_t0, detail::IpcPosition3 t1_t0,
                          detail::IpcPosition3 t2_t0, detail::IpcPosition3 p_t1, detail::IpcPosition3 t0_t1,
                          detail::IpcPosition3 t1_t1, detail::IpcPosition3 t2_t1, double& toi,
                          const double min_distance = 0.0, const double tmax = 1.0) const override {
    return answer(vertex_face(p_t0, t0_t0, t1_t0, t2_t0, p_t1, t0_t1, t1_t1, t2_t1), toi, min_distance, tmax);
  }

  /// Two edges. The last three parameters, the result and the errors are those of point_point_ccd.
  bool edge_edge_ccd(detail::IpcPosition3 ea0_t0, detail::IpcPosition3 ea1_t0, detail::IpcPosition3 eb0_t0,
                     detail::IpcPosition3 eb1_t0, detail::IpcPosition3 ea0_t1, detail::IpcPosition3 ea1_t1,
                     detail::IpcPosition3 eb0_t1, detail::IpcPosition3 eb1_t1, double& toi,
                     const double min_distance = 0.0, const double tmax = 1.0) const override {
    return answer(edge_edge(ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1), toi, min_distance, tmax);
  }

 private:
  /// With the rescaling 1, elements that come together steadily keep about this fraction of their largest coordinate,
  /// 64 units in its last place: more than the positions after the step are rounded by.
  static constexpr double kRoundingReserve = 7.105427357601002e-15;  // 2^-47

  void check_rescaling() const {
    if (!(this->conservative_rescaling > 0 && this->conservative_rescaling <= 1)) {
      throw InvalidQuery("conservative_rescaling is " + std::to_string(this->conservative_rescaling) +
                         "; it must be in (0, 1]");
    }
  }

  template <typename First, typename... Rest>
  static void check_sizes(const First& first, const Rest&... rest) {
    if (((rest.size() != first.size()) || ...)) {
      throw InvalidQuery("the positions have different numbers of coordinates; each must have two, or each three");
    }
  }

  bool answer(const Query& query, double& toi, double min_distance, double tmax) const {
    check_rescaling();
    if (!(tmax >= 0 && tmax <= 1)) throw InvalidQuery("tmax is " + std::to_string(tmax) + "; it must be in [0, 1]");
    const Separation separation{min_distance};
    const bool is_rescaled = this->conservative_rescaling < 1;
    toi = std::numeric_limits<double>::infinity();
    if (!comes_within(query, separation, is_rescaled ? 1 : tmax)) return false;
    if (is_rescaled && tmax < 1 && keeps_its_distance(query, min_distance, tmax)) return false;
    const double time = time_before_contact(query, separation);
    if (!(time < tmax) && !comes_within(query, separation, tmax)) return false;
    toi = time;
    return true;
  }

  /// With a rescaling below 1: true proves that the time before contact is tmax or later. Until then the distance is
  /// more than the kept one, and so it is up to the time at which it comes down to that. There each coordinate of a
  /// rounded position is off by less than 5/8 2^-50 of the largest one, and the elements' distance by less than
  /// 2 sqrt(3) times that: by less than the kept distance exceeds min_distance. So the time is not made sooner.
  bool keeps_its_distance(const Query& query, double min_distance, double tmax) const {
    const double kept = kept_distance(query, min_distance);
    const double rounding = kRoundingReserve * largest_coordinate(query);
    return kept - min_distance > std::max(rounding, std::numeric_limits<double>::min()) &&
           !comes_within(query, Separation{kept}, tmax);
  }

  static bool comes_within(const Query& query, const Separation& separation, double tmax) {
    SolveOptions options;
    options.t_max = tmax;
    options.separation = separation;
    options.wanted = Wanted::contact;
    return solve(query, options).contact;
  }

  /// The toi of elements that come into contact in [0, 1].
  double time_before_contact(const Query& query, const Separation& separation) const {
    if (compare_distance(query, 0, separation) <= 0) return 0;
    double time = 0;
    double reserve = 0;
    if (this->conservative_rescaling < 1) {
      time = first_time_within(query, kept_distance(query, separation.distance));
      reserve = time / 2;
      if (compare_distance(query, time, separation) <= 0) time = std::nextafter(time, 0.0);
    } else {
      time = first_time_within(query, separation.distance);
      reserve = reserved_time(query, separation.distance, time);
      const double before = sooner(time, reserve);
      if (before > 0 || compare_distance(query, time, separation) <= 0) time = before;
    }
    for (; time > 0 && comes_within(rounded_step(query, time), separation, 1); reserve *= 4) {
      time = sooner(time, reserve);
    }
    return time;
  }

  static double first_time_within(const Query& query, double distance) {
    SolveOptions options;
    options.separation.distance = distance;
    options.wanted = Wanted::time;
    return solve(query, options).toi;
  }

  /// Less than a time that is greater than 0: by the reserve, or half of it.
  static double sooner(double time, double reserve) {
    return reserve < time / 2 && time - reserve < time ? time - reserve : time / 2;
  }

  /// How long before the first contact elements that come together steadily have a gap that is larger than the rounding
  /// of the positions after the step. It need not be right: that step is asked about.
  static double reserved_time(const Query& query, double min_distance, double first_contact) {
    const double gap = distance_upper_bound(query) - min_distance;
    return first_contact * (kRoundingReserve * largest_coordinate(query) / gap);
  }

  static double largest_coordinate(const Query& query) {
    double largest = 0;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (const Vec3& corner : {query.start[i], query.end[i]}) {
        largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
      }
    }
    return largest;
  }

  /// With a rescaling below 1, a distance that is greater than min_distance and less than the distance at the start;
  /// min_distance where no double is between them.
  double kept_distance(const Query& query, double min_distance) const {
    double start = distance_upper_bound(query);
    // That is at most 2^-20 of it too great, which is to be much less than the rest of the gap.
    if (!(0x1p-20 * start <= 0x1p-10 * this->conservative_rescaling * (start - min_distance))) {
      start = distance(query).value;
    }
    const double kept = min_distance + (1 - this->conservative_rescaling) * (start - min_distance);
    return kept > min_distance && kept < start ? kept : min_distance;
  }

  /// The query of the step to the positions at this time, as a line search rounds them.
  static Query rounded_step(const Query& query, double time) {
    Query step = query;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const Vec3& from = query.start[i];
      const Vec3& to = query.end[i];
      step.end[i] = {rounded(from.x, to.x, time), rounded(from.y, to.y, time), rounded(from.z, to.z, time)};
    }
    return step;
  }

  static double rounded(double from, double to, double time) {
    const double way = to - from;
    if (std::abs(way) <= std::numeric_limits<double>::max()) return from + time * way;
    return 2 * (from / 2 + time * (to / 2 - from / 2));  // the way overflows, and where it leads does not
  }
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone

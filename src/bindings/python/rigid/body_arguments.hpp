// The arguments of questions about whole bodies: bodies, and their poses in one motion or in many.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/bodies.hpp>

#include <atomic>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "python/background.hpp"
#include "python/curved/number_table.hpp"
#include "python/rigid/rigid_results.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::python {

/// A body from positions and elements, from a mesh, or from what as_mesh takes.
Body body_of(const py::object& points, const py::object& faces, const py::object& edges, const py::object& loose_points,
             const py::object& radii, const py::object& mesh);

/// The meaning of the argument `quaternion`.
QuaternionOrder order_of(py::handle quaternion);
/// The meaning of the argument `turn`.
Turn turn_of(py::handle turn);

std::array<double, 7> pose_numbers(const Pose& pose, QuaternionOrder order);

/// One motion of all bodies.
struct AskedMotions {
  std::vector<RigidMotion> motions;
  std::vector<BodyIndex> turned;  ///< the bodies that take the shorter turn in place of the longer one, as given
};

/// The motions that a question is about: one, or many of the same bodies.
class BodySteps {
 public:
  /// @param start, end  (k, 7) or (n, k, 7)
  /// @param inner       None, or (k, m, 3) or (n, k, m, 3): m = 1 or 2 control points between both positions
  BodySteps(const Bodies& bodies, py::handle start, py::handle end, QuaternionOrder order, Turn turn,
            py::handle inner = py::none());
  /// Bodies at rest.
  BodySteps(const Bodies& bodies, py::handle poses, QuaternionOrder order);

  bool is_single() const noexcept { return single_; }
  const AskedMotions& first() const noexcept { return all_[0]; }

  /// ask(motions, options) for the motion, or the list of those for each of them. One motion is asked about on all
  /// threads, and each of many on one.
  template <class Ask>
  py::object each(py::handle threads, const Ask& ask) const {
    MeshOptions options;
    options.threads = threads_of(threads);
    std::vector<std::decay_t<std::invoke_result_t<Ask, const AskedMotions&, const MeshOptions&>>> results(all_.size());
    in_background(size_, [&](const std::atomic<bool>& stop) {
      options.stop = &stop;
      const int thread_count = std::exchange(options.threads, single_ ? options.threads : 1);
      threads::for_each_range(all_.size(), 1, single_ ? 1 : thread_count, [&](std::size_t first, std::size_t last) {
        for (std::size_t m = first; m < last; ++m) results[m] = ask(all_[m], options);
      });
    });
    if (single_) return py::cast(std::move(results[0]));
    py::list list;
    for (auto& result : results) list.append(py::cast(std::move(result)));
    return py::object(list);
  }

 private:
  void read(const Bodies& bodies, const NumberTable& start, const NumberTable& end, QuaternionOrder order, Turn turn,
            py::handle inner);

  std::vector<AskedMotions> all_;
  bool single_ = true;
  std::size_t size_ = 0;  ///< of the question, as in_background has it
};

}  // namespace touchstone::python

// The interface that ipc-toolkit gives to a narrow phase, as far as touchstone/ipc_toolkit.hpp uses it: for the tests,
// which need no ipc-toolkit. IPC_INTERFACE_1_3 makes it the one of version 1.3.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace ipc {

/// A position in two or three dimensions.
using VectorMax3d = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

#ifdef IPC_INTERFACE_1_3
using Position = const VectorMax3d&;
using Position3 = const Eigen::Vector3d&;
#else
using Position = const Eigen::Ref<const VectorMax3d>&;
using Position3 = const Eigen::Ref<const Eigen::Vector3d>&;
#endif

class NarrowPhaseCCD {
 public:
  NarrowPhaseCCD() = default;
  virtual ~NarrowPhaseCCD() = default;

  virtual bool point_point_ccd(Position, Position, Position, Position, double& toi, const double min_distance = 0.0,
                               const double tmax = 1.0) const = 0;
  virtual bool point_edge_ccd(Position, Position, Position, Position, Position, Position, double& toi,
                              const double min_distance = 0.0, const double tmax = 1.0) const = 0;
  virtual bool point_triangle_ccd(Position3, Position3, Position3, Position3, Position3, Position3, Position3,
                                  Position3, double& toi, const double min_distance = 0.0,
                                  const double tmax = 1.0) const = 0;
  virtual bool edge_edge_ccd(Position3, Position3, Position3, Position3, Position3, Position3, Position3, Position3,
                             double& toi, const double min_distance = 0.0, const double tmax = 1.0) const = 0;

#ifndef IPC_INTERFACE_1_3
  double conservative_rescaling;
#endif
};

}  // namespace ipc

// Where a simulation's processor time goes.
// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace touchstone::sim {

/// Seconds of all threads.
struct PhaseTimes {
  double integration = 0;  ///< substeps without contacts
  double contacts = 0;  ///< substeps that are solved again with contacts in their potential, or of bodies, by impulses
  double response = 0;  ///< broad and narrow phase, impulses and impact zones of particles
  double proof = 0;     ///< of bodies: the answers about the motion that is taken

  double total() const noexcept { return integration + contacts + response + proof; }
  double collision() const noexcept { return response + proof; }

  PhaseTimes& operator+=(const PhaseTimes& other) noexcept {
    integration += other.integration;
    contacts += other.contacts;
    response += other.response;
    proof += other.proof;
    return *this;
  }
};

/// Adds the time until its end to one phase.
class PhaseClock {
 public:
  explicit PhaseClock(double& sum) : sum_(&sum), start_(std::clock()) {}
  ~PhaseClock() { *sum_ += static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }
  PhaseClock(const PhaseClock&) = delete;
  PhaseClock& operator=(const PhaseClock&) = delete;

 private:
  double* sum_;
  std::clock_t start_;
};

}  // namespace touchstone::sim

// The verdicts on claims about many queries.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "certify/tally.hpp"
#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/define.hpp"

namespace touchstone::python {
namespace {

/// @param classes  None for all
certify::Counting<Verdict> counting_of(py::handle late_ulps, py::handle late_fraction, py::handle classes) {
  certify::Counting<Verdict> counting;
  certify::TimeLimit late;
  if (!late_ulps.is_none()) late.ulps = late_ulps.cast<std::uint64_t>();
  if (!late_fraction.is_none()) {
    late.fraction = number_of(late_fraction, "late_fraction");
    if (!(*late.fraction >= 0 && *late.fraction <= 1)) {
      throw py::value_error("late_fraction is " + std::string(py::str(late_fraction)) + "; it must be in [0, 1]");
    }
  }
  if (late.ulps || late.fraction) counting.late = late;
  if (classes.is_none()) return counting;
  for (const py::handle name : classes) counting.classes.push_back(refuted_verdict_of(name));
  return counting;
}

/// For each claim its verdict, and whether it is wrong and does not count.
/// @param toi  NaN without a time
py::tuple judge_claims(const Answers& truth, const py::array_t<bool>& contact, const py::array_t<double>& toi,
                       py::handle late_ulps, py::handle late_fraction, py::handle classes) {
  const auto counting = counting_of(late_ulps, late_fraction, classes);
  const auto count = static_cast<py::ssize_t>(truth.all().size());
  py::array_t<std::uint8_t> verdicts(count);
  py::array_t<bool> not_counted(count);
  const auto contacts = contact.unchecked<1>();
  const auto times = toi.unchecked<1>();
  certify::NotCounted counts_of_others;
  Claim claim;
  for (py::ssize_t i = 0; i < count; ++i) {
    claim.contact = contacts(i);
    claim.toi = std::isnan(times(i)) ? std::nullopt : std::optional(times(i));
    const Answer& answer = truth.all()[static_cast<std::size_t>(i)];
    const Verdict verdict = judge(claim, answer);
    verdicts.mutable_data()[i] = static_cast<std::uint8_t>(verdict);
    not_counted.mutable_data()[i] =
        verdict != Verdict::holds && !certify::counts(counting, claim, answer, verdict, counts_of_others);
  }
  return py::make_tuple(verdicts, not_counted);
}

}  // namespace

void define_judging(py::module_& module) { module.def("judge", &judge_claims); }

}  // namespace touchstone::python

// SPDX-License-Identifier: MIT
#include "fuzz/judging/failure.hpp"

#include <algorithm>
#include <cmath>

#include <touchstone/certify.hpp>

#include "certify/answer_check.hpp"
#include "certify/time_errors.hpp"

namespace touchstone::fuzz {
namespace {

/// Whether the claimed time is before the step; one that rounds to -0 is, unless it is 0.
bool is_negative(const Reply& reply) {
  return *reply.toi < 0 || (*reply.toi == 0 && reply.toi_as_written.starts_with('-'));
}

}  // namespace

std::optional<Failure> failure_of(const Query& query, const Reply& reply, const Answer& truth,
                                  const certify::TimeLimit& early, const Separation& separation) {
  switch (reply.state) {
    case Reply::State::crashed: return Failure{FailureClass::crash, reply.detail};
    case Reply::State::hung: return Failure{FailureClass::hang, reply.detail};
    case Reply::State::malformed: return Failure{FailureClass::malformed, reply.detail};
    case Reply::State::answered: break;
  }
  if (!reply.contact) {  // a time beside it means nothing
    if (truth.contact) return Failure{FailureClass::missed, ""};
    return std::nullopt;
  }
  if (reply.toi && std::isnan(*reply.toi)) return Failure{FailureClass::nan, ""};
  switch (judge({true, reply.toi, reply.toi_as_written}, query, truth, separation)) {
    case Verdict::holds: break;
    case Verdict::missed: return Failure{FailureClass::missed, ""};
    case Verdict::phantom: return Failure{FailureClass::phantom, ""};
    case Verdict::late: return Failure{FailureClass::late, ""};
  }
  if (!reply.toi) return std::nullopt;
  if (is_negative(reply)) return Failure{FailureClass::malformed, "a time before the step"};
  // A time as written that is not late may round to the double after the exact time.
  if (early.allows(std::min(*reply.toi, truth.toi), truth.toi)) return std::nullopt;
  return Failure{FailureClass::early, ""};
}

std::optional<Failure> failure_of(Kind kind, const Answer& answer, const Answer& truth, double t_max) {
  Reply claimed;
  claimed.contact = answer.contact;
  if (answer.contact) claimed.toi = answer.toi;
  // Whole answers hold doubles, so that the judge needs no query.
  if (auto failure = failure_of(Query(), claimed, truth, {})) return failure;
  if (std::string wrong = certify::decision_difference(answer, truth); !wrong.empty()) {
    return Failure{FailureClass::differs, wrong};
  }
  if (std::string wrong = certify::weight_difference(answer, truth); !wrong.empty()) {
    return Failure{FailureClass::differs, wrong};
  }
  if (std::string wrong = certify::malformation(kind, answer, t_max); !wrong.empty()) {
    return Failure{FailureClass::malformed, wrong};
  }
  return std::nullopt;
}

}  // namespace touchstone::fuzz

// SPDX-License-Identifier: MIT
#include "fuzz/judging/judged_solver.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <touchstone/curved.hpp>

namespace touchstone::fuzz {
namespace {

double greatest_coordinate(const AnyQuery& query) noexcept {
  double greatest = 0;
  const auto add = [&greatest](const Vec3& x) {
    greatest = std::max({greatest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
  };
  if (const auto* const straight = std::get_if<Query>(&query)) {
    for (const auto* const corners : {&straight->start, &straight->end})
      std::for_each(corners->begin(), corners->end(), add);
    return greatest;
  }
  const auto& curved = std::get<CurvedQuery>(query);
  for (std::size_t i = 0; i < corner_count(curved.kind); ++i) {
    const CurvedCorner& corner = curved.corners[i];
    std::for_each(corner.points.begin(), corner.points.end(), add);
    if (corner.motion == CurvedCorner::kOnCurve) continue;
    const RigidMotion& motion = curved.motions[static_cast<std::size_t>(corner.motion)];
    add(motion.p0);
    add(motion.p1);
  }
  return greatest;
}

}  // namespace

JudgedSolver::JudgedSolver(SolverUnderTest& solver, const Settings& settings)
    : solver_(solver),
      answering_(dynamic_cast<AnsweringSolver*>(&solver)),
      judge_(settings.judge),
      own_separations_(settings.own_separations),
      allowance_(settings.allowance) {}

Answer JudgedSolver::truth(const Asked& asked) const {
  if (const auto* const curved = std::get_if<CurvedQuery>(&asked.query)) {
    return solve(*curved, {.t_max = asked.t_max, .separation = asked.separation, .method = judge_});
  }
  return solve(std::get<Query>(asked.query), {.separation = asked.separation, .method = judge_});
}

bool JudgedSolver::allows(const JudgedReply& judged, const Asked& asked, const Answer& truth) const {
  const FailureClass failure = judged.failure->failure;
  if (!allowance_.has(failure)) return true;
  const double size = greatest_coordinate(asked.query), moved = allowance_.moved + allowance_.moved_relative * size;
  if (failure == FailureClass::late && allowance_.allows(*judged.reply.toi, truth.toi)) return true;
  if (failure == FailureClass::late || failure == FailureClass::missed) {
    return moved > 0 && right_when_moved(judged.reply, asked, moved);
  }
  constexpr double kMost = std::numeric_limits<double>::max();
  const double near = std::min(allowance_.near * size + moved, kMost);
  if (failure != FailureClass::phantom || near == 0) return false;
  Asked wider = asked;
  wider.separation.distance = std::min(asked.separation.distance + near, kMost);
  return this->truth(wider).contact;
}

/// Tries the length and its half and quarter in the directions of a cube's faces and corners. A wrong answer that would
/// be right only for another motion is missed.
bool JudgedSolver::right_when_moved(const Reply& reply, const Asked& asked, double length) const {
  const auto* const straight = std::get_if<Query>(&asked.query);
  if (straight == nullptr) return false;
  const std::size_t corners = straight->kind == Kind::edge_edge ? 2 : 1;
  for (int tried = 0; tried < 3 * 27; ++tried) {
    const int direction = tried % 27;
    const double x = direction % 3 - 1, y = direction / 3 % 3 - 1, z = direction / 9 - 1;
    const double ones = std::fabs(x) + std::fabs(y) + std::fabs(z);
    if (ones != 1 && ones != 3) continue;
    const double step = std::ldexp(length, -tried / 27) / std::sqrt(ones);
    Query moved = *straight;
    for (auto* const ends : {&moved.start, &moved.end}) {
      for (std::size_t i = 0; i < corners; ++i) {
        (*ends)[i] = {(*ends)[i].x + step * x, (*ends)[i].y + step * y, (*ends)[i].z + step * z};
      }
    }
    if (!(greatest_coordinate(moved) <= std::numeric_limits<double>::max())) continue;
    const Answer truth = this->truth({moved, asked.separation, asked.t_max});
    const auto failure = failure_of(moved, reply, truth, allowance_.early, asked.separation);
    if (!failure || (failure->failure == FailureClass::late && allowance_.allows(*reply.toi, truth.toi))) return true;
  }
  return false;
}

JudgedReply JudgedSolver::ask_straight(const Query& query, const Separation& separation, const Answer& truth) const {
  JudgedReply judged;
  if (answering_ == nullptr) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point asked = Clock::now();
    judged.reply = solver_.ask(query);
    judged.seconds = std::chrono::duration<double>(Clock::now() - asked).count();
    judged.failure = failure_of(query, judged.reply, truth, allowance_.early, separation);
    return judged;
  }
  const Answer answer = answering_->answer(query);
  judged.reply.contact = answer.contact;
  if (answer.contact) judged.reply.toi = answer.toi;
  judged.failure = failure_of(query.kind, answer, truth);
  return judged;
}

JudgedReply JudgedSolver::ask_curved(const CurvedQuery& query, double t_max, const Answer& truth) const {
  JudgedReply judged;
  if (answering_ == nullptr) {
    judged.reply = solver_.ask_curved(query, t_max);
    // A curved query is asked in this process, so that its time is a double and the judge needs no query.
    judged.failure = failure_of(Query(), judged.reply, truth, allowance_.early);
    return judged;
  }
  const Answer answer = answering_->answer_curved(query, t_max);
  judged.reply.contact = answer.contact;
  if (answer.contact) judged.reply.toi = answer.toi;
  judged.failure = failure_of(query.kind, answer, truth, t_max);
  return judged;
}

JudgedReply JudgedSolver::ask(const Asked& asked, const Answer& truth) const {
  if (own_separations_) solver_.change_separation(asked.separation);
  const auto* const curved = std::get_if<CurvedQuery>(&asked.query);
  JudgedReply judged = curved != nullptr ? ask_curved(*curved, asked.t_max, truth)
                                         : ask_straight(std::get<Query>(asked.query), asked.separation, truth);
  if (!judged.failure || !allows(judged, asked, truth)) return judged;
  judged.failure.reset();
  judged.allowed = true;
  return judged;
}

}  // namespace touchstone::fuzz

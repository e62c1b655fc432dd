// The first contact. Either the contact equations have finitely many common roots, and each is looked at; or they
// hold at all times, and the step is divided at every time at which anything that matters can change.
// SPDX-License-Identifier: MIT
#include "oracle/oracle.hpp"

#include <tuple>
#include <vector>

#include "oracle/equations.hpp"
#include "oracle/moment.hpp"
#include "oracle/motion.hpp"
#include "oracle/touch.hpp"

namespace touchstone::oracle {

bool is_present() noexcept { return true; }

namespace {

Answer contact(const Moment& time, const Touch& where, Nature nature) {
  Answer answer = no_contact();
  answer.contact = true;
  answer.nature = nature;
  answer.feature_a = where.a.feature;
  answer.feature_b = where.b.feature;
  std::tie(answer.toi, answer.toi_upper) = time.enclosing_doubles();
  answer.weights_a = where.a.weights;
  answer.weights_b = where.b.weights;
  return answer;
}

/// The polynomial whose roots are the common roots of all; zero when all are.
Polynomial common_roots_of(const std::vector<Polynomial>& equations) {
  Polynomial common(Integer(0));
  for (const auto& equation : equations) {
    if (equation.is_zero()) continue;
    common = common.is_zero() ? equation : CGAL::gcd(common, equation);
  }
  return common;
}

/// The equations hold at the roots of `equation` only.
Answer decide_at_roots(Kind kind, const Corners& corners, const Polynomial& equation, double t_max) {
  const bool has_sides = kind == Kind::edge_edge || kind == Kind::vertex_face;
  for (const auto& [time, multiplicity] : roots_within(equation, t_max)) {
    const auto where = touch(kind, corners, time);
    if (!where) continue;
    return contact(time, *where,
                   !has_sides              ? Nature::isolated
                   : multiplicity % 2 == 1 ? Nature::crossing
                                           : Nature::grazing);
  }
  return no_contact();
}

/// The equations hold at all times. Between neighbouring times of the division the elements touch always or never;
/// the touching times being a closed set, touching between two of them means touching at both, so the first contact
/// is at one of them.
Answer decide_everywhere(Kind kind, const Corners& corners, double t_max) {
  const auto times = times_dividing(t_max, deciding_polynomials(kind, corners));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto where = touch(kind, corners, times[i]);
    if (!where) continue;
    const bool lasts = i + 1 < times.size() && touch(kind, corners, between(times[i], times[i + 1]));
    return contact(times[i], *where, lasts ? Nature::sustained : Nature::isolated);
  }
  return no_contact();
}

Answer decide_motion(Kind kind, const Corners& corners, double t_max) {
  const Polynomial equation = common_roots_of(contact_equations(kind, corners));
  return equation.is_zero() ? decide_everywhere(kind, corners, t_max) : decide_at_roots(kind, corners, equation, t_max);
}

}  // namespace

Answer decide_by_oracle(const Query& query, double t_max) {
  return decide_motion(query.kind, read_motion(query), t_max);
}

Answer decide_by_oracle(const RationalQuery& query, double t_max) {
  return decide_motion(query.kind, read_motion(query), t_max);
}

Answer decide_by_oracle(const CurvedQuery& query, double t_max) {
  return decide_motion(query.kind, read_motion(query), t_max);
}

}  // namespace touchstone::oracle

// The decision in exact arithmetic, degenerate cases included.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "geometry/end_gradients.hpp"

namespace touchstone::exact {

/// The first contact in [0, t_max]; level is Level::exact. The query must be valid (finite, t_max in [0, 1],
/// well-formed fractions) and the floating-point environment the default one: callers in `solver` see to both.
Answer decide_exactly(const Query& query, double t_max);
Answer decide_exactly(const RationalQuery& query, double t_max);
Answer decide_exactly(const CurvedQuery& query, double t_max);

/// The rungs of the exact level, in the order in which a query meets them. A near rung has times in double-doubles. If
/// they leave a doubt, the next rung decides the query. Coordinates are integers of so many bits in some unit: a near
/// rung has a unit for each axis, an exact one has the same unit for all axes.
enum class Rung : std::uint8_t {
  near_word,    ///< at most 16 bits: all integers in one machine word
  near_one,     ///< at most 59 bits
  near_two,     ///< at most 123 bits
  exact_one,    ///< at most 59 bits: integers of one to three limbs, with exact times
  exact_two,    ///< at most 123 bits
  exact_three,  ///< at most 187 bits
  exact_any     ///< dyadic numbers of any size
};

inline constexpr std::size_t kRungs = 7;

/// The same answer in less time, by the first rung that decides. Only the last bits of its weights may differ. It may
/// leave out the members of a contact that `wanted` does not ask for.
/// @param decided  null, or becomes the rung
Answer decide(const Query& query, double t_max, Wanted wanted, Rung* decided = nullptr);

/// The same for contact within a separation > 0.
Answer decide_exactly(const Query& query, double t_max, const Separation& separation);
Answer decide_exactly(const RationalQuery& query, double t_max, const Separation& separation);
Answer decide_exactly(const CurvedQuery& query, double t_max, const Separation& separation);

/// The sign of (distance at t - separation), for 0 <= t <= 1 and each sort of query.
template <class AnyQuery>
int compare_distance(const AnyQuery& query, double t, const Separation& separation);

/// The distance at t, its features and weights, for 0 <= t <= 1 and each sort of query.
template <class AnyQuery>
Distance distance_at(const AnyQuery& query, double t, Metric metric);

/// The unit normal at the first contact, as touchstone/contact_normal.hpp defines it, for a Euclidean separation >= 0.
std::optional<std::array<double, 3>> contact_normal(const Query& query, double t_max, const Separation& separation);
std::optional<std::array<double, 3>> contact_normal(const RationalQuery& query, double t_max,
                                                    const Separation& separation);
std::optional<std::array<double, 3>> contact_normal(const CurvedQuery& query, double t_max,
                                                    const Separation& separation);

/// The derivatives of the first contact's time by the corners at both ends, as touchstone/toi_gradient.hpp defines them,
/// for a Euclidean separation >= 0; nothing where there are none.
std::optional<geometry::EndGradients> toi_gradient(const Query& query, double t_max, const Separation& separation);
std::optional<geometry::EndGradients> toi_gradient(const RationalQuery& query, double t_max,
                                                   const Separation& separation);

/// V(t) within a relative error of 2^-50 and with its exact sign, for edge-edge and vertex-face queries and
/// 0 <= t <= 1. A value that underflows is the least double of its sign; one that overflows is infinite.
double coplanarity_at(const Query& query, double t);

/// One candidate time and the signs that decide it.
struct CandidateStory {
  double lower = 0, upper = 0;  ///< the neighbouring doubles around the candidate time
  std::string time;             ///< its exact value for a person: "1/3", "root of ... in [...]"
  int multiplicity = 1;         ///< as a root of V or `polynomial`; 0 when it is a candidate for another reason
  std::string polynomial;       ///< with a separation: the name of the polynomial that it is a root of
  struct Condition {
    std::string name;  ///< "n_z", "(r x w)_z", ...
    int sign;          ///< -1, 0 or 1 at the exact time
  };
  std::vector<Condition> conditions;
  bool touching = false;
};

/// How the exact level finds its answer.
struct Story {
  bool has_cubic = false;  ///< edge-edge and vertex-face have one
  /// V's exact coefficients, constant first, as fractions or integers times 2^k.
  std::vector<std::string> coefficients;

  /// With a separation: a polynomial that changes its sign where a pair of features comes within the separation.
  struct DistancePolynomial {
    std::string name;                       ///< "a against b", "the planes x = d, y = -d and a0 = 0"
    std::vector<std::string> coefficients;  ///< exact, as above
  };
  std::vector<DistancePolynomial> polynomials;  ///< those with a root in [0, t_max], as far as they were needed
  std::vector<std::string> without_root;        ///< the names of the others
  std::string why;                              ///< one sentence: which case this is
  std::vector<CandidateStory> candidates;
  Answer answer;
};
Story explain(const Query& query, double t_max);
Story explain(const RationalQuery& query, double t_max);
Story explain(const CurvedQuery& query, double t_max);

/// The same for contact within a separation > 0.
Story explain(const Query& query, double t_max, const Separation& separation);
Story explain(const RationalQuery& query, double t_max, const Separation& separation);
Story explain(const CurvedQuery& query, double t_max, const Separation& separation);

}  // namespace touchstone::exact

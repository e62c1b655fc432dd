// SPDX-License-Identifier: MIT
#include "proofs/theorem.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/kind_traits.hpp"
#include "proofs/coq_terms.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {
namespace {

/// The definitions of corners, and what the proof needs to know of them.
struct CornerDefinitions {
  Kind kind;
  std::string text;
  std::set<std::string> coordinate_units, turn_units;  ///< denominators

  void add_units(std::set<std::string>& units, const NumberTexts& numbers) {
    for (const NumberText& number : numbers) units.insert(number.denominator);
  }
  std::string name(std::size_t i) const { return std::string(corner_name(kind, i)); }

  void add_curve(std::size_t i, const std::vector<NumberTexts>& control) {
    std::vector<std::string> decimals, terms;
    for (const NumberTexts& point : control) {
      decimals.push_back(decimals_of(point));
      terms.push_back(rational_point(point));
      add_units(coordinate_units, point);
    }
    text += "(* The corner " + name(i);
    if (std::all_of(terms.begin(), terms.end(), [&](const std::string& term) { return term == terms[0]; })) {
      text += " stays at " + decimals[0];
    } else if (control.size() == 2) {
      text += " moves straight on\n   from " + decimals[0] + " at the time 0\n   to " + decimals[1] + " at the time 1";
    } else {
      text += " moves on the Bezier curve with the control points";
      for (const std::string& point : decimals) text += "\n   " + point;
    }
    text += ". *)\nDefinition corner_" + name(i) + " : corner := On_curve\n  " + list_term(terms, ";\n   ") + ".\n";
  }

  void add_motion(int m, const RigidMotion& motion) {
    const auto quaternion = [&](const std::array<double, 4>& q) {
      const NumberTexts numbers = {number_text(q[0]), number_text(q[1]), number_text(q[2]), number_text(q[3])};
      add_units(turn_units, numbers);
      return numbers;
    };
    const NumberTexts q[] = {quaternion(motion.q0), quaternion(motion.q1)};
    const NumberTexts p[] = {number_texts(motion.p0), number_texts(motion.p1)};
    for (const NumberTexts& position : p) add_units(coordinate_units, position);
    const std::string number = std::to_string(m);
    text += "(* The body of the motion " + number + " turns by quaternions (w, x, y, z)\n   from " + decimals_of(q[0]) +
            " at the time 0\n   to " + decimals_of(q[1]) + " at the time 1, and its origin moves\n   from " +
            decimals_of(p[0]) + "\n   to " + decimals_of(p[1]) + ". *)\nDefinition motion_" + number +
            " : motion := {|\n";
    for (const char end : {'0', '1'}) {
      const NumberTexts& at_end = q[end - '0'];
      text += std::string("  s_") + end + " := " + at_end[0].term + "; v_" + end +
              " := " + rational_point({at_end[1], at_end[2], at_end[3]}) + ";\n";
    }
    text += "  p_0 := " + rational_point(p[0]) + ";\n  p_1 := " + rational_point(p[1]) + " |}.\n";
  }

  void add_body_corner(std::size_t i, int m, const NumberTexts& point) {
    add_units(coordinate_units, point);
    const std::string number = std::to_string(m);
    text += "(* The corner " + name(i) + " is the point " + decimals_of(point) + " of the body of the motion " +
            number + ". *)\nDefinition corner_" + name(i) + " : corner := On_body " + number + " motion_" + number +
            "\n  (" + rational_point(point) + ").\n";
  }
};

CornerDefinitions corners_of(const CurvedQuery& query) {
  CornerDefinitions corners{query.kind, {}, {}, {}};
  std::set<int> motions;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) {
      std::vector<NumberTexts> control;
      for (int k = 0; k < corner.control_points; ++k) {
        control.push_back(number_texts(corner.points[static_cast<std::size_t>(k)]));
      }
      corners.add_curve(i, control);
    } else {
      if (motions.insert(corner.motion).second) {
        corners.add_motion(corner.motion, query.motions[static_cast<std::size_t>(corner.motion)]);
      }
      corners.add_body_corner(i, corner.motion, number_texts(corner.points[0]));
    }
  }
  return corners;
}
CornerDefinitions corners_of(const Query& query) { return corners_of(CurvedQuery(query)); }
CornerDefinitions corners_of(const RationalQuery& query) {
  CornerDefinitions corners{query.kind, {}, {}, {}};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    corners.add_curve(i, {number_texts(query.start[i]), number_texts(query.end[i])});
  }
  return corners;
}

/// The common multiple of denominators, which Coq computes.
std::string common_multiple(std::set<std::string> units) {
  units.erase("1");
  return units.empty() ? "1" : "fold_right Z.lcm 1 " + list_term({units.begin(), units.end()});
}

std::string direction_of(const Piece& piece) {
  if (piece.normal) return "Normal";
  std::string text = "Along (Vector";
  for (const Dense& p : piece.direction.c) text += ' ' + polynomial_term(p);
  return text + ')';
}

/// "Definition certificate": a Proof of Checker.v.
std::string certificate_of(const CornerDefinitions& corners, const Answer& answer, const Proof& proof) {
  std::string text =
      "Definition certificate : proof := {|\n  coordinate_unit := " + common_multiple(corners.coordinate_units) +
      ";\n  turn_unit := " + common_multiple(corners.turn_units) + ";\n";
  std::vector<std::string> pieces;
  for (const Piece& piece : proof.pieces) {
    pieces.push_back('(' + direction_of(piece) + ", " + number_text(piece.until).term + "%Q)");
  }
  if (!pieces.empty()) pieces.pop_back();  // the last one has no end of its own
  text += "  pieces := " + list_term(pieces, ";\n    ") +
          ";\n  last_piece := " + (proof.pieces.empty() ? "Normal" : direction_of(proof.pieces.back())) + ";\n";

  // The time is mantissa / 2^places, with 53 bits if there is such a one.
  constexpr int kMostPower = 1074, kBits = 53;
  const double toi = answer.contact ? answer.toi : 0;
  int power = kMostPower, exponent = 0;
  std::frexp(toi, &exponent);
  if (toi > 0) power = std::min(kMostPower, kBits - exponent);
  text +=
      "  mantissa := " + integer_term(Exact(std::ldexp(toi, power))) + "; places := " + std::to_string(power) + ";\n";

  Meeting meeting = proof.meeting.value_or(Meeting{});
  remove_common_factor({&meeting.root});
  text += "  root := " + polynomial_term(meeting.root) + ";\n  lower := " + number_text(meeting.low).term +
          "; upper := " + number_text(meeting.high).term + ";\n";
  std::vector<std::string> weights[2];
  for (std::size_t i = 0; i < corner_count(corners.kind); ++i) {
    weights[i < geometry::corners_of_first(corners.kind) ? 0 : 1].push_back(polynomial_term(meeting.weights[i]));
  }
  return text + "  weights := (" + list_term(weights[0]) + ", " + list_term(weights[1]) + ") |}.\n";
}

/// An element for a person, "the edge a0 a1", and as a list of corners.
struct ElementText {
  std::string sentence, list;
};
ElementText element_text(Kind kind, MeshElement sort, std::size_t first) {
  const std::size_t count = static_cast<std::size_t>(sort) + 1;
  std::string sentence = count == 1 ? "the point" : "the " + std::string(name_of(sort));
  std::vector<std::string> corners;
  for (std::size_t i = first; i < first + count; ++i) {
    sentence += ' ' + std::string(corner_name(kind, i));
    corners.push_back("corner_" + std::string(corner_name(kind, i)));
  }
  return {sentence, list_term(corners)};
}

/// The comment and the words of Statement.v. In the comment no line is long, but for numbers.
std::string statement_of(const std::string& name, Kind kind, const Answer& answer, const Separation& separation) {
  const auto& [one, other] = geometry::traits_of(kind);
  const ElementText first = element_text(kind, one.sort, 0), second = element_text(kind, other.sort, one.corners());
  const bool is_apart = separation.distance > 0, is_max = separation.metric == Metric::max;
  const NumberText distance = number_text(separation.distance);
  std::string touch = " touch";
  if (is_apart) {
    touch =
        " are at most " + distance.decimal + " apart" + (is_max ? " (by the greatest difference of coordinates)" : "");
  }
  std::string when, term;
  if (!answer.contact) {
    when = "at no time from 0 to 1";
    term = "No_contact";
  } else if (const NumberText from = number_text(answer.toi); answer.toi == answer.toi_upper) {
    when = "at the time " + from.decimal + ",\n   and at no time before it, from 0 on";
    term = "(Contact_at " + from.term + ')';
  } else {
    const NumberText to = number_text(answer.toi_upper);
    when = "at a time between " + from.decimal + " and " + to.decimal +
           ", which are neighbouring doubles,\n   and at no time from 0 to the first of them";
    term = "(Contact_between " + from.term + ' ' + to.term + ')';
  }
  std::string sentence = first.sentence + " and " + second.sentence + touch + '\n';
  sentence[0] = 'T';
  const std::string apart = !is_apart ? "Zero" : (is_max ? "Max " : "Euclidean ") + distance.term;
  return "(* " + sentence + "   " + when + ". *)\nTheorem " + name + " : holds\n  {| first := " + first.list +
         ";\n     second := " + second.list + ";\n     apart := " + apart + " |}\n  " + term + ".\n";
}

/// A text without what would end a comment of Coq, begin another one, or begin a string.
std::string for_comment(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    safe += c == '*' ? "\\x2a" : c == '"' ? "\\x22" : c == '\n' ? " " : std::string(1, c);
  }
  return safe;
}

template <class Q>
std::string theorem(const TheoremTitle& title, const Q& query, const Answer& answer, const Separation& separation) {
  const Proof proof = prove(query, answer, separation);
  const CornerDefinitions corners = corners_of(query);
  return "(* " + for_comment(title.origin) +
         "\n\n"
         "   The theorem is at the end. Its words are defined in Statement.v, which docs/proved.md of Touchstone "
         "shows.\n"
         "   The fractions are exact: 3 # 2^5 is 3/32. The decimals in comments are rounded.\n"
         "   This command of Coq 8.16 checks the file, THEORIES being the folder of Touchstone's compiled theories:\n\n"
         "     coqc -Q THEORIES Touchstone FILE.v\n\n"
         "   It prints the axioms that the theorem rests on: those of Coq's real numbers. *)\n"
         "From Coq Require Import ZArith QArith List.\n"
         "From Touchstone Require Import Statement Pieces Corners Checker.\n"
         "Import ListNotations.\n"
         "Open Scope Z_scope.\n\n"
         "(* What shows it, for `check` of Checker.v. None of these numbers has to be believed or read. *)\n" +
         certificate_of(corners, answer, proof) + '\n' + corners.text + '\n' +
         statement_of(title.name, corners.kind, answer, separation) +
         "Proof. apply check_sound with certificate. vm_cast_no_check (eq_refl true). Qed.\n"
         "Print Assumptions " +
         title.name + ".\n";
}

}  // namespace

std::string theorem_of(const TheoremTitle& title, const Query& query, const Answer& answer,
                       const Separation& separation) {
  return theorem(title, query, answer, separation);
}
std::string theorem_of(const TheoremTitle& title, const RationalQuery& query, const Answer& answer,
                       const Separation& separation) {
  return theorem(title, query, answer, separation);
}
std::string theorem_of(const TheoremTitle& title, const CurvedQuery& query, const Answer& answer,
                       const Separation& separation) {
  return theorem(title, query, answer, separation);
}

}  // namespace touchstone::proofs

// SPDX-License-Identifier: MIT
#include "proofs/proof_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "io/times.hpp"
#include "numbers/float_environment.hpp"
#include "proofs/pieces.hpp"

namespace touchstone::proofs {
namespace {

/// Integers below it are shorter in decimal than in hexadecimal digits.
constexpr int kShortDigits = 12;
constexpr double kShortInteger = 0x1p48;  // 16^kShortDigits

template <class I>
void append_integer(std::string& to, I value) {
  char digits[24];
  to.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append_polynomial(std::string& to, const Dense& p) {
  for (const Exact& c : p) {
    to += ' ';
    append_number(to, c);
  }
}

}  // namespace

void append_number(std::string& to, const Exact& x) {
  if (x.is_zero()) {
    to += '0';
    return;
  }
  if (x.sign() < 0) to += '-';
  // The limbs' hexadecimal digits, without the zeros at both ends.
  std::string digits;
  char limb[17];
  for (int i = x.limb_count(); i-- > 0;) {
    std::snprintf(limb, sizeof limb, "%016lx", x.limb(i));
    digits += limb;
  }
  long exponent = 64L * x.limb_exponent();
  while (digits.back() == '0') {
    digits.pop_back();
    exponent += 4;
  }
  digits.erase(0, digits.find_first_not_of('0'));
  if (exponent >= 0 && digits.size() + static_cast<std::size_t>(exponent) / 4 <= kShortDigits) {
    to += std::to_string(std::stoull(digits + std::string(static_cast<std::size_t>(exponent) / 4, '0'), nullptr, 16));
    return;
  }
  to += "0x" + digits + "p" + std::to_string(exponent);
}

void append_separation(std::string& to, const Separation& separation) {
  if (!(separation.distance > 0)) return;
  to += separation.metric == Metric::euclidean ? "separation euclidean " : "separation max ";
  to += io::hexfloat(separation.distance) + '\n';
}

void append_proof(std::string& to, std::uint64_t number, const Answer& answer, const Proof& proof) {
  append_integer(to, number);
  if (answer.contact) {
    to += " contact " + io::hexfloat(answer.toi) + ' ' + io::hexfloat(answer.toi_upper) + '\n';
  } else {
    to += " none\n";
  }
  for (const Piece& piece : proof.pieces) {
    if (piece.normal) {
      to += 'n';
    } else {
      to += 'd';
      std::size_t size = 0;
      for (const Dense& p : piece.direction.c) size = p.size() > size ? p.size() : size;
      for (std::size_t i = 0; i < size; ++i) {
        for (const Dense& p : piece.direction.c) {
          to += ' ';
          append_number(to, i < p.size() ? p[i] : Exact(0));
        }
      }
    }
    if (&piece != &proof.pieces.back()) {
      to += " to ";
      append_number(to, piece.until);
    }
    to += '\n';
  }
  if (!proof.meeting) return;
  const Meeting& meeting = *proof.meeting;
  if (!meeting.root.empty()) {
    to += "root";
    append_polynomial(to, meeting.root);
    if (meeting.low != Exact(answer.toi) || meeting.high != Exact(answer.toi_upper)) {
      to += " between ";
      append_number(to, meeting.low);
      to += ' ';
      append_number(to, meeting.high);
    }
    to += '\n';
  }
  for (std::size_t i = 0; i < meeting.weights.size(); ++i) {
    if (meeting.weights[i].empty()) continue;
    to += "w " + std::to_string(i);
    append_polynomial(to, meeting.weights[i]);
    to += '\n';
  }
}

void append_proof_of(std::string& to, std::uint64_t number, const Query& query, const Answer& answer,
                     const Separation& separation) {
  if (!answer.contact) {
    const numbers::DefaultFloatEnvironment environment;
    if (const auto quick = quick_direction(query, separation)) {
      append_integer(to, number);
      to += quick->normal ? " none\nn\n" : " none\nd";
      if (quick->normal) return;
      for (const double x : quick->integers) {
        to += ' ';
        if (std::fabs(x) < kShortInteger) {
          append_integer(to, static_cast<std::int64_t>(x));
        } else {
          append_number(to, Exact(x));
        }
      }
      to += '\n';
      return;
    }
  }
  append_proof(to, number, answer, prove(query, answer, separation));
}

void append_proof_of(std::string& to, std::uint64_t number, const RationalQuery& query, const Answer& answer,
                     const Separation& separation) {
  append_proof(to, number, answer, prove(query, answer, separation));
}

}  // namespace touchstone::proofs

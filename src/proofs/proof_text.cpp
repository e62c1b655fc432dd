// SPDX-License-Identifier: MIT
#include "proofs/proof_text.hpp"

#include <bit>
#include <charconv>
#include <cmath>

#include "io/times.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "proofs/quick_proof.hpp"

namespace touchstone::proofs {
namespace {

/// Integers below it are shorter in decimal than in hexadecimal digits.
constexpr std::uint64_t kShortInteger = std::uint64_t{1} << 48;

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
  const int count = x.limb_count();
  if (count == 1 && x.limb_exponent() == 0 && x.limb(0) < kShortInteger) return append_integer(to, x.limb(0));
  // The limbs' hexadecimal digits, without the zeros at both ends. The first and the last limb are not zero.
  const int zeros_after = std::countr_zero(x.limb(0)) / 4;
  const int zeros_before = std::countl_zero(x.limb(count - 1)) / 4;
  to += "0x";
  const std::size_t begin = to.size();
  to.resize(begin + static_cast<std::size_t>(16 * count - zeros_after - zeros_before));
  char* digit = to.data() + to.size();
  for (int i = zeros_after; digit != to.data() + begin; ++i) {
    *--digit = "0123456789abcdef"[x.limb(i / 16) >> (4 * (i % 16)) & 15];
  }
  to += 'p';
  append_integer(to, 64L * x.limb_exponent() + 4L * zeros_after);
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
    to += "w ";
    append_integer(to, i);
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
        if (std::fabs(x) < static_cast<double>(kShortInteger)) {
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

void append_proof_of(std::string& to, std::uint64_t number, const CurvedQuery& query, const Answer& answer,
                     const Separation& separation) {
  append_proof(to, number, answer, prove(query, answer, separation));
}

}  // namespace touchstone::proofs

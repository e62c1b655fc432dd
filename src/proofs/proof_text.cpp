// SPDX-License-Identifier: MIT
#include "proofs/proof_text.hpp"

#include <cstdio>

#include "io/times.hpp"

namespace touchstone::proofs {
namespace {

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
  constexpr std::size_t kShort = 12;  // digits of an integer that is shorter in decimal
  if (exponent >= 0 && digits.size() + static_cast<std::size_t>(exponent) / 4 <= kShort) {
    to += std::to_string(std::stoull(digits + std::string(static_cast<std::size_t>(exponent) / 4, '0'), nullptr, 16));
    return;
  }
  to += "0x" + digits + "p" + std::to_string(exponent);
}

void append_proof(std::string& to, std::uint64_t query, const Answer& answer, const Proof& proof) {
  to += std::to_string(query);
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
      for (const Dense& p : piece.direction) size = p.size() > size ? p.size() : size;
      for (std::size_t i = 0; i < size; ++i) {
        for (const Dense& p : piece.direction) {
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

}  // namespace touchstone::proofs

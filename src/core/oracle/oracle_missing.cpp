// In place of the second opinion, in a library that was built without CGAL. Questions for it are refused before they
// come here: solver/validate.hpp has the words.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "oracle/oracle.hpp"

namespace touchstone::oracle {
namespace {

[[noreturn]] void refuse() { throw InvalidQuery("this library was built without CGAL"); }

}  // namespace

bool is_present() noexcept { return false; }

Answer decide_by_oracle(const Query&, double) { refuse(); }
Answer decide_by_oracle(const RationalQuery&, double) { refuse(); }
Answer decide_by_oracle(const CurvedQuery&, double) { refuse(); }
Answer decide_by_oracle(const Query&, double, const Separation&) { refuse(); }
Answer decide_by_oracle(const RationalQuery&, double, const Separation&) { refuse(); }
Answer decide_by_oracle(const CurvedQuery&, double, const Separation&) { refuse(); }
double coplanarity_at(const Query&, double) { refuse(); }

}  // namespace touchstone::oracle

// In place of the second opinion, in a library that was built without CGAL.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "oracle/oracle.hpp"

namespace touchstone::oracle {
namespace {

[[noreturn]] void refuse() {
  throw InvalidQuery(
      "Method::oracle and Method::fast_cgal need CGAL, and this library was built without it; build it with "
      "-DTOUCHSTONE_WITH_CGAL=ON, or ask by Method::fast or Method::exact");
}

}  // namespace

Answer decide_by_oracle(const Query&, double) { refuse(); }
Answer decide_by_oracle(const RationalQuery&, double) { refuse(); }
Answer decide_by_oracle(const CurvedQuery&, double) { refuse(); }
Answer decide_by_oracle(const Query&, double, const Separation&) { refuse(); }
Answer decide_by_oracle(const RationalQuery&, double, const Separation&) { refuse(); }
Answer decide_by_oracle(const CurvedQuery&, double, const Separation&) { refuse(); }
double coplanarity_at(const Query&, double) { refuse(); }

}  // namespace touchstone::oracle

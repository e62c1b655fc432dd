// Queries with a separation in the Euclidean metric that were solved on paper.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "oracle/separated.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

const Separated euclidean{Metric::euclidean};

}  // namespace

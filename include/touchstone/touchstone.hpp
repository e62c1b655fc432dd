// Touchstone: robust, exact continuous collision detection.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/certify.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/error.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>
#include <touchstone/version.hpp>

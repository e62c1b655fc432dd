// Touchstone's drop-in for Tight-Inclusion: what it is, as the macros that Tight-Inclusion's users know.
// SPDX-License-Identifier: MIT
#pragma once

/// Defined by this drop-in only, so that a program can tell it from Tight-Inclusion.
#define TIGHT_INCLUSION_BY_TOUCHSTONE 1

#define TIGHT_INCLUSION_NAME "Touchstone's drop-in for Tight-Inclusion"

// The version of Tight-Inclusion whose interface this is.
#define TIGHT_INCLUSION_VER "1.0.6"
#define TIGHT_INCLUSION_VER_MAJOR "1"
#define TIGHT_INCLUSION_VER_MINOR "0"
#define TIGHT_INCLUSION_VER_PATCH "6"

/// `Scalar` is double. There is no drop-in for a Tight-Inclusion that was configured for single precision.
#define TIGHT_INCLUSION_WITH_DOUBLE_PRECISION

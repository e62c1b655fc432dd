// Functions that run for every query: vectors of doubles in registers are worth more there than short code.
// SPDX-License-Identifier: MIT
#pragma once

#if defined(__GNUC__)
#define TOUCHSTONE_INLINE __attribute__((always_inline)) inline
#else
#define TOUCHSTONE_INLINE inline
#endif

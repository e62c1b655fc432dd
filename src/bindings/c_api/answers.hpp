// The answers of the C interface have the layout of the C++ ones, so that a batch is written once, where it is wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

#include <touchstone/c.h>
#include <touchstone/answer.hpp>

namespace touchstone::c_api {

static_assert(std::is_standard_layout_v<Answer> && std::is_trivially_copyable_v<Answer>);
static_assert(sizeof(Answer) == sizeof(touchstone_answer) && alignof(Answer) == alignof(touchstone_answer));
static_assert(sizeof(bool) == 1);
static_assert(offsetof(Answer, contact) == offsetof(touchstone_answer, contact));
static_assert(offsetof(Answer, level) == offsetof(touchstone_answer, level));
static_assert(offsetof(Answer, nature) == offsetof(touchstone_answer, nature));
static_assert(offsetof(Answer, feature_a) == offsetof(touchstone_answer, feature_a));
static_assert(offsetof(Answer, feature_b) == offsetof(touchstone_answer, feature_b));
static_assert(offsetof(Answer, starts_within) == offsetof(touchstone_answer, starts_within));
static_assert(offsetof(Answer, trend) == offsetof(touchstone_answer, trend));
static_assert(offsetof(Answer, toi) == offsetof(touchstone_answer, toi));
static_assert(offsetof(Answer, toi_upper) == offsetof(touchstone_answer, toi_upper));
static_assert(offsetof(Answer, weights_a) == offsetof(touchstone_answer, weights_a));
static_assert(offsetof(Answer, weights_b) == offsetof(touchstone_answer, weights_b));

/// The same answer for C.
inline touchstone_answer c_answer(const Answer& answer) noexcept {
  touchstone_answer copy;
  std::memcpy(&copy, &answer, sizeof copy);
  copy.reserved = 0;
  return copy;
}

}  // namespace touchstone::c_api

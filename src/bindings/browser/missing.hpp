// What emscripten's standard library lacks up to version 3.1.6. Every source of a build for WebAssembly includes this
// first (see CMakeLists.txt), and no other build has it.
// SPDX-License-Identifier: MIT
#pragma once

#ifdef __cplusplus
#include <charconv>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <version>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class T>
unique_ptr<T> make_unique_for_overwrite(size_t count) {
  return unique_ptr<T>(new remove_extent_t<T>[count]);
}
#endif

#ifndef __cpp_lib_to_chars
to_chars_result to_chars(char* first, char* last, double value);
to_chars_result to_chars(char* first, char* last, double value, chars_format format);  ///< hex alone
from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format format = chars_format::general);
#endif

}  // namespace std
#endif

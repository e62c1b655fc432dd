// SPDX-License-Identifier: MIT
#include "view/pages/base64.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace touchstone::view {
namespace {

constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Takes bytes one by one.
class Encoder {
 public:
  explicit Encoder(std::size_t bytes) { text_.reserve((bytes + 2) / 3 * 4); }

  void add(std::uint8_t byte) {
    group_[filled_++] = byte;
    if (filled_ == 3) flush();
  }

  std::string finish() {
    if (filled_ > 0) {
      const std::size_t digits = filled_ + 1;
      for (std::size_t i = filled_; i < 3; ++i) group_[i] = 0;
      flush();
      for (std::size_t i = digits; i < 4; ++i) text_[text_.size() - 4 + i] = '=';
    }
    return std::move(text_);
  }

 private:
  void flush() {
    const unsigned bits = (unsigned{group_[0]} << 16U) | (unsigned{group_[1]} << 8U) | unsigned{group_[2]};
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text_ += kDigits[(bits >> shift) & 63U];
    filled_ = 0;
  }

  std::string text_;
  std::array<std::uint8_t, 3> group_{};
  std::size_t filled_ = 0;
};

template <std::size_t bytes>
using Unsigned = std::conditional_t<
    bytes == 1, std::uint8_t,
    std::conditional_t<bytes == 2, std::uint16_t, std::conditional_t<bytes == 4, std::uint32_t, std::uint64_t>>>;

}  // namespace

template <class Number>
std::string base64_of(const Number* numbers, std::size_t count) {
  Encoder encoder(count * sizeof(Number));
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<Unsigned<sizeof(Number)>>(numbers[i]);
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte) {
      encoder.add(static_cast<std::uint8_t>(bits >> (8 * byte)));
    }
  }
  return encoder.finish();
}

template std::string base64_of(const std::uint8_t*, std::size_t);
template std::string base64_of(const std::uint16_t*, std::size_t);
template std::string base64_of(const std::uint32_t*, std::size_t);
template std::string base64_of(const float*, std::size_t);
template std::string base64_of(const double*, std::size_t);

}  // namespace touchstone::view

// What is thrown when a program under test gives no reply that can be judged.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/error.hpp>
#include <touchstone/fuzz.hpp>

namespace touchstone::fuzz {

/// What a function under test throws when it gave no reply: a crash, a hang or words that are none.
class NoReply : public Error {
 public:
  NoReply(FuzzFailure failure, const std::string& reason) : Error(reason), failure_(failure) {}
  FuzzFailure failure() const noexcept { return failure_; }

 private:
  FuzzFailure failure_;
};

}  // namespace touchstone::fuzz

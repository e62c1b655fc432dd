// The check of an option whose values are kinds.
// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class Validator;
}

namespace touchstone::cli {

/// Its description names the kinds, for --help and the completions.
CLI::Validator kind_check();

}  // namespace touchstone::cli

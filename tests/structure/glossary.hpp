// The words of the sources: the identifiers of a text, the words in them, and the types that it defines.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::structure {

/// A name in a source text.
struct Name {
  std::string text;
  int line = 0;
};

/// The identifiers of a text in their order, keywords too: not those in comments, strings and #include lines.
std::vector<Name> identifiers_of(std::string_view text);

/// The words of an identifier in lower case, split at underscores, capitals and digits: "kPartBound2" has k, part,
/// bound and 2.
std::vector<std::string> words_of(std::string_view identifier);

/// A class, struct or enum that is defined in a namespace.
struct TypeName {
  std::string name;
  std::string scope;  ///< the namespace: "touchstone::mesh"; "" outside of all
  int line = 0;
};

/// The types that a text defines. Types in other types, in functions and in namespaces without a name are left out:
/// each of them belongs to one class or one file.
std::vector<TypeName> types_of(std::string_view text);

}  // namespace touchstone::structure

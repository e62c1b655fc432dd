// Claims in files that are read whole: JSON, lines of JSON, and NumPy's arrays.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/separation.hpp>

#include "io/answers/claim_columns.hpp"
#include "io/input_file.hpp"

namespace touchstone::cli {

struct ListedClaim {
  std::optional<std::string> file;     ///< nothing where the file does not name query files
  std::optional<std::uint64_t> query;  ///< nothing where the file does not count the queries
  bool contact = false;
  std::optional<double> toi;  ///< finite; only with contact
  std::optional<Separation> separation;
};

struct ListedClaims {
  std::vector<ListedClaim> claims;
  std::vector<std::string> unread;  ///< the names of what is not read
  bool implied_contacts = false;    ///< some claims have no 'contact': their toi says it, or else they claim one
};

/// Whether a file is read whole: .json, .jsonl, .ndjson, .npy, .npz, and one of another name that starts as JSON does.
bool is_list_of_claims(io::InputFile& file);

/// Reads
/// - JSON: a list of true and false (or 1 and 0), or of objects with the keys of claim_columns.hpp, or their columns as
///   as_records() reads them;
/// - lines of JSON: one such object each;
/// - .npy: an array of contacts, or rows of (query, contact, toi) or of what `columns` says;
/// - .npz: arrays that are named as columns, as numpy.savez(FILE, contact=..., toi=...) writes them.
/// The toi of a claim without contact may be anything, NaN and infinity too.
/// @param missing  with MissingClaim::no_contact those with the numbers of their queries may lack `contact`
/// @throws FileError
ListedClaims read_listed_claims(io::InputFile file, const io::ClaimColumns& columns, io::MissingClaim missing);

}  // namespace touchstone::cli

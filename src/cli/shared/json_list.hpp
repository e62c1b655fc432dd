// A file that is one JSON list.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "io/fail.hpp"
#include "io/whole_file.hpp"
#include "json/json_node.hpp"

namespace touchstone::cli {

/// What `read_item(node)` gives for each node of the list. @throws FileError  naming the file and the node at fault
template <class Item, class ReadItem>
std::vector<Item> read_json_list(const std::string& file, const ReadItem& read_item) {
  const auto content = io::WholeFile::read(file, io::kJsonLimits, throw_if_interrupted);
  try {
    const json::JsonDocument document = json::parse_json(content.bytes());
    std::vector<Item> all;
    for (const json::JsonNode& node : json::JsonNode(document.value(), "the list").items()) {
      all.push_back(read_item(node));
    }
    return all;
  } catch (const Error& error) {
    io::fail(file, error.what());
  }
}

}  // namespace touchstone::cli

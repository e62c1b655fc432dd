// SPDX-License-Identifier: MIT
#include "cli/shared/inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <touchstone/error.hpp>

#include "cli/queries/bundled.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_array.hpp"
#include "io/queries/separation_text.hpp"

namespace touchstone::cli {
namespace {

Input bundled_input(const BundledFile& file) {
  Input input;
  input.name = file.name;
  input.kind = io::kind_of_file(input.name, std::nullopt);
  input.bytes = file.content.size();
  input.content = file.content;
  input.bundled = true;
  return input;
}

const BundledFile* find_bundled(const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::exists(name, ignored)) return nullptr;
  const auto& files = bundled_files();
  const auto found = std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; });
  return found == files.end() ? nullptr : &*found;
}

}  // namespace

io::InputFile Input::open() const {
  return bundled ? io::InputFile::from_memory(name, content) : io::InputFile::open(name, throw_if_interrupted);
}

void refuse_standard_input_twice(const std::vector<std::string>& names) {
  if (std::count(names.begin(), names.end(), "-") < 2) return;
  throw Error("- is given twice, and standard input can be read once; name a file in place of one of them");
}

std::vector<Input> find_inputs(const std::vector<std::string>& names, std::optional<Kind> kind, io::Decimals decimals) {
  refuse_standard_input_twice(names);
  std::vector<Input> inputs;
  for (const auto& name : names) {
    if (const BundledFile* const bundled = find_bundled(name)) {
      inputs.push_back(bundled_input(*bundled));
      continue;
    }
    Input input;
    input.name = without_dash(name);
    input.bytes = io::InputFile::check(input.name);
    input.kind = io::kind_of_queries(input.name, kind);
    input.decimals = decimals;
    inputs.push_back(std::move(input));
  }
  return inputs;
}

std::vector<Input> bundled_inputs(io::Motions motions) {
  std::vector<Input> inputs;
  for (const auto& file : bundled_files()) {
    if (motions == io::Motions::any || !io::holds_curved_queries(file.content)) inputs.push_back(bundled_input(file));
  }
  if (inputs.empty()) io::fail("bundled queries", "this program was built without them; name a query file");
  return inputs;
}

std::vector<Input> bundled_touching_inputs(io::Motions motions) {
  std::vector<Input> inputs = bundled_inputs(motions);
  const auto about_separation = [](const Input& input) {
    return io::separation_of_comments(input.content).has_value();
  };
  inputs.erase(std::remove_if(inputs.begin(), inputs.end(), about_separation), inputs.end());
  return inputs;
}

QueryStream::QueryStream(const std::vector<Input>& inputs, std::size_t chunk_bytes, io::Motions motions)
    : inputs_(inputs), chunk_bytes_(chunk_bytes), motions_(motions) {}

bool QueryStream::next(QueryItem& item) {
  for (; current_ < inputs_.size(); ++current_, reader_.reset()) {
    const Input& input = inputs_[current_];
    if (!reader_) reader_.emplace(input.open(), input.kind, chunk_bytes_, motions_, input.decimals);
    if (auto chunk = reader_->next()) {
      item.input = current_;
      item.chunk = std::move(*chunk);
      return true;
    }
  }
  return false;
}

void for_each_query(const std::vector<Input>& inputs,
                    const std::function<void(std::size_t, const io::QueryRecord&)>& take, io::Motions motions) {
  QueryStream stream(inputs, io::kChunkBytes, motions);
  QueryItem item;
  while (stream.next(item)) {
    throw_if_interrupted();
    io::QueryParser parser(item.chunk);
    io::QueryRecord record;
    while (parser.next(record)) take(item.input, record);
  }
}

}  // namespace touchstone::cli

// SPDX-License-Identifier: MIT
#include "proofs/small_proofs.hpp"

#include "proofs/run_checker.hpp"
#include "support/catch.hpp"

namespace touchstone::tests {
namespace {

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

Lines operator+(Lines first, const Lines& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string rows(const std::vector<Corner>& starts, const std::vector<Corner>& ends) {
  std::string text;
  for (const auto* corners : {&starts, &ends}) {
    for (const Corner& c : *corners) text += std::string(c[0]) + ",1," + c[1] + ",1," + c[2] + ",1,0\n";
  }
  return text;
}
std::string on_axis(const char* start, const char* end) {
  return rows({{"0", "0", "0"}, {start, "0", "0"}}, {{"0", "0", "0"}, {end, "0", "0"}});
}

std::string proofs_of(const std::string& kind, const Lines& lines, const std::string& separation) {
  const bool contact = !lines.empty() && lines[0].rfind("0 contact", 0) == 0;
  const std::string before = separation.empty() ? "" : "separation " + separation + "\n";
  return "touchstone-proofs 1\n" + before + "file " + kind + " - queries.csv\n" + joined(lines) + "end 1 " +
         (contact ? "1" : "0") + "\n";
}

void accept(const std::string& kind, const std::string& query, const Lines& lines, const std::string& separation) {
  const std::string proofs = proofs_of(kind, lines, separation);
  const CheckerRun run = check_texts(proofs, {query});
  INFO(proofs << query << run.text);
  CHECK(run.status == 0);
  CHECK(run.text.find("1 query checked: ") != std::string::npos);
}
void refuse_with(int status, const std::string& message, const std::string& proofs,
                 const std::vector<std::string>& files) {
  const CheckerRun run = check_texts(proofs, files);
  std::string all;
  for (const std::string& file : files) all += file.substr(0, 1000);
  INFO(proofs.substr(0, 2000) << all << run.text);
  CHECK(run.status == status);
  CHECK(run.text.find(message) != std::string::npos);
  CHECK(run.text.find(" checked: ") == std::string::npos);
}
void reject(const std::string& message, const std::string& kind, const std::string& query, const Lines& lines,
            const std::string& separation) {
  refuse_with(1, message, proofs_of(kind, lines, separation), {query});
}
void call_bad(const std::string& message, const std::string& kind, const std::string& query, const Lines& lines,
              const std::string& separation) {
  refuse_with(2, message, proofs_of(kind, lines, separation), {query});
}

}  // namespace touchstone::tests

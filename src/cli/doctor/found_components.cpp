// SPDX-License-Identifier: MIT
#include "cli/doctor/found_components.hpp"

#include <filesystem>
#include <optional>
#include <system_error>

#include "io/fail.hpp"
#include "report/pictures/find_program.hpp"
#include "report/pictures/gnuplot.hpp"

namespace touchstone::cli {
namespace {

/// The checker of proofs beside this program, or in PATH.
std::optional<std::string> find_checker() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto beside = self.parent_path() / "touchstone-check";
    if (std::filesystem::is_regular_file(beside, error)) return beside.string();
  }
  return report::find_program("touchstone-check");
}

BuildComponent component(const char* name, const std::optional<std::string>& path, const char* without,
                         const char* package) {
  return {name, path.has_value(), path ? io::printable(*path) : std::string(without), package};
}

}  // namespace

std::vector<BuildComponent> found_components() {
  return {
      component("plots", report::find_gnuplot(), "gnuplot is not in PATH: report, stress and simulate draw no plots",
                "gnuplot-nox"),
      component("proof checker", find_checker(), "touchstone-check is neither beside this program nor in PATH", "")};
}

}  // namespace touchstone::cli

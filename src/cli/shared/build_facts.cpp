// SPDX-License-Identifier: MIT
#include "cli/shared/build_facts.hpp"

#include <fmt/format.h>

#include <string_view>

#include <touchstone/solve.hpp>
#include <touchstone/vector_width.hpp>
#include <touchstone/version.hpp>

#include "cli/shared/written_facts.hpp"
#include "numbers/integers/library_versions.hpp"

namespace touchstone::cli {
namespace {

/// "oneTBB 2021.8.0"; the name alone where the version is not known.
std::string versioned(std::string_view name, std::string_view version) {
  return version.empty() ? std::string(name) : fmt::format("{} {}", name, version);
}

std::string line(std::string_view heading, std::string_view text) { return fmt::format("{:<14} {}\n", heading, text); }

std::string libraries() {
  std::string text;
  for (const auto& library : numbers::library_versions()) {
    text += versioned(library.name, library.compiled);
    if (library.running != library.compiled) text += " (running with " + library.running + ")";
    text += ", ";
  }
  return text + versioned("Eigen", written::kEigen) + ", " + versioned("CLI11", written::kCli11) + ", " +
         versioned("fmt", written::kFmt) + ", " + versioned("nlohmann-json", written::kJson);
}

}  // namespace

std::vector<BuildComponent> build_components() {
  const auto details = [](bool there, const std::string& with, const char* without) {
    return there ? with : std::string(without);
  };
  return {
      {"threads", written::kHasTbb,
       details(written::kHasTbb, versioned("oneTBB", written::kTbb),
               "built without oneTBB: one thread does all the work"),
       "libtbb-dev"},
      {"HDF5 files", written::kHasHdf5,
       details(written::kHasHdf5, versioned("libhdf5", written::kHdf5),
               "built without libhdf5: mesh reads no such files"),
       "libhdf5-dev"},
      {"VTK XML files", written::kHasExpat && written::kHasZlib,
       details(written::kHasExpat,
               versioned("expat", written::kExpat) +
                   (written::kHasZlib ? " and zlib" : ", without zlib: mesh reads no compressed ones"),
               "built without expat: mesh reads no .vtu and .vtp"),
       "libexpat1-dev zlib1g-dev"},
      {"Python module", written::kHasPython,
       details(written::kHasPython, "import touchstone", "built without NumPy's and Python's headers and pybind11"),
       "python3-dev python3-numpy pybind11-dev"},
      {"drop-in", written::kHasTightInclusion,
       details(written::kHasTightInclusion, "tight_inclusion::tight_inclusion", "built without Eigen"),
       "libeigen3-dev"},
  };
}

std::string vectors_in_use() {
  if (has_vectors(VectorWidth::bits_512)) return "512 bits";
  if (has_vectors(VectorWidth::bits_256)) return "256 bits";
  return "128 bits";
}

std::string text_of(const std::vector<BuildComponent>& components) {
  std::string text;
  for (const BuildComponent& component : components) {
    text += line(component.name, fmt::format("{:<4} {}", component.there ? "yes" : "no", component.details));
    if (component.there || component.package.empty()) continue;
    text.pop_back();
    text += "; Debian: " + component.package + "\n";
  }
  return text;
}

std::string build_facts() {
  std::string text = std::string("touchstone ") + version() + "\n";
  const char* const type = *written::kBuildType == '\0' ? "none" : written::kBuildType;
  text += line("build", fmt::format("{}, {} library, for {}", type, written::kSharedLibrary ? "shared" : "static",
                                    written::kSystem));
  text += line("compiler", fmt::format("{}, C++{}", written::kCompiler, __cplusplus / 100 % 100));
  text += line("flags", written::kFlags);
  text += line("libraries", libraries());
  text += line("SIMD", vectors_in_use() + " on this processor");
  return text;
}

}  // namespace touchstone::cli

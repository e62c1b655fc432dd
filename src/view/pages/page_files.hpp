// The styles and scripts of the pages: the files of src/view/pages/assets, embedded by src/core/cmake/embed.cmake.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace touchstone::view {

struct PageFile {
  std::string name;  ///< "style.css"
  std::string content;
};

const std::vector<PageFile>& page_files();

}  // namespace touchstone::view

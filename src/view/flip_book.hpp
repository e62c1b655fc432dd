// Pictures one after the other again and again, as an SVG file that needs no script.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchstone::view {

struct FlipBook {
  int width = 0, height = 0;  ///< of the picture, in its units
  std::string title;          ///< text: what one sees
  std::string about;          ///< text: more of it; may be empty
  std::string attributes;     ///< of the root element; may be empty
  std::string style;          ///< CSS
  std::string background;     ///< elements that all frames have behind them
  std::vector<std::string> frames;
  std::size_t still = 0;  ///< the frame that is shown where nothing moves, as in print
  double seconds_each = 0.1;
  double seconds_of_still = 0.1;  ///< at least seconds_each
};

/// The whole file. A title and a description say to all readers what one sees.
std::string svg_file(const FlipBook& book);

}  // namespace touchstone::view

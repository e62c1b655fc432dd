// SPDX-License-Identifier: MIT
#include "view/flip_book.hpp"

#include <fmt/format.h>

#include "view/pages/html.hpp"

namespace touchstone::view {
namespace {

/// Shows an element for some of the time, again and again.
std::string keyframes(const char* name, double fraction) {
  return fmt::format("@keyframes {}{{0%{{visibility:visible}}{:.4f}%{{visibility:hidden}}100%{{visibility:hidden}}}}\n",
                     name, 100 * fraction);
}

}  // namespace

std::string svg_file(const FlipBook& book) {
  const auto count = static_cast<double>(book.frames.size());
  const double length = book.seconds_each * (count - 1) + book.seconds_of_still;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\"{} viewBox=\"0 0 {} {}\" role=\"img\">\n<title>{}</title>\n",
      book.attributes, book.width, book.height, escaped(book.title));
  if (!book.about.empty()) text += "<desc>" + escaped(book.about) + "</desc>\n";
  text += fmt::format(
      "<style>{}\n.f{{visibility:hidden;animation:show {:.2f}s steps(1) infinite}}.s{{visibility:visible}}\n",
      book.style, length);
  text += keyframes("show", book.seconds_each / length);
  if (book.seconds_of_still > book.seconds_each) {
    text += ".s{animation-name:hold}" + keyframes("hold", book.seconds_of_still / length);
  }
  text += "@media(prefers-reduced-motion:reduce){.f{animation:none}}</style>\n" + book.background;
  double start = 0;
  for (std::size_t i = 0; i < book.frames.size(); ++i) {
    text += fmt::format("<g class=\"f{}\" style=\"animation-delay:{:.2f}s\">\n{}</g>\n", i == book.still ? " s" : "",
                        start - length, book.frames[i]);
    start += i == book.still ? book.seconds_of_still : book.seconds_each;
  }
  return text + "</svg>\n";
}

}  // namespace touchstone::view

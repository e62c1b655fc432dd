// The structure of a VTK XML file, through expat. Values of arrays are not looked at. Appended data may be bytes, which
// are no XML: expat is stopped before them.
// SPDX-License-Identifier: MIT
#include "frames/vtk/xml_document.hpp"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <limits>
#include <memory>
#include <utility>

#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

constexpr std::array<std::string_view, 10> kXmlTypes = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                                        "UInt32", "Int64", "UInt64", "Float32", "Float64"};
constexpr std::array<std::string_view, 3> kXmlFormats = {"ascii", "binary", "appended"};
constexpr std::array<std::string_view, kXmlSections> kXmlSectionNames = {"Verts",  "Lines", "Polys",
                                                                         "Strips", "Cells", "Points"};
constexpr std::array<std::string_view, kXmlSections> kXmlCounts = {"NumberOfVerts",  "NumberOfLines", "NumberOfPolys",
                                                                   "NumberOfStrips", "NumberOfCells", "NumberOfPoints"};
constexpr std::array<std::string_view, 3> kXmlNames = {"connectivity", "offsets", "types"};

template <std::size_t n>
std::size_t index_of(const std::array<std::string_view, n>& names, std::string_view name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

bool is_white(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// Names and values of attributes, as expat has them.
class Attributes {
 public:
  explicit Attributes(const XML_Char** all) : all_(all) {}

  std::optional<std::string_view> find(std::string_view name) const {
    for (const XML_Char** at = all_; *at != nullptr; at += 2) {
      if (*at == name) return at[1];
    }
    return std::nullopt;
  }

  std::string_view value_or(std::string_view name, std::string_view otherwise) const {
    return find(name).value_or(otherwise);
  }

 private:
  const XML_Char** all_;
};

class DocumentReader {
 public:
  DocumentReader(std::string_view file, std::string_view content)
      : file_(file), content_(content), parser_(XML_ParserCreate("UTF-8"), XML_ParserFree) {
    if (parser_ == nullptr) throw std::bad_alloc();
  }

  XmlDocument read() {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* name, const XML_Char** attributes) {
          guarded(self, [&](DocumentReader& reader) { reader.start(name, Attributes(attributes)); });
        },
        [](void* self, const XML_Char*) { guarded(self, [](DocumentReader& reader) { reader.end(); }); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const XML_Char* text, int size) {
      guarded(self, [&](DocumentReader& reader) { reader.characters({text, static_cast<std::size_t>(size)}); });
    });
    // Entities are declared in one, and a file of few bytes may declare a text of any length.
    XML_SetStartDoctypeDeclHandler(
        parser_.get(), [](void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
          guarded(self, [](DocumentReader& reader) { reader.fail("has a DOCTYPE, which no VTK file has"); });
        });
    parse();
    if (!is_appended_) return std::move(document_);
    find_appended();
    return std::move(document_);
  }

 private:
  /// Exceptions do not go through expat, which is written in C.
  template <class Call>
  static void guarded(void* self, Call call) {
    auto& reader = *static_cast<DocumentReader*>(self);
    if (reader.error_ != nullptr) return;
    try {
      call(reader);
    } catch (...) {
      reader.error_ = std::current_exception();
      XML_StopParser(reader.parser_.get(), XML_FALSE);
    }
  }

  void parse() {
    for (std::string_view remaining = content_;;) {
      constexpr std::size_t kMost = std::numeric_limits<int>::max() / 2;
      const std::size_t size = std::min(remaining.size(), kMost);
      const bool is_last = size == remaining.size();
      const XML_Status status = XML_Parse(parser_.get(), remaining.data(), static_cast<int>(size), is_last ? 1 : 0);
      if (error_ != nullptr) std::rethrow_exception(error_);
      if (is_appended_) return;
      if (status != XML_STATUS_OK) {
        const XML_Error code = XML_GetErrorCode(parser_.get());
        if (code == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
        fail("is no XML: " + std::string(XML_ErrorString(code)));
      }
      if (is_last) return;
      remaining.remove_prefix(size);
    }
  }

  std::uint64_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }
  [[noreturn]] void fail(std::string_view reason) const { io::fail(file_, line(), reason); }

  /// The bytes before the tag that expat is at.
  std::size_t tag_start() const { return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())); }
  std::size_t tag_end() const { return tag_start() + static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get())); }

  void start(std::string_view name, const Attributes& attributes) {
    if (skipped_ > 0) {
      ++skipped_;
      return;
    }
    const auto refuse = [&](const char* right) {
      fail("the element " + io::in_quotes(name) + " where " + right + " should be");
    };
    switch (level_) {
      case Level::file:
        if (name != "VTKFile") refuse("VTKFile");
        read_header(attributes);
        break;
      case Level::vtk_file:
        if (name == "AppendedData") return stop_at_appended(attributes);
        if (name != (document_.is_grid ? "UnstructuredGrid" : "PolyData")) refuse("the data set");
        if (std::exchange(has_data_set_, true)) fail("has a second data set");
        break;
      case Level::data_set:
        if (name == "FieldData") return skip();
        if (name != "Piece") refuse("Piece");
        read_piece(attributes);
        break;
      case Level::piece:
        if (name == "PointData" || name == "CellData") return skip();
        if (!is_section(name)) refuse("a list of points or cells");
        break;
      case Level::section:
        if (name != "DataArray") refuse("DataArray");
        read_array(attributes);
        break;
      case Level::array:
        close_text();
        if (name != "InformationKey") refuse("the end of the array");
        return skip();
    }
    level_ = static_cast<Level>(static_cast<int>(level_) + 1);
  }

  void skip() { skipped_ = 1; }

  void end() {
    if (skipped_ > 0) {
      --skipped_;
      return;
    }
    if (level_ == Level::array) close_text();
    level_ = static_cast<Level>(static_cast<int>(level_) - 1);
  }

  void characters(std::string_view text) const {
    if (skipped_ == 0 && !text_start_ && !is_white(text)) fail("has text where only elements should be");
  }

  void read_header(const Attributes& attributes) {
    const std::string_view type = attributes.value_or("type", "");
    document_.is_grid = type == "UnstructuredGrid";
    if (!document_.is_grid && type != "PolyData") {
      fail("VTKFile of type " + io::in_quotes(type) + "; UnstructuredGrid and PolyData are read");
    }
    const std::string_view version = attributes.value_or("version", "1.0");
    const bool is_number = version.size() >= 3 && version[1] == '.' && version[0] >= '0' && version[0] <= '2' &&
                           version.find_first_not_of("0123456789", 2) == std::string_view::npos;
    if (!is_number) {
      fail("version " + io::in_quotes(version) + "; known are 0.1 to 2.3");
    }
    if (const auto order = attributes.find("byte_order")) {
      if (*order != "LittleEndian" && *order != "BigEndian") {
        fail("byte_order " + io::in_quotes(*order) + "; right are LittleEndian and BigEndian");
      }
      document_.order = *order == "BigEndian" ? std::endian::big : std::endian::little;
    }
    const std::string_view header = attributes.value_or("header_type", "UInt32");
    if (header != "UInt32" && header != "UInt64") {
      fail("header_type " + io::in_quotes(header) + "; right are UInt32 and UInt64");
    }
    document_.header_size = header == "UInt64" ? 8 : 4;
    document_.compressor = attributes.value_or("compressor", "");
  }

  void read_piece(const Attributes& attributes) {
    XmlPiece piece;
    piece.line = line();
    for (std::size_t i = 0; i < kXmlSections; ++i) {
      if (attributes.find(kXmlCounts[i])) piece.counts[i] = number(attributes, kXmlCounts[i]);
    }
    if (!attributes.find("NumberOfPoints")) fail("a Piece without NumberOfPoints");
    document_.pieces.push_back(std::move(piece));
  }

  /// @returns whether there is such a list in this data set
  bool is_section(std::string_view name) {
    const std::size_t index = index_of(kXmlSectionNames, name);
    if (index == kXmlSections) return false;
    section_ = static_cast<XmlSection>(index);
    return section_ == XmlSection::points || (section_ == XmlSection::cells) == document_.is_grid;
  }

  void read_array(const Attributes& attributes) {
    const std::string_view type = attributes.value_or("type", ""), format = attributes.value_or("format", "ascii");
    const std::size_t type_index = index_of(kXmlTypes, type), format_index = index_of(kXmlFormats, format);
    if (type_index == kXmlTypes.size()) fail("a DataArray of type " + io::in_quotes(type) + ", which is not read");
    if (format_index == kXmlFormats.size()) {
      fail("a DataArray of format " + io::in_quotes(format) + "; right are ascii, binary and appended");
    }
    const XmlName name = static_cast<XmlName>(index_of(kXmlNames, attributes.value_or("Name", "")));
    const std::string_view tag = content_.substr(tag_start(), tag_end() - tag_start());
    const auto last_line = line() + static_cast<std::uint64_t>(std::count(tag.begin(), tag.end(), '\n'));
    XmlArray array{section_, name, static_cast<XmlType>(type_index), static_cast<XmlFormat>(format_index), last_line, 1,
                   0,        {}};
    if (attributes.find("NumberOfComponents")) array.components = number(attributes, "NumberOfComponents");
    if (array.format == XmlFormat::appended) array.offset = number(attributes, "offset");
    document_.pieces.back().arrays.push_back(array);
    text_start_ = tag_end();
  }

  void close_text() {
    if (!text_start_) return;
    const std::size_t end = std::max(tag_start(), *text_start_);
    document_.pieces.back().arrays.back().text = content_.substr(*text_start_, end - *text_start_);
    text_start_.reset();
  }

  std::uint64_t number(const Attributes& attributes, std::string_view name) const {
    const std::string_view text = attributes.value_or(name, "");
    std::uint64_t value = 0;
    const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr std::uint64_t kMostNumber = std::uint64_t{1} << 40;
    if (text.empty() || error != std::errc{} || last != text.data() + text.size() || value > kMostNumber) {
      fail(std::string(name) + " is " + io::in_quotes(text) + "; it must be a number from 0 to 2^40");
    }
    return value;
  }

  void stop_at_appended(const Attributes& attributes) {
    const std::string_view encoding = attributes.value_or("encoding", "");
    document_.is_raw = encoding == "raw";
    if (encoding != "raw" && encoding != "base64") {
      fail("AppendedData with the encoding " + io::in_quotes(encoding) + "; right are raw and base64");
    }
    if (!has_data_set_) fail("AppendedData before the data set");
    is_appended_ = true;
    appended_start_ = tag_end();
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  /// The bytes between the underscore and the end of AppendedData, after which only the end of VTKFile may come.
  void find_appended() {
    constexpr std::string_view kEnd = "</AppendedData>", kLast = "</VTKFile>";
    const std::size_t underscore = content_.find_first_not_of(" \t\r\n", appended_start_);
    const std::size_t end = content_.rfind(kEnd);
    if (end == std::string_view::npos || underscore >= end) fail("has no whole AppendedData: the file is cut off");
    if (content_[underscore] != '_') fail("AppendedData does not begin with an underscore");
    const std::string_view rest = content_.substr(end + kEnd.size());
    const std::size_t last = std::min(rest.find(kLast), rest.size());
    if (last == rest.size() || !is_white(rest.substr(0, last)) || !is_white(rest.substr(last + kLast.size()))) {
      fail("has something else after AppendedData than the end of VTKFile");
    }
    document_.appended = content_.substr(underscore + 1, end - underscore - 1);
  }

  enum class Level : std::uint8_t { file, vtk_file, data_set, piece, section, array };

  std::string_view file_, content_;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser_;
  std::exception_ptr error_;
  XmlDocument document_;
  Level level_ = Level::file;  ///< the innermost element that is open
  std::uint64_t skipped_ = 0;  ///< the elements that are open, from one on that is not looked at
  bool has_data_set_ = false;
  XmlSection section_ = XmlSection::points;
  std::optional<std::size_t> text_start_;  ///< while the values of an array go on
  bool is_appended_ = false;
  std::size_t appended_start_ = 0;
};

}  // namespace

XmlDocument read_xml_document(std::string_view file, std::string_view content) {
  return DocumentReader(file, content).read();
}

}  // namespace touchstone::frames

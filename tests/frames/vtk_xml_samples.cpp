// SPDX-License-Identifier: MIT
#include "frames/vtk_xml_samples.hpp"

#include <algorithm>

namespace touchstone::tests {
namespace {

using Numbers = std::vector<int>;

std::string text_array(const std::string& attributes, const std::string& values) {
  return "<DataArray " + attributes + " format=\"ascii\">\n" + values + "\n</DataArray>\n";
}

std::string decimals() {
  std::string text;
  for (const double x : kDoubles) text += decimal(x) + (text.size() % 3 == 0 ? "\n" : " ");
  return text;
}

/// Of text, with all that is not looked at.
Sample grid_of_text() {
  const std::string key = "<InformationKey name=\"RANGE\"><Value index=\"0\">1</Value></InformationKey>";
  return {"text.vtu",
          "<?xml version=\"1.0\"?>\n<!-- a > b -->\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n"
          "<UnstructuredGrid><FieldData>" +
              text_array("type=\"Float64\" Name=\"TIME\"", "0.5") +
              "</FieldData>\n<Piece NumberOfPoints=\"6\" NumberOfCells=\"4\">\n<PointData Scalars=\"a\">" +
              text_array("type=\"String\" Name=\"a\"", "junk &amp; more") + "</PointData>\n<Points>\n" +
              text_array("type=\"Float64\" NumberOfComponents=\"3\"", decimals() + key) + "</Points>\n<Cells>\n" +
              text_array("type=\"Int32\" Name=\"connectivity\"", "0 1 2\n0 2 3 3 4\t5") +
              text_array("type=\"Int32\" Name=\"offsets\"", "3 6 8 9") +
              text_array("type=\"UInt8\" Name=\"types\"", "5 7 3 1") +
              "</Cells>\n<CellData/></Piece></UnstructuredGrid>\n</VTKFile>\n",
          false, true, true};
}

template <class Coordinate, class Index>
Sample grid_of_bytes(const std::string& name, const XmlStyle& style, const std::string& index_type) {
  const bool floats = sizeof(Coordinate) == 4;
  XmlWriter writer(style);
  const std::string type = "type=\"" + index_type + "\" Name=";
  std::string piece =
      "<Piece NumberOfPoints=\"6\" NumberOfCells=\"4\"><Points>" +
      writer.numbers<Coordinate>(std::string("type=\"Float") + (floats ? "32" : "64") + "\" NumberOfComponents=\"3\"",
                                 floats ? kFloats : kDoubles);
  piece += "</Points><Cells>" + writer.numbers<Index>(type + "\"connectivity\"", Numbers{0, 1, 2, 0, 2, 3, 3, 4, 5});
  piece += writer.numbers<Index>(type + "\"offsets\"", Numbers{3, 6, 8, 9});
  piece += writer.numbers<std::uint8_t>("type=\"UInt8\" Name=\"types\"", Numbers{5, 5, 3, 1}) + "</Cells></Piece>";
  return {name, writer.file("UnstructuredGrid", piece), floats, true, true};
}

Sample poly_data(const std::string& name, const XmlStyle& style) {
  XmlWriter writer(style);
  const auto list = [&](const std::string& element, const Numbers& corners, const Numbers& ends) {
    std::string text =
        "<" + element + ">" + writer.numbers<std::int64_t>("type=\"Int64\" Name=\"connectivity\"", corners);
    text += writer.numbers<std::int64_t>("type=\"Int64\" Name=\"offsets\"", ends);
    return text + "</" + element + ">";
  };
  std::string piece =
      "<Piece NumberOfPoints=\"6\" NumberOfVerts=\"1\" NumberOfLines=\"1\" NumberOfStrips=\"0\" NumberOfPolys=\"2\">"
      "<Points>" +
      writer.numbers<float>("type=\"Float32\" NumberOfComponents=\"3\"", kFloats) + "</Points>";
  piece += list("Verts", {5}, {1}) + list("Lines", {3, 4}, {2}) + list("Strips", {}, {});
  piece += list("Polys", {0, 1, 2, 0, 2, 3}, {3, 6}) + "</Piece>";
  return {name, writer.file("PolyData", piece), true, true, true};
}

}  // namespace

std::string stored(std::string_view bytes) {
  std::string text("\x78\x01", 2);
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(bytes.size());
  text += '\1' + bytes_of(size, std::endian::little) +
          bytes_of(static_cast<std::uint16_t>(~size & 0xFFFF), std::endian::little);
  return text.append(bytes) + bytes_of(b << 16 | a, std::endian::big);
}

std::string XmlWriter::header(const std::vector<std::size_t>& numbers) const {
  std::string bytes;
  for (const std::size_t number : numbers) {
    bytes += style_.header_size == 8 ? bytes_of(std::uint64_t{number}, style_.order)
                                     : bytes_of(static_cast<std::uint32_t>(number), style_.order);
  }
  return bytes;
}

std::string XmlWriter::values(std::string_view bytes) const {
  std::string start = header({bytes.size()}), rest(bytes);
  if (style_.block != 0) {
    const std::size_t blocks = (bytes.size() + style_.block - 1) / style_.block;
    std::vector<std::size_t> numbers = {blocks, style_.block, bytes.size() % style_.block};
    rest.clear();
    for (std::size_t at = 0; at < bytes.size(); at += style_.block) {
      const std::string block = stored(bytes.substr(at, style_.block));
      numbers.push_back(block.size());
      rest += block;
    }
    start = header(numbers);
  }
  if (style_.appended && style_.raw) return start + rest;
  return style_.joined ? base64(start + rest) : base64(start) + base64(rest);
}

std::string XmlWriter::array(const std::string& attributes, std::string_view bytes) {
  const std::string text = values(bytes);
  if (!style_.appended) return "<DataArray " + attributes + " format=\"binary\">\n  " + text + "\n</DataArray>\n";
  const std::string offset = std::to_string(appended_.size());
  appended_ += text;
  return "<DataArray " + attributes + " format=\"appended\" offset=\"" + offset + "\"/>\n";
}

std::string XmlWriter::file(const std::string& data_set, const std::string& pieces) const {
  std::string text = "<VTKFile type=\"" + data_set + "\" version=\"1.0\" byte_order=\"" +
                     (style_.order == std::endian::big ? "BigEndian" : "LittleEndian") + "\" header_type=\"" +
                     (style_.header_size == 8 ? "UInt64" : "UInt32") + "\"" +
                     (style_.block != 0 ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<" + data_set + ">\n" +
                     pieces + "</" + data_set + ">\n";
  if (style_.appended) {
    text += std::string("<AppendedData encoding=\"") + (style_.raw ? "raw" : "base64") + "\">\n   _" + appended_ +
            "\n  </AppendedData>\n";
  }
  return text + "</VTKFile>\n";
}

std::vector<Sample> vtk_xml_samples() {
  if (!kReadsVtkXml) return {};
  const std::endian big = std::endian::big, little = std::endian::little;
  std::vector<Sample> samples = {
      grid_of_text(), grid_of_bytes<double, std::int64_t>("inline.vtu", {little, 4, 0, false, false, true}, "Int64"),
      grid_of_bytes<float, std::uint16_t>("big.vtu", {big, 8, 0, false, false, false}, "UInt16"),
      grid_of_bytes<double, std::int32_t>("raw.vtu", {little, 8, 0, true, true, false}, "Int32"),
      poly_data("appended.vtp", {big, 4, 0, true, false, false})};
  if (kInflates) {
    samples.push_back(grid_of_bytes<double, std::int8_t>("zlib.vtu", {little, 8, 25, true, true, false}, "Int8"));
    samples.push_back(grid_of_bytes<double, std::uint32_t>("blocks.vtu", {big, 4, 12, true, false, false}, "UInt32"));
    samples.push_back(poly_data("zlib.vtp", {little, 4, 1000, false, false, false}));
  }
  return samples;
}

}  // namespace touchstone::tests

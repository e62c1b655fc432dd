// SPDX-License-Identifier: MIT
#include "sequence/results_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "geometry/kind_traits.hpp"
#include "io/answers/answer_writer.hpp"
#include "io/fail.hpp"
#include "io/times.hpp"

namespace touchstone::sequence {
namespace {

using json::JsonNode;

constexpr std::uint64_t kMostNumber = std::uint64_t{1} << 33;  // 2^32 - 1, and files that count from 1

std::string json_of(const NamedElement& element) {
  std::string text = fmt::format("{{\"element\":\"{}\"", name_of(element.element));
  if (element.element == MeshElement::face) text += fmt::format(",\"number\":{}", element.face);
  text += ",\"vertices\":[";
  for (std::size_t i = 0; i < element.corner_count(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ",", element.vertices[i]);
  }
  text += "]";
  if (!element.part.empty()) text += ",\"part\":" + json_string(element.part);
  return text + "}";
}

std::string json_of(const PairContact& pair) { return contact_json(pair); }

std::string json_of(const RestContact& contact) {
  return fmt::format("{{\"first\":{},\"second\":{},\"sort\":\"{}\"}}", json_of(contact.first), json_of(contact.second),
                     name_of(contact.sort));
}

std::string json_of(const EnclosedCounts& enclosed) {
  return fmt::format("{{\"surfaces\":{},\"wires\":{},\"points\":{},\"vertex\":{},\"face\":{}}}", enclosed.surfaces,
                     enclosed.wires, enclosed.points, json_of(enclosed.vertex), json_of(enclosed.face));
}

/// A hexfloat is a string, and a decimal a number.
std::string json_of(double value, io::Numbers form) {
  const std::string text = io::number_text(value, form);
  return form == io::Numbers::hexfloats ? "\"" + text + "\"" : text;
}

std::string json_of(const Clearance& clearance, io::Numbers form) {
  if (clearance.distance == std::numeric_limits<double>::infinity()) return "{\"distance\":null}";
  std::string text = "{\"distance\":" + json_of(clearance.distance, form);
  if (clearance.pairs == 0) return text + "}";
  return text + fmt::format(",\"toi\":{},\"toi_upper\":{},\"pairs\":{},\"pair\":{}}}", json_of(clearance.toi, form),
                            json_of(clearance.toi_upper, form), clearance.pairs, json_of(clearance.pair));
}

std::string json_of(const PartRelation& one) {
  return fmt::format("{{\"first\":{},\"second\":{},\"class\":\"{}\"}}", json_string(one.first), json_string(one.second),
                     name_of(one.sort));
}

template <class Item>
std::string list_json(const std::vector<Item>& items) {
  std::string text = "[";
  for (const Item& item : items) {
    if (text.size() > 1) text += ',';
    text += json_of(item);
  }
  return text + "]";
}

template <class Enum>
Enum named_value(const JsonNode& node) {
  if (const auto value = from_name<Enum>(node.text())) return *value;
  node.fail("is no name that belongs here");
}

NamedElement element_from(const JsonNode& node) {
  node.check_keys({"element", "number", "vertices", "part"});
  NamedElement element;
  element.element = named_value<MeshElement>(node.at("element"));
  if (element.element == MeshElement::face) element.face = node.at("number").whole_number(0, kMostNumber);
  const auto vertices = node.at("vertices").items();
  if (vertices.size() != element.corner_count()) node.at("vertices").fail("must have a number for each corner");
  for (std::size_t i = 0; i < vertices.size(); ++i) element.vertices[i] = vertices[i].whole_number(0, kMostNumber);
  if (const auto part = node.find("part")) element.part = clean_text_from(*part);
  return element;
}

bool fits(Kind kind, const NamedElement& first, const NamedElement& second) {
  const auto& traits = geometry::traits_of(kind);
  return first.element == traits.first.sort && second.element == traits.second.sort;
}

PairContact pair_from(const JsonNode& node) {
  node.check_keys({"kind", "first", "second", "nature", "feature_a", "feature_b", "trend"});
  PairContact pair;
  pair.kind = named_value<Kind>(node.at("kind"));
  pair.first = element_from(node.at("first"));
  pair.second = element_from(node.at("second"));
  if (!fits(pair.kind, pair.first, pair.second)) node.fail("has elements of other sorts than its kind");
  pair.nature = named_value<Nature>(node.at("nature"));
  pair.feature_a = named_value<Feature>(node.at("feature_a"));
  pair.feature_b = named_value<Feature>(node.at("feature_b"));
  if (const auto trend = node.find("trend")) pair.trend = named_value<Trend>(*trend);
  return pair;
}

RestContact rest_from(const JsonNode& node) {
  node.check_keys({"first", "second", "sort"});
  return {element_from(node.at("first")), element_from(node.at("second")),
          named_value<IntersectionSort>(node.at("sort"))};
}

EnclosedCounts enclosed_from(const JsonNode& node) {
  node.check_keys({"surfaces", "wires", "points", "vertex", "face"});
  const auto count = [&](const char* key) { return node.at(key).whole_number(0, kMostNumber); };
  const EnclosedCounts enclosed{count("surfaces"), count("wires"), count("points"), element_from(node.at("vertex")),
                                element_from(node.at("face"))};
  if (enclosed.all() == 0) node.fail("counts nothing");
  if (!fits(Kind::vertex_face, enclosed.vertex, enclosed.face)) node.fail("has elements of other sorts than its keys");
  return enclosed;
}

PartRelation relation_from(const JsonNode& node) {
  node.check_keys({"first", "second", "class"});
  PartRelation one{clean_text_from(node.at("first")), clean_text_from(node.at("second"))};
  const std::string name = node.at("class").text();
  for (std::size_t i = 0; i < mesh::kRelations; ++i) {
    one.sort = static_cast<mesh::Relation>(i);
    if (name_of(one.sort) == name && one.sort != mesh::Relation::clear && one.sort != mesh::Relation::around) {
      return one;
    }
  }
  node.at("class").fail("is no name that belongs here");
}

template <class Item, class From>
std::vector<Item> list_from(const JsonNode& node, From from) {
  std::vector<Item> list;
  for (const JsonNode& item : node.items()) list.push_back(from(item));
  return list;
}

double time_from(const JsonNode& node) {
  const auto time = io::parse_finite_double(node.text());
  if (!time || *time < 0 || *time > 1) node.fail("must be a hexfloat in [0, 1]");
  return *time;
}

}  // namespace

std::string json_string(std::string_view text) { return nlohmann::json(text).dump(); }

std::string elements_json(const PairContact& pair, std::string_view more) {
  return fmt::format("{{\"kind\":\"{}\",\"first\":{},\"second\":{}{}}}", name_of(pair.kind), json_of(pair.first),
                     json_of(pair.second), more);
}

std::string contact_json(const PairContact& pair, std::string_view more) {
  std::string text = fmt::format(",\"nature\":\"{}\",\"feature_a\":\"{}\",\"feature_b\":\"{}\"", name_of(pair.nature),
                                 name_of(pair.feature_a), name_of(pair.feature_b));
  if (pair.trend != Trend::none) text += fmt::format(",\"trend\":\"{}\"", name_of(pair.trend));
  return elements_json(pair, text.append(more));
}

std::string intersections_json(const std::vector<RestContact>& intersections) { return list_json(intersections); }

namespace {

/// @param text  the object's first members, which say what the result is about
std::string members_json(std::string text, const Result& result, io::Numbers form) {
  text += fmt::format(",\"free\":{}", result.free());
  if (result.enclosed.all() > 0) text += ",\"enclosed_parts\":" + json_of(result.enclosed);
  if (result.flat > 0) text += fmt::format(",\"flat_faces\":{}", result.flat);
  if (result.in_open > 0) text += fmt::format(",\"parts_in_open_surfaces\":{}", result.in_open);
  if (result.turning > 0) text += fmt::format(",\"turning_faces\":{}", result.turning);
  if (result.clearance) text += ",\"clearance\":" + json_of(*result.clearance, form);
  if (result.classes) text += ",\"classes\":" + list_json(*result.classes);
  if (result.without_inside > 0) text += fmt::format(",\"parts_without_inside\":{}", result.without_inside);
  if (result.free()) return text + "}";
  if (result.step) {
    const auto time = [&](double value) { return result.first.empty() ? std::string("null") : json_of(value, form); };
    text += fmt::format(",\"toi\":{},\"toi_upper\":{},\"first\":{},\"at_start\":{}", time(result.toi),
                        time(result.toi_upper), list_json(result.first), list_json(result.at_start));
  }
  text += ",\"intersections\":" + list_json(result.intersections);
  if (result.coinciding > 0) text += fmt::format(",\"coinciding_vertices\":{}", result.coinciding);
  if (result.own_neighbours > 0) text += fmt::format(",\"own_neighbours_at_start\":{}", result.own_neighbours);
  return text + "}";
}

}  // namespace

std::string result_json(const Result& result) {
  return members_json(result.step ? fmt::format("{{\"from\":{},\"to\":{}", result.frame, result.frame + 1)
                                  : fmt::format("{{\"frame\":{}", result.frame),
                      result, io::Numbers::hexfloats);
}

std::string result_line(const Result& result, std::string_view from, std::string_view to) {
  return members_json(
      result.step ? "{\"from\":" + json_string(from) + ",\"to\":" + json_string(to) : "{\"frame\":" + json_string(from),
      result, io::Numbers::decimals);
}

namespace {

/// toi and toi_upper.
void take_times(const JsonNode& node, double& toi, double& toi_upper) {
  toi = time_from(node.at("toi"));
  toi_upper = time_from(node.at("toi_upper"));
  const double next = std::nextafter(toi, std::numeric_limits<double>::infinity());
  if (toi_upper != toi && toi_upper != next) node.at("toi_upper").fail("must be toi, or the double after it");
}

Clearance clearance_from(const JsonNode& node) {
  node.check_keys({"distance", "toi", "toi_upper", "pairs", "pair"});
  Clearance clearance;
  const JsonNode distance = node.at("distance");
  if (distance.is_null()) return clearance;
  const auto value = io::parse_finite_double(distance.text());
  if (!value || *value < 0) distance.fail("must be null or a hexfloat, 0 or greater");
  clearance.distance = *value;
  if (!node.has("pair")) return clearance;
  take_times(node, clearance.toi, clearance.toi_upper);
  clearance.pairs = node.at("pairs").whole_number(1, std::uint64_t{1} << 63);
  clearance.pair = pair_from(node.at("pair"));
  return clearance;
}

}  // namespace

Result result_from(const JsonNode& node) {
  Result result;
  result.step = node.has("from");
  if (result.step) {
    node.check_keys({"from", "to", "free", "turning_faces", "toi", "toi_upper", "first", "at_start", "intersections",
                     "coinciding_vertices", "own_neighbours_at_start", "clearance"});
    if (const auto turning = node.find("turning_faces")) result.turning = turning->whole_number(1, kMostNumber);
  } else {
    node.check_keys({"frame", "free", "enclosed_parts", "flat_faces", "parts_in_open_surfaces", "intersections",
                     "coinciding_vertices", "clearance", "classes", "parts_without_inside"});
    if (const auto classes = node.find("classes")) {
      result.classes = list_from<PartRelation>(*classes, relation_from);
      if (const auto parts = node.find("parts_without_inside")) {
        result.without_inside = parts->whole_number(1, kMostNumber);
      }
    } else if (const auto parts = node.find("parts_without_inside")) {
      parts->fail("goes with classes");
    }
    if (const auto enclosed = node.find("enclosed_parts")) result.enclosed = enclosed_from(*enclosed);
    if (const auto flat = node.find("flat_faces")) result.flat = flat->whole_number(1, kMostNumber);
    if (const auto parts = node.find("parts_in_open_surfaces")) result.in_open = parts->whole_number(1, kMostNumber);
  }
  result.frame = node.at(result.step ? "from" : "frame").whole_number(0, kMostFrames);
  if (result.step) node.at("to").whole_number(result.frame + 1, result.frame + 1);
  if (const auto clearance = node.find("clearance")) result.clearance = clearance_from(*clearance);
  if (node.at("free").boolean()) return result;
  if (result.step) {
    result.first = list_from<PairContact>(node.at("first"), pair_from);
    result.at_start = list_from<PairContact>(node.at("at_start"), pair_from);
    if (!result.first.empty()) take_times(node, result.toi, result.toi_upper);
    if (result.first.empty() && result.at_start.empty()) node.fail("is a step that is not free, without a contact");
  }
  result.intersections = list_from<RestContact>(node.at("intersections"), rest_from);
  if (result.free()) node.fail("is not free, without an intersection");
  if (const auto count = node.find("coinciding_vertices")) result.coinciding = count->whole_number(1, kMostNumber);
  if (const auto count = node.find("own_neighbours_at_start")) {
    result.own_neighbours = count->whole_number(1, result.at_start.size());
  }
  return result;
}

std::string clean_text_from(const JsonNode& node) {
  std::string text = node.text();
  if (text.empty() || io::printable(text) != text) node.fail("must be one line of text without control characters");
  return text;
}

std::string digest_from(const JsonNode& node) {
  std::string digest = node.text();
  if (digest.size() != 64 || digest.find_first_not_of("0123456789abcdef") != std::string::npos) {
    node.fail("must be 64 lower-case hexadecimal digits");
  }
  return digest;
}

}  // namespace touchstone::sequence

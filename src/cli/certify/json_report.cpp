// SPDX-License-Identifier: MIT
#include "cli/certify/json_report.hpp"

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include <touchstone/version.hpp>

#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::cli {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(std::uint64_t count) { return count; }
Json json_of(double time) { return io::hexfloat(time); }

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json(nullptr);
}

Json json_of(const certify::VerdictCounts& counts) {
  return {{"judged", counts.claims()},
          {"holds", counts.holds},
          {"missed", counts.missed},
          {"phantom", counts.phantom},
          {"late", counts.late}};
}

template <class Distance>
Json json_of(Distance least, Distance most, const certify::ErrorBucket<Distance>& median,
             const std::vector<certify::ErrorBucket<Distance>>& buckets) {
  Json json;
  json["least"] = json_of(least);
  json["most"] = json_of(most);
  json["median"] = {{"from", json_of(median.from)}, {"below", json_of(median.below)}};
  json["histogram"] = Json::array();
  for (const auto& bucket : buckets) {
    json["histogram"].push_back(
        {{"from", json_of(bucket.from)}, {"below", json_of(bucket.below)}, {"claims", bucket.claims}});
  }
  return json;
}

Json json_of(const certify::TimeErrors& errors) {
  Json json = {{"claims", errors.claims()}};
  if (errors.claims() == 0) return json;
  json["ulps"] = json_of(errors.least_ulps(), errors.most_ulps(), errors.median_ulps(), errors.ulps());
  json["time"] = json_of(errors.least_time(), errors.most_time(), errors.median_time(), errors.times());
  return json;
}

Json json_of(const Answer& answer, const Separation& separation) {
  Json json = {{"contact", answer.contact ? 1 : 0}};
  const auto put = [&](const char* key, const auto& value) { json[key] = answer.contact ? Json(value) : nullptr; };
  put("toi", io::hexfloat(answer.contact ? answer.toi : 0));
  put("toi_upper", io::hexfloat(answer.contact ? answer.toi_upper : 0));
  put("nature", name_of(answer.nature));
  put("feature_a", name_of(answer.feature_a));
  put("feature_b", name_of(answer.feature_b));
  json["level"] = name_of(answer.level);
  if (separation.distance > 0) {
    put("starts_within", answer.starts_within ? 1 : 0);
    put("trend", name_of(answer.trend));
  }
  return json;
}

Json json_of(const std::array<Fraction, 3>& corner) {
  Json json = Json::array();
  for (const auto& coordinate : corner) json.push_back(coordinate.numerator + "/" + coordinate.denominator);
  return json;
}

Json json_of(const Vec3& x) { return {io::hexfloat(x.x), io::hexfloat(x.y), io::hexfloat(x.z)}; }

Json json_of(const std::array<double, 4>& q) {
  Json json = Json::array();
  for (const double c : q) json.push_back(io::hexfloat(c));
  return json;
}

void put_corners(Json& json, const RationalQuery& query) {
  json["corners"] = Json::object();
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    json["corners"][std::string(corner_name(query.kind, i))] = {{"start", json_of(query.start[i])},
                                                                {"end", json_of(query.end[i])}};
  }
}

void put_corners(Json& json, const CurvedQuery& query) {
  std::array<bool, 4> used{};
  Json corners = Json::object();
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    Json& shown = corners[std::string(corner_name(query.kind, i))];
    if (corner.motion != CurvedCorner::kOnCurve) {
      used[static_cast<std::size_t>(corner.motion)] = true;
      shown = {{"motion", corner.motion}, {"point", json_of(corner.points[0])}};
      continue;
    }
    shown["curve"] = Json::array();
    for (int k = 0; k < corner.control_points; ++k) {
      shown["curve"].push_back(json_of(corner.points[static_cast<std::size_t>(k)]));
    }
  }
  json["motions"] = Json::object();
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    json["motions"][std::to_string(m)] = {
        {"q0", json_of(motion.q0)}, {"q1", json_of(motion.q1)}, {"p0", json_of(motion.p0)}, {"p1", json_of(motion.p1)}};
  }
  json["corners"] = std::move(corners);
}

/// A time that is no double is shown as the claim writes it.
Json toi_json(const Claim& claim) {
  const std::string& written = claim.toi_as_written;
  if (!written.empty() && !numbers::is_exactly_a_double(written)) return written;
  return json_of(claim.toi);
}

/// Touching is not named.
void put_separation(Json& json, const Separation& separation) {
  if (separation.distance == 0) return;
  json["separation"] = io::hexfloat(separation.distance);
  json["metric"] = name_of(separation.metric);
}

/// File names need not be valid UTF-8; JSON must be.
std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string refuted_claim_json(const certify::RefutedClaim& refuted) {
  Json json = {
      {"file", refuted.file},
      {"kind", name_of(refuted.kind())},
      {"query", refuted.query},
      {"rows", {refuted.first_row, refuted.last_row}},
      {"verdict", name_of(refuted.verdict)},
      {"claim", {{"contact", refuted.claim.contact ? 1 : 0}, {"toi", toi_json(refuted.claim)}}},
      {"answer", json_of(refuted.answer, refuted.separation)},
  };
  put_separation(json, refuted.separation);
  std::visit([&](const auto& query) { put_corners(json, query); }, refuted.as_given);
  return text_of(json, -1);
}

std::string report_begin(const ReportHeading& heading, const certify::Tally& tally,
                         const std::vector<certify::FileTally>& files) {
  Json json;
  json["touchstone"] = version();
  json["method"] = heading.method;
  json["claims_from"] = heading.claims_from;
  if (!heading.left_out.empty()) json["left_out"] = heading.left_out;
  if (heading.separation) put_separation(json, *heading.separation);
  json["claims"] = json_of(tally.verdicts);
  if (const auto& limit = heading.counting.late) {
    Json& late = json["not_counted"]["late"];
    late = {{"claims", heading.not_counted.late}};
    if (limit->ulps) late["ulps"] = *limit->ulps;
    if (limit->fraction) late["time"] = json_of(*limit->fraction);
  }
  if (!heading.counting.classes.empty()) {
    Json& other = json["not_counted"]["other_classes"];
    other = {{"claims", heading.not_counted.other}, {"than", Json::array()}};
    for (const Verdict one : heading.counting.classes) other["than"].push_back(name_of(one));
  }
  for (const Level level : {Level::filter, Level::bracket, Level::exact, Level::oracle}) {
    json["decided_by"][std::string(name_of(level))] = tally.levels[static_cast<std::size_t>(level)];
  }
  for (const Nature nature : {Nature::none, Nature::crossing, Nature::grazing, Nature::sustained, Nature::isolated}) {
    const std::string name(nature == Nature::none ? "none" : name_of(nature));
    json["natures"][name] = tally.natures[static_cast<std::size_t>(nature)];
  }
  const std::uint64_t entering = tally.natures[static_cast<std::size_t>(Nature::entering)];
  const bool touching = heading.separation && heading.separation->distance == 0;
  if (!touching) json["natures"]["entering"] = entering;
  json["early"] = json_of(tally.early);
  json["late"] = json_of(tally.late);
  json["outside"] = {{"below_0", tally.below_0}, {"above_1", tally.above_1}};
  json["files"] = Json::array();
  for (const auto& file : files) {
    json["files"].push_back({{"file", file.file}, {"kind", name_of(file.kind)}, {"claims", json_of(file.verdicts)}});
  }
  std::string text = text_of(json, 2);
  text.resize(text.rfind("\n}"));  // the refuted claims go inside
  return text + ",\n  \"refuted\": [\n";
}

}  // namespace touchstone::cli

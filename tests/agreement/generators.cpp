// The generators themselves: elements that are built to touch do touch, every family holds both hits and misses where
// it can, and a case is the same however it is made.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "support/query_families.hpp"
#include "support/report.hpp"
#include "support/static_contact.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 20240601;

bool any_family(const FamilyInfo&, Kind) { return true; }

TEST_CASE("generators: an element built to touch at a time does touch then") {
  Report report;
  std::size_t built = 0;
  for_each_case(kSeed, 200, any_family, [&](const CaseId& id) {
    const Sample sample = make_sample(id);
    if (!sample.touches_at) return;
    ++built;
    const bool touches = touching_at(sample.query, mpq_class(*sample.touches_at));
    report.add(id, sample.query, touches ? "" : "does not touch at " + hexfloat(*sample.touches_at));
  });
  CHECK(built > 0);
  report.finish();
}

TEST_CASE("generators: coordinates are finite, and dyadic where a family says so") {
  Report report;
  for_each_case(kSeed, 500, any_family, [&](const CaseId& id) {
    Query query = make(id);
    const bool dyadic = info(id.family).dyadic;
    std::string wrong = query.kind == id.kind ? "" : "a query of another kind";
    for_each_coordinate(query, [&](double x) {
      if (!std::isfinite(x)) wrong = "a coordinate is not finite";
      if (dyadic && (std::abs(x) >= 0x1p10 || std::nearbyint(x * 0x1p30) != x * 0x1p30)) wrong = "not dyadic";
    });
    report.add(id, query, wrong);
  });
  report.finish();
}

TEST_CASE("generators: a case is made again from its name") {
  const CaseId id{Family::mixed_scale, Kind::vertex_face, 7, 1234};
  const std::optional<CaseId> again = parse_case(case_name(id));
  REQUIRE(again.has_value());
  CHECK(cpp_initializer(make(id)) == cpp_initializer(make(*again)));
  CHECK_FALSE(parse_case("mixed_scale vertex-face 7").has_value());
  CHECK_FALSE(parse_case("no_such_family vertex-face 7 0").has_value());
  for (const FamilyInfo& family : all_families()) CHECK(&info(family.family) == &family);
}

TEST_CASE("generators: the numbers are the same on every machine") {
  // The first outputs of the published splitmix64 for seed 1234567, and fingerprints of all families.
  std::uint64_t state = 1234567;
  CHECK(splitmix64(state) == 6457827717110365317u);
  CHECK(splitmix64(state) == 3203168211198807973u);
  std::uint64_t fingerprint = 0, with_distances = 0;
  const auto add = [](std::uint64_t& to, const std::string& text) {
    for (const char c : text) to = (to ^ static_cast<unsigned char>(c)) * 0x100000001B3u;  // FNV-1a
  };
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < 20; ++index) {
        const CaseId id{family.family, kind, kSeed, index};
        if (family.group != Group::separation) add(fingerprint, cpp_initializer(make(id)));
        for (const Metric metric : {Metric::euclidean, Metric::max}) {
          const Separated made = make_separated(id, metric);
          add(with_distances, cpp_initializer(made.query) + hexfloat(made.distance));
        }
      }
    }
  }
  CHECK(with_distances == 0x7DD0E96AA8E92D6Cu);
  CHECK(fingerprint == 0x64B79E91682EDBDCu);
}

}  // namespace
}  // namespace touchstone::tests

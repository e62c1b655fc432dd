// The questions that an engine claims: the nearest query that is claimed, and descriptions that cannot be read.
// SPDX-License-Identifier: MIT
#include "fuzz/auditing/claims.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <touchstone/error.hpp>

#include "families/families.hpp"
#include "fuzz/auditing/description.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using fuzz::ClaimedMotion;
using fuzz::Claims;
using fuzz::is_claimed;
using fuzz::nearest_claimed;

namespace {

double greatest(const Query& query) {
  double greatest = 0;
  for (const auto* const corners : {&query.start, &query.end}) {
    for (const Vec3& c : *corners) greatest = std::max({greatest, std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
  }
  return greatest;
}

bool same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Vec3 motion(const Query& query, std::size_t i) {
  return {query.end[i].x - query.start[i].x, query.end[i].y - query.start[i].y, query.end[i].z - query.start[i].z};
}

template <class Check>
void for_each_family(Check&& check) {
  for (const auto& family : families::all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t i = 0; i < 20; ++i) {
        const families::CaseId id{family.family, kind, 1, i};
        INFO(families::case_name(id));
        check(families::make(id));
      }
    }
  }
}

}  // namespace

TEST_CASE("the nearest claimed query is claimed, and nearest to itself") {
  for (const ClaimedMotion motion_claimed :
       {ClaimedMotion::straight, ClaimedMotion::translations, ClaimedMotion::cast, ClaimedMotion::still}) {
    for (const bool floats : {false, true}) {
      Claims claims;
      claims.motion = motion_claimed;
      claims.floats = floats;
      claims.in_plane = floats;
      if (floats) claims.least = 0.5, claims.greatest = 8;
      for_each_family([&](const Query& query) {
        const Query nearest = nearest_claimed(query, claims);
        const Query again = nearest_claimed(nearest, claims);
        const std::size_t count = corner_count(query.kind), second = query.kind == Kind::edge_edge ? 2 : 1;
        for (std::size_t i = 0; i < count; ++i) {
          REQUIRE(same(again.start[i], nearest.start[i]));
          REQUIRE(same(again.end[i], nearest.end[i]));
          if (motion_claimed != ClaimedMotion::straight) {
            // The difference of the corners has no rounding, so that it is the same for each corner of an element.
            REQUIRE(same(motion(nearest, i), motion(nearest, i < second ? 0 : second)));
          }
          if (motion_claimed == ClaimedMotion::still) REQUIRE(same(nearest.start[i], nearest.end[i]));
          if (motion_claimed == ClaimedMotion::cast && i >= second) REQUIRE(same(nearest.start[i], nearest.end[i]));
          if (!floats) continue;
          REQUIRE((nearest.start[i].z == 0 && nearest.end[i].z == 0));
          const bool straight = motion_claimed == ClaimedMotion::straight;  // then motions need not be floats
          for (const Vec3& number : {nearest.start[i], nearest.end[i], straight ? Vec3{} : motion(nearest, i)}) {
            REQUIRE(static_cast<double>(static_cast<float>(number.x)) == number.x);
            REQUIRE(static_cast<double>(static_cast<float>(number.y)) == number.y);
          }
        }
        const double size = greatest(nearest);
        if (floats && size != 0) REQUIRE((size >= 0.5 && size <= 8));
      });
    }
  }
}

TEST_CASE("a query that is claimed is asked as it is") {
  for_each_family([](const Query& query) {
    const Query nearest = nearest_claimed(query, {});
    REQUIRE(std::memcmp(&nearest.start, &query.start, sizeof query.start) == 0);
    REQUIRE(std::memcmp(&nearest.end, &query.end, sizeof query.end) == 0);
    REQUIRE(is_claimed(nearest, {}, {}));
  });
}

TEST_CASE("queries beyond an engine's claims are not asked") {
  Query query;  // edges of length 1 and 1e-4
  query.start = {{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1e-4, 1}}};
  query.end = query.start;
  Claims claims;
  CHECK(is_claimed(query, claims, {}));
  claims.least_element = 0.001;
  CHECK_FALSE(is_claimed(query, claims, {}));
  Query flat;  // and huge, where products overflow
  flat.kind = Kind::vertex_face;
  flat.start = {{{0, 0, 1}, {0, 1e300, 1e300}, {0, 0, 0}, {0, 0, 0}}};
  flat.end = flat.start;
  CHECK_FALSE(is_claimed(flat, claims, {}));
  query.start[3] = query.end[3] = {0, 1, 1};
  CHECK(is_claimed(query, claims, {}));
  claims.motion = ClaimedMotion::cast;  // and it does not move
  CHECK_FALSE(is_claimed(query, claims, {}));
  query.end[0].z = query.end[1].z = 2;
  CHECK(is_claimed(query, claims, {}));
  claims.starts_apart = true;
  CHECK(is_claimed(query, claims, {}));
  CHECK_FALSE(is_claimed(query, claims, {.distance = 1}));
}

TEST_CASE("a description is read whole") {
  const auto questions = fuzz::parse_description(
      "question cast\r\nengine Toy 1.2\nasks toi()\nkinds edge-edge point-point\nmotion translations\nspace 2\n"
      "numbers float\nsizes 0.1 10\nelements 0.5\nstarts apart\nseparation 0.25\ntolerance-length 1e-3\n"
      "tolerance-relative 1e-6\ntolerance-time 1e-4\nnote one\nnote two\n\nquestion other\nengine Toy 1.2\nasks more\n"
      "kinds vertex-face\nmotion straight\n");
  REQUIRE(questions.size() == 2);
  const fuzz::EngineQuestion& q = questions[0];
  CHECK(q.name == "cast");
  CHECK(q.engine == "Toy 1.2");
  CHECK(q.kinds == std::vector<Kind>{Kind::edge_edge, Kind::point_point});
  CHECK((q.claims.motion == ClaimedMotion::translations && q.claims.in_plane && q.claims.floats));
  CHECK((q.claims.starts_apart && q.claims.least == 0.1 && q.claims.greatest == 10 && q.claims.least_element == 0.5));
  CHECK((q.tolerance.length == 1e-3 && q.tolerance.relative == 1e-6 && q.tolerance.time == 1e-4));
  CHECK((questions[1].tolerance.time > 0 && questions[1].tolerance.time < 1e-13));
  CHECK((q.separation == 0.25 && q.notes.size() == 2));
  CHECK((questions[1].tolerance.relative > 0 && questions[1].tolerance.relative < 1e-13));  // of doubles
}

TEST_CASE("a description that says something wrong is refused, and the line is named") {
  const std::string good = "question a\nengine Toy\nasks f\nkinds edge-edge\nmotion still\n";
  const auto fault = [](const std::string& text) -> std::string {
    try {
      fuzz::parse_description(text);
      return "none";
    } catch (const Error& error) {
      return error.what();
    }
  };
  CHECK(fault(good) == "none");
  CHECK(fault("") == "it describes no question");
  for (const char* const line :
       {"speed fast", "motion sideways", "kinds edge-edge face-face", "kinds edge-edge edge-edge", "kinds ", "space 4",
        "numbers half", "sizes 1", "sizes 1 1.5", "sizes 0 0", "sizes 1 inf", "tolerance-length -1",
        "tolerance-relative nan", "separation 1e999", "question ../up", "question a", "question Big"}) {
    INFO(line);
    CHECK(fault(good + line + "\n").find("its line '" + std::string(line)) == 0);
  }
  CHECK(fault("engine Toy\n" + good).find("comes before the first line 'question NAME'") != std::string::npos);
  CHECK(fault("question a\nengine Toy\nasks f\nkinds edge-edge\n") == "its question a has no line 'motion'");
  CHECK(fault(good + "numbers float\n").find("sizes") != std::string::npos);
}

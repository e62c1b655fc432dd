// Pages to look at: exact pictures, and text that is only text.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"
#include "view/closest_points.hpp"
#include "view/pages/html.hpp"
#include "view/pages/query_page.hpp"
#include "view/pages/story_html.hpp"
#include "view/picture.hpp"
#include "view/still.hpp"

using namespace touchstone;
using nlohmann::json;
using tests::effort;
using tests::whole_effort;

namespace {

json picture(const Query& query, double t_max = 1) {
  return view::picture_of(query, solve(query, {.t_max = t_max, .method = Method::exact}), t_max);
}

double polynomial(const json& p, double s) {
  double result = 0;
  for (std::size_t i = p.size(); i-- > 0;) result = result * s + p[i].get<double>();
  return result;
}

/// Edge a along x, which ends at `end`; edge b, at x = 1, falls along z past it.
Query falling(double end) {
  return EdgeEdge{{Vec3{-1, 0, 0}, Vec3{end, 0, 0}, Vec3{1, -1, 1}, Vec3{1, 1, 1}},
                  {Vec3{-1, 0, 0}, Vec3{end, 0, 0}, Vec3{1, -1, -1}, Vec3{1, 1, -1}}};
}

/// A query with integer coordinates, so that it can be moved and scaled without rounding.
Query lattice_query(seeded::Rng& rng, Kind kind) {
  Query query;
  query.kind = kind;
  for (auto* const corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(kind); ++i) {
      for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        const double x = static_cast<double>(rng.below(17)) - 8;
        (*corners)[i].*axis = x;
      }
    }
  }
  return query;
}

template <class F>
Query mapped(Query query, F&& f) {
  for (auto* const corners : {&query.start, &query.end}) {
    for (Vec3& p : *corners) p = {f(p.x), f(p.y), f(p.z)};
  }
  return query;
}

/// Checks that every plane of a picture lies between the elements: at times of its piece that are no ends of it.
void check_planes(const json& data) {
  const std::size_t first = data["first"].get<std::size_t>();
  double from = data["marks"].front()["s"].get<double>();
  for (const json& piece : data["planes"]) {
    const double until = piece["untilS"].get<double>();
    for (const double fraction : {0.1, 0.5, 0.9}) {
      const double s = from + fraction * (until - from);
      double low = 0, high = 0, other_low = 0, other_high = 0;
      for (std::size_t i = 0; i < data["corners"].size(); ++i) {
        const double h = polynomial(piece["offsets"][i], s);
        double& least = i < first ? low : other_low;
        double& most = i < first ? high : other_high;
        least = i == 0 || i == first ? h : std::min(least, h);
        most = i == 0 || i == first ? h : std::max(most, h);
      }
      INFO("s = " << s << " in\n" << data.dump());
      CHECK((high < other_low || other_high < low));
    }
    from = until;
  }
}

/// Two bodies that turn and move past each other, with integer coordinates.
CurvedQuery turning_query(seeded::Rng& rng, Kind kind) {
  const auto small = [&rng] { return static_cast<double>(rng.below(9)) - 4; };
  const auto point = [&small] { return Vec3{small(), small(), small()}; };
  CurvedQuery query;
  query.kind = kind;
  for (int body = 0; body < 2; ++body) {
    RigidMotion& motion = query.motions[static_cast<std::size_t>(body)];
    motion.q0 = {4, small(), small(), small()};
    motion.q1 = {4, small(), small(), small()};
    motion.p0 = point();
    motion.p1 = point();
  }
  const std::size_t first = kind == Kind::edge_edge ? 2 : 1;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.corners[i] = CurvedCorner::on_body(i < first ? 0 : 1, point());
  }
  return query;
}

}  // namespace

TEST_CASE("JSON in a script element has no character that could end it") {
  const std::string hostile = "</script><script>alert('&amp;')</script><!--\xff\xfe\0\n\"\\";
  const std::string text = view::json_for_script(json{{"name", hostile + "\xc3\xa9"}, {"</b>", {1, 2}}});
  CHECK(text.find_first_of("<>&") == std::string::npos);
  const json back = json::parse(text);
  CHECK(back["</b>"] == json({1, 2}));
  CHECK(back["name"].get<std::string>().rfind("</script><script>alert('&amp;')</script><!--", 0) == 0);
  CHECK(back["name"].get<std::string>().find("\xc3\xa9") != std::string::npos);
}

TEST_CASE("text is escaped, and bytes that are no UTF-8 are replaced") {
  CHECK(view::escaped("<a href='x'>\"&\n") == "&lt;a href=&#39;x&#39;&gt;&quot;&amp;\n");
  const std::string replaced = "\xef\xbf\xbd";
  CHECK(view::escaped("\xff|\xc0\xaf|\xed\xa0\x80|\x01") ==
        replaced + "|" + replaced + replaced + "|" + replaced + replaced + replaced + "|" + replaced);
  CHECK(view::escaped("\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\x88") == "\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\x88");
}

TEST_CASE("two edges that miss each other by one ulp are exactly that far apart") {
  const double end = 1 - 0x1p-53;
  const json data = picture(falling(end));
  CHECK(data["contact"] == false);
  CHECK(data["apart"] == true);
  CHECK(data["t"] == 0.5);
  const double unit = std::ldexp(1, data["exponent"].get<int>());
  CHECK(polynomial(data["gap"][0], 0) * unit == 0x1p-53);
  CHECK(polynomial(data["gap"][1], 0) == 0);
  CHECK(polynomial(data["gap"][2], 0) == 0);
  CHECK(polynomial(data["gap"][2], 0x1p-60) * unit == -0x1p-59);  // b falls by 2 in the step
  CHECK(data["deepest"].get<double>() >= 53);
  // The plane of the proof lies between them at every time, the closest one included.
  REQUIRE(!data["planes"].empty());
  for (const double s : {-0.5, -0x1p-54, 0.0, 0x1p-54, 0.5}) {
    const auto piece = std::find_if(data["planes"].begin(), data["planes"].end(),
                                    [&](const json& p) { return s <= p["untilS"].get<double>(); });
    REQUIRE(piece != data["planes"].end());
    std::array<double, 4> h{};
    for (std::size_t i = 0; i < 4; ++i) h[i] = polynomial((*piece)["offsets"][i], s);
    CAPTURE(s, h[0], h[1], h[2], h[3]);
    CHECK((std::max(h[0], h[1]) < std::min(h[2], h[3]) || std::min(h[0], h[1]) > std::max(h[2], h[3])));
  }
  const json touching = picture(falling(1));
  CHECK(touching["contact"] == true);
  CHECK(touching["apart"] == false);
  for (std::size_t k = 0; k < 3; ++k) CHECK(polynomial(touching["gap"][k], 0) == 0);
}

TEST_CASE("the time of a contact is far more exact than its doubles") {
  // Edge b falls from 1 to -2: the contact is at 1/3, which is no double.
  Query query = falling(2);
  query.start[2].z = query.start[3].z = 1;
  query.end[2].z = query.end[3].z = -2;
  const Answer answer = solve(query, {.method = Method::exact});
  REQUIRE(answer.toi < answer.toi_upper);
  const view::MovingCorners corners = view::moving_corners_of(query);
  const view::Origin origin = view::origin_of(query, corners, answer, 1, {});
  const auto third = numbers::Exact(3) * origin.t - numbers::Exact(1);
  CHECK(std::fabs(numbers::to_double(third)) < 0x1p-250);
  const json marks = view::picture_of(query, answer, 1)["marks"];
  const auto toi = std::find_if(marks.begin(), marks.end(), [](const json& mark) { return mark["sort"] == "toi"; });
  REQUIRE(toi != marks.end());
  // 1/3 - toi, for the largest double below 1/3.
  CHECK(std::fabs((*toi)["s"].get<double>() * 0x1p54 + 1.0 / 3) < 1e-15);
}

TEST_CASE("a picture does not change when its query is moved or scaled") {
  seeded::Rng rng(5);
  for (std::size_t i = 0; i < effort(120); ++i) {
    const Query query = lattice_query(rng, kKinds[i % 4]);
    const json data = picture(query);
    const json moved = picture(mapped(query, [](double x) { return x + 0x1p40; }));
    json scaled = picture(mapped(query, [](double x) { return std::ldexp(x, -900); }));
    INFO(data.dump() + "\n" + moved.dump() + "\n" + scaled.dump());
    CHECK(data["exponent"].get<int>() - 900 == scaled["exponent"].get<int>());
    scaled["exponent"] = data["exponent"];
    for (const char* key : {"gap", "corners", "weights", "marks", "carrier", "denominator", "exponent", "deepest"}) {
      CAPTURE(key);
      CHECK(data[key] == moved[key]);
      CHECK(data[key] == scaled[key]);
    }
    CHECK(moved["planar"] == false);
  }
}

TEST_CASE("the corners of a picture are where the query has them") {
  seeded::Rng rng(6);
  for (std::size_t i = 0; i < effort(120); ++i) {
    const Query query = lattice_query(rng, kKinds[i % 4]);
    const json data = picture(query);
    const double unit = std::ldexp(1, data["exponent"].get<int>());
    const std::size_t first = data["first"].get<std::size_t>();
    for (const bool start : {true, false}) {
      const auto& corners = start ? query.start : query.end;
      const double s = (start ? data["marks"].front() : data["marks"].back())["s"].get<double>();
      const auto at = [&](std::size_t c, std::size_t k) {
        return unit * (polynomial(data["corners"][c][k], s) + (c < first ? 0 : polynomial(data["gap"][k], s)));
      };
      for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
        const std::array<double, 3> offset{corners[c].x - corners[0].x, corners[c].y - corners[0].y,
                                           corners[c].z - corners[0].z};
        for (std::size_t k = 0; k < 3; ++k) CHECK(std::fabs(at(c, k) - at(0, k) - offset[k]) < 1e-12);
      }
    }
  }
}

TEST_CASE("straight motion as curves gives the same picture") {
  seeded::Rng rng(7);
  for (std::size_t i = 0; i < effort(40); ++i) {
    const Query query = lattice_query(rng, kKinds[i % 2]);
    const Answer answer = solve(query, {.method = Method::exact});
    const json straight = view::picture_of(query, answer, 1), curved = view::picture_of(CurvedQuery(query), answer, 1);
    CHECK(curved["planes"].empty() == straight["planes"].empty());
    check_planes(curved);
    check_planes(straight);
    CHECK(!straight["planes"].empty() == (!answer.contact || answer.toi_upper > 0));
    CHECK(std::fabs(straight["t"].get<double>() - curved["t"].get<double>()) <= 0x1p-53);
    if (answer.toi == answer.toi_upper || !answer.contact) {
      for (const char* key : {"gap", "corners", "carrier", "marks"}) CHECK(straight[key] == curved[key]);
    }
  }
}

TEST_CASE("planes of proofs keep bodies that turn apart") {
  seeded::Rng rng(8);
  std::size_t planes = 0, contacts = 0;
  for (std::size_t i = 0; i < effort(80); ++i) {
    const CurvedQuery query = turning_query(rng, kKinds[i % 4]);
    const Answer answer = solve(query);
    const json data = view::picture_of(query, answer, 1);
    check_planes(data);
    planes += data["planes"].size();
    contacts += answer.contact ? 1 : 0;
    if (!answer.contact) CHECK(!data["planes"].empty());
  }
  CHECK(planes > effort(80) / 2);
  if (whole_effort("that some of the bodies touch")) CHECK(contacts > 0);
}

TEST_CASE("a sentence says the answer") {
  const auto sentence = [](const Query& query, const Separation& separation = {}) {
    return view::answer_sentence(query.kind, solve(query, {.separation = separation}), 1, separation);
  };
  CHECK(sentence(falling(1)) == "Edge a and edge b touch first at t = 0.5.");
  CHECK(sentence(falling(1 - 0x1p-53)) ==
        "Edge a and edge b do not touch for t in [0, 1]; the marks are where they come closest.");
  CHECK(sentence(falling(1), {0.25}) == "Edge a and edge b come within 0.25 first at t = 0.375.");
  const Query apart = PointPoint{{Vec3{0, 0, 0}, Vec3{1, 0, 0}}, {Vec3{0, 0, 0}, Vec3{1, 0, 0}}};
  CHECK(sentence(apart, {0.5}) ==
        "Point p and point q stay farther apart than 0.5 for t in [0, 1]; the marks are where they come closest.");
}

TEST_CASE("a moving picture of a query has its elements at each time, and rests where they meet") {
  const std::string text = view::moving_svg(picture(falling(1)), "</title><script>", "<b>");
  const auto count = [&](const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  CHECK(count("<g class=\"f") == 31);
  CHECK(count("<g class=\"f s\"") == 1);
  CHECK(count("polygon class=\"a now\"") == 31);
  CHECK(count("polygon class=\"b then\"") == 2);
  CHECK(count("@keyframes hold") == 1);
  CHECK(count("<script>") + count("<b>") == 0);
  // In the frame of the meeting the marked points are one.
  const std::size_t still = text.find("<g class=\"f s\"");
  const std::string meeting = text.substr(still, text.find("</g>", still) - still);
  const auto centre_of = [](const std::string& frame, const std::string& look) {
    const std::size_t at = frame.find("<circle class=\"" + look + "\"");
    REQUIRE(at != std::string::npos);
    const std::size_t from = frame.find("cx=", at);
    return frame.substr(from, frame.find(" r=", at) - from);
  };
  CHECK(centre_of(meeting, "a marked") == centre_of(meeting, "b marked"));
  CHECK(centre_of(meeting, "a marked") == centre_of(meeting, "meeting"));
  const std::string first = text.substr(text.find("<g class=\"f"), meeting.size());
  CHECK(centre_of(first, "a marked") != centre_of(first, "b marked"));
}

TEST_CASE("a page is one whole document whose names are text") {
  view::QueryToShow shown;
  shown.title = "query 0 of </title><script>x()</script>";
  shown.command = "<!--";
  shown.corners = "</pre><img>";
  shown.query = falling(1);
  shown.story = exact::explain(falling(1), 1);
  const std::string page = view::page_text(view::query_page(shown));
  const auto count = [&](const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = page.find(part); at != std::string::npos; at = page.find(part, at + 1)) ++found;
    return found;
  };
  CHECK(count("<script") == 2);  // the data and the program
  CHECK(count("</script>") == 2);
  CHECK(count("<!--") == 0);
  CHECK(count("<img") == 0);
  CHECK(count("default-src 'none'") == 1);
  CHECK(count("http:") + count("https:") + count("src=") == 0);
  CHECK(count("<svg class=\"still\"") == 1);
  CHECK(count("they touch") == 1);
  CHECK(page.rfind("<!doctype html>", 0) == 0);
  CHECK(page.substr(page.size() - 8) == "</html>\n");
}

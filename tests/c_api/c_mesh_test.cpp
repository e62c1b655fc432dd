// Meshes through the C interface: the answers of the C++ one, and what is wrong as a status and a message.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/touchstone.hpp>

#include "c_api/c_api_support.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

touchstone_mesh_elements default_elements() { return TOUCHSTONE_MESH_ELEMENTS_INIT; }

/// Two triangles, the second above the first and falling through it.
struct FallingTriangle {
  std::vector<std::uint32_t> faces = {0, 1, 2, 3, 4, 5};
  std::vector<double> x0 = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 0.25, 0.5, 2, 0.5, 0.25, 2};
  std::vector<double> x1 = x0;
  touchstone_mesh_elements elements = default_elements();

  FallingTriangle() {
    for (std::size_t i = 11; i < 18; i += 3) x1[i] -= 2;
    elements.vertex_count = 6;
    elements.faces = faces.data();
    elements.face_count = 2;
  }
  FallingTriangle(const FallingTriangle&) = delete;
  FallingTriangle& operator=(const FallingTriangle&) = delete;
};

}  // namespace

TEST_CASE("a mesh answers as the one of C++") {
  FallingTriangle given;
  for (const int round : {0, 1, 2, 3}) {
    const double separation = round % 2 == 0 ? 0.0 : 0.25;
    const int keep = round / 2;
    CAPTURE(separation, keep);
    given.elements.separation = separation;
    touchstone::MeshElements elements;
    elements.vertex_count = 6;
    elements.faces = {{0, 1, 2}, {3, 4, 5}};
    elements.separation.distance = separation;
    const touchstone::Mesh mesh(elements);
    const touchstone::Positions x0(given.x0, 3), x1(given.x1, 3);

    touchstone_mesh* handle = nullptr;
    REQUIRE(touchstone_mesh_create(&given.elements, &handle) == TOUCHSTONE_OK);
    REQUIRE(handle != nullptr);
    REQUIRE(touchstone_mesh_keep(handle, keep) == TOUCHSTONE_OK);
    CHECK(touchstone_mesh_keep(handle, 2) == TOUCHSTONE_INVALID_ARGUMENT);
    int has_pairs = 9;
    REQUIRE(touchstone_mesh_has_pairs(handle, &has_pairs) == TOUCHSTONE_OK);
    CHECK(has_pairs == 1);
    CHECK(touchstone_mesh_has_pairs(handle, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
    std::uint32_t corners[2] = {9, 9};
    for (std::size_t e = 0; e < mesh.edges().size(); ++e) {
      REQUIRE(touchstone_mesh_edge(handle, e, corners) == TOUCHSTONE_OK);
      CHECK(corners[0] == mesh.edges()[e][0]);
      CHECK(corners[1] == mesh.edges()[e][1]);
    }
    CHECK(touchstone_mesh_edge(handle, mesh.edges().size(), corners) == TOUCHSTONE_INVALID_ARGUMENT);

    const touchstone::FirstContact expected = touchstone::first_contact(mesh, x0, x1);
    touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
    touchstone_contacts* first = nullptr;
    touchstone_contacts* at_start = nullptr;
    REQUIRE(touchstone_mesh_first_contact(handle, given.x0.data(), given.x1.data(), 18, nullptr, &result, &first,
                                          &at_start) == TOUCHSTONE_OK);
    CHECK(expected.contact);
    CHECK(result.contact == 1);
    CHECK(result.free == 0);
    CHECK(result.toi == expected.toi);
    CHECK(result.toi_upper == expected.toi_upper);
    CHECK(touchstone_contacts_count(first) == expected.earliest.size());
    CHECK(touchstone_contacts_count(at_start) == 0);

    touchstone_contacts* all = nullptr;
    touchstone_options options = default_options();
    options.threads = 2;
    REQUIRE(touchstone_mesh_all_contacts(handle, given.x0.data(), given.x1.data(), 18, &options, &all) ==
            TOUCHSTONE_OK);
    const auto every = touchstone::all_contacts(mesh, x0, x1);
    REQUIRE(touchstone_contacts_count(all) == every.size());
    CHECK(every.size() > expected.earliest.size());
    for (std::size_t i = 0; i < every.size(); ++i) {
      touchstone_mesh_pair pair;
      touchstone_answer answer;
      REQUIRE(touchstone_contacts_get(all, i, &pair, &answer) == TOUCHSTONE_OK);
      CHECK(pair.kind == static_cast<int>(every[i].pair.kind));
      CHECK(pair.first == every[i].pair.first);
      CHECK(pair.second == every[i].pair.second);
      CHECK(same(every[i].answer, answer));
    }

    const touchstone::FreeStep step = touchstone::free_step(mesh, x0, x1, {{}, 0.5});
    options.kept_fraction = 0.5;
    std::vector<double> positions(18);
    double length = -1;
    int outcome = -1;
    REQUIRE(touchstone_mesh_free_step(handle, given.x0.data(), given.x1.data(), 18, &options, positions.data(), &length,
                                      &outcome, nullptr) == TOUCHSTONE_OK);
    CHECK(positions == step.positions);
    CHECK(length == step.length);
    CHECK(outcome == TOUCHSTONE_STEP_SHORTENED);
    std::vector<double> in_place = given.x1;
    REQUIRE(touchstone_mesh_free_step(handle, given.x0.data(), in_place.data(), 18, &options, in_place.data(), nullptr,
                                      nullptr, nullptr) == TOUCHSTONE_OK);
    CHECK(in_place == step.positions);

    const auto expected_intersections = touchstone::intersections(mesh, x1);
    int intersects = -1;
    REQUIRE(touchstone_mesh_intersects(handle, given.x0.data(), 18, nullptr, &intersects) == TOUCHSTONE_OK);
    CHECK(intersects == (touchstone::intersects(mesh, x0) ? 1 : 0));
    REQUIRE(touchstone_mesh_intersects(handle, given.x1.data(), 18, nullptr, &intersects) == TOUCHSTONE_OK);
    CHECK(intersects == 1);
    touchstone_intersections* found = nullptr;
    REQUIRE(touchstone_mesh_intersections(handle, given.x1.data(), 18, nullptr, &found) == TOUCHSTONE_OK);
    REQUIRE(touchstone_intersections_count(found) == expected_intersections.size());
    CHECK(expected_intersections.size() == 3);  // all edges of the upper face
    for (std::size_t i = 0; i < expected_intersections.size(); ++i) {
      const touchstone::Intersection& one = expected_intersections[i];
      touchstone_intersection told;
      REQUIRE(touchstone_intersections_get(found, i, &told) == TOUCHSTONE_OK);
      CHECK(told.first_element == static_cast<int>(one.first_element));
      CHECK(told.second_element == static_cast<int>(one.second_element));
      CHECK(told.first == one.first);
      CHECK(told.second == one.second);
      CHECK(told.pierces == (one.sort == touchstone::IntersectionSort::pierces ? 1 : 0));
      CHECK(told.sort == static_cast<int>(one.sort));
      CHECK(std::equal(one.weights_first.begin(), one.weights_first.end(), told.weights_first));
      CHECK(std::equal(one.weights_second.begin(), one.weights_second.end(), told.weights_second));
    }

    touchstone_mesh_destroy(handle);  // the lists stay
    CHECK(touchstone_contacts_count(all) == every.size());
    touchstone_contacts_destroy(first);
    touchstone_contacts_destroy(at_start);
    touchstone_contacts_destroy(all);
    touchstone_intersections_destroy(found);
  }
}

TEST_CASE("float32 is an option of free steps, and asks for a start of such numbers") {
  touchstone_mesh_elements elements = TOUCHSTONE_MESH_ELEMENTS_INIT;
  elements.vertex_count = 2;
  touchstone_mesh* mesh = nullptr;
  REQUIRE(touchstone_mesh_create(&elements, &mesh) == TOUCHSTONE_OK);
  touchstone_options options = default_options();
  options.float32 = 1;
  std::vector<double> x0 = {0, 0, 0, 1, 0, 0}, x1 = {0.1, 0, 0, 1, 0, 0}, positions(6);
  const auto status = [&] {
    return touchstone_mesh_free_step(mesh, x0.data(), x1.data(), 6, &options, positions.data(), nullptr, nullptr,
                                     nullptr);
  };
  CHECK(status() == TOUCHSTONE_OK);
  CHECK(positions[0] == 0.1f);
  x0[0] = 0.1;
  CHECK(status() == TOUCHSTONE_INVALID_QUERY);
  CHECK(message_has("no float32 number"));
  touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
  CHECK(touchstone_mesh_first_contact(mesh, x0.data(), x1.data(), 6, &options, &result, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("float32 is set, and this function has no such option"));
  options.float32 = 2;
  CHECK(status() == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("float32 is 2; it must be 0 or 1"));
  touchstone_mesh_destroy(mesh);
}

TEST_CASE("each function refuses the options that it has not, and takes those that it has") {
  touchstone_mesh_elements elements = TOUCHSTONE_MESH_ELEMENTS_INIT;
  elements.vertex_count = 2;
  touchstone_mesh* mesh = nullptr;
  REQUIRE(touchstone_mesh_create(&elements, &mesh) == TOUCHSTONE_OK);
  const double x[] = {0, 0, 0, 1, 0, 0}, distance = 0.5;
  double positions[6];
  touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
  touchstone_bodies_elements no_bodies = TOUCHSTONE_BODIES_ELEMENTS_INIT;
  no_bodies.quaternion = TOUCHSTONE_QUATERNION_WXYZ;
  touchstone_bodies* bodies = nullptr;
  REQUIRE(touchstone_bodies_create(&no_bodies, &bodies) == TOUCHSTONE_OK);
  touchstone_first_body_contact first_of_bodies = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
  touchstone_body_contacts* of_bodies = nullptr;
  touchstone_contacts* contacts = nullptr;
  touchstone_intersections* found = nullptr;
  int intersects = 0;
  touchstone_answer answer;
  touchstone_options options = default_options();
  struct Function {
    std::string has;
    std::function<int()> ask;
  };
  const std::vector<Function> functions = {
      {"t_max separation metric wanted method ",
       [&] { return touchstone_solve(TOUCHSTONE_KIND_POINT_POINT, x, x, &options, &answer); }},
      {"t_max separation metric separations wanted method ",
       [&] { return touchstone_solve_rows(TOUCHSTONE_KIND_POINT_POINT, 1, x, x, &options, &answer); }},
      {"t_max check_start ",
       [&] { return touchstone_mesh_first_contact(mesh, x, x, 6, &options, &result, nullptr, nullptr); }},
      {"t_max ",
       [&] {
         touchstone_contacts_destroy(contacts);
         return touchstone_mesh_all_contacts(mesh, x, x, 6, &options, &contacts);
       }},
      {"",
       [&] {
         touchstone_intersections_destroy(found);
         return touchstone_mesh_intersections(mesh, x, 6, &options, &found);
       }},
      {"", [&] { return touchstone_mesh_intersects(mesh, x, 6, &options, &intersects); }},
      {"kept_fraction float32 check_start ",
       [&] { return touchstone_mesh_free_step(mesh, x, x, 6, &options, positions, nullptr, nullptr, nullptr); }},
      {"t_max check_start ",
       [&] { return touchstone_bodies_first_contact(bodies, x, x, 0, &options, &first_of_bodies, nullptr, nullptr); }},
      {"t_max ",
       [&] {
         touchstone_body_contacts_destroy(of_bodies);
         return touchstone_bodies_all_contacts(bodies, x, x, 0, &options, &of_bodies);
       }},
      {"check_start ",
       [&] { return touchstone_bodies_free_step(bodies, x, x, 0, &options, positions, nullptr, nullptr, nullptr); }}};
  const std::vector<std::pair<std::string, std::function<void()>>> changes = {
      {"t_max", [&] { options.t_max = 0.5; }},
      {"separation", [&] { options.separation = 0.5; }},
      {"metric", [&] { options.metric = TOUCHSTONE_METRIC_MAX; }},
      {"separations", [&] { options.separations = &distance, options.separation_count = 1; }},
      {"kept_fraction", [&] { options.kept_fraction = 0.5; }},
      {"wanted", [&] { options.wanted = TOUCHSTONE_WANTED_CONTACT; }},
      {"float32", [&] { options.float32 = 1; }},
      {"check_start", [&] { options.check_start = 1; }},
      {"method", [&] { options.method = TOUCHSTONE_METHOD_EXACT; }}};
  for (const Function& function : functions) {
    for (const auto& [name, change] : changes) {
      options = default_options();
      options.threads = 2;
      change();
      CAPTURE(function.has, name);
      const bool has = function.has.find(name + " ") != std::string::npos;
      CHECK(function.ask() == (has ? TOUCHSTONE_OK : TOUCHSTONE_INVALID_ARGUMENT));
      if (!has) CHECK(message_has(name + " is set, and this function has no such option"));
    }
  }
  touchstone_body_contacts_destroy(of_bodies);
  touchstone_bodies_destroy(bodies);
  touchstone_contacts_destroy(contacts);
  touchstone_intersections_destroy(found);
  touchstone_mesh_destroy(mesh);
}

TEST_CASE("the start of a step is asked about on request, and each sort of intersection arrives") {
  // An edge through a face, and a face that lies folded onto that one over their common edge.
  const std::vector<std::uint32_t> faces = {0, 1, 2, 0, 1, 3}, edges = {4, 5};
  touchstone_mesh_elements elements = TOUCHSTONE_MESH_ELEMENTS_INIT;
  elements.vertex_count = 6;
  elements.faces = faces.data();
  elements.face_count = 2;
  elements.edges = edges.data();
  elements.edge_count = 1;
  std::vector<double> x = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, -4, 0, 1, 1, -1, 1, 1, 1};
  touchstone_mesh* mesh = nullptr;
  REQUIRE(touchstone_mesh_create(&elements, &mesh) == TOUCHSTONE_OK);
  touchstone_options options = default_options();
  touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
  touchstone_intersections* found = nullptr;
  touchstone_first_contact whole_step = TOUCHSTONE_FIRST_CONTACT_INIT;
  double length = -1;
  int outcome = -1;
  std::vector<double> positions(18);
  const auto ask = [&] {
    REQUIRE(touchstone_mesh_first_contact(mesh, x.data(), x.data(), 18, &options, &result, nullptr, nullptr) ==
            TOUCHSTONE_OK);
    REQUIRE(touchstone_mesh_free_step(mesh, x.data(), x.data(), 18, &options, positions.data(), &length, &outcome,
                                      &whole_step) == TOUCHSTONE_OK);
    CHECK(whole_step.start_checked == result.start_checked);
    CHECK(whole_step.start_intersections == result.start_intersections);
  };
  ask();
  CHECK(result.free == 1);
  CHECK(result.start_checked == 0);
  CHECK(outcome == TOUCHSTONE_STEP_WHOLE);
  options.check_start = 1;
  ask();
  CHECK(result.contact == 0);
  CHECK(result.free == 0);
  CHECK(result.start_checked == 1);
  CHECK(result.start_intersections == 1);
  CHECK(outcome == TOUCHSTONE_STEP_INTERSECTS_AT_START);
  CHECK(length == 0);
  options.check_start = 2;
  CHECK(touchstone_mesh_first_contact(mesh, x.data(), x.data(), 18, &options, &result, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("check_start"));

  x[9] = 1, x[10] = 1;  // the fold
  REQUIRE(touchstone_mesh_intersections(mesh, x.data(), 18, nullptr, &found) == TOUCHSTONE_OK);
  int folds = 0, others = 0;
  for (std::size_t i = 0; i < touchstone_intersections_count(found); ++i) {
    touchstone_intersection told;
    REQUIRE(touchstone_intersections_get(found, i, &told) == TOUCHSTONE_OK);
    ++(told.sort == TOUCHSTONE_FOLDS ? folds : others);
  }
  CHECK(folds == 2);
  CHECK(others > 0);
  touchstone_intersections_destroy(found);
  touchstone_mesh_destroy(mesh);
}

TEST_CASE("the rules of a mesh arrive") {
  FallingTriangle given;
  const auto contacts = [&] {
    touchstone_mesh* mesh = nullptr;
    touchstone_contacts* all = nullptr;
    REQUIRE(touchstone_mesh_create(&given.elements, &mesh) == TOUCHSTONE_OK);
    REQUIRE(touchstone_mesh_all_contacts(mesh, given.x0.data(), given.x1.data(), 18, nullptr, &all) == TOUCHSTONE_OK);
    const std::size_t count = touchstone_contacts_count(all);
    touchstone_contacts_destroy(all);
    touchstone_mesh_destroy(mesh);
    return count;
  };
  const std::size_t all = contacts();
  const touchstone_mesh_pair tip{TOUCHSTONE_KIND_VERTEX_FACE, 3, 0};
  given.elements.excluded_pairs = &tip;
  given.elements.excluded_pair_count = 1;
  CHECK(contacts() == all - 1);
  given.elements.excluded_pair_count = 0;

  const std::vector<std::uint32_t> groups = {0, 0, 0, 1, 1, 1}, pair = {1, 0};
  given.elements.groups = groups.data();
  given.elements.group_count = 6;
  given.elements.group_pairs = pair.data();
  given.elements.group_pair_count = 1;
  CHECK(contacts() == 0);
  given.elements.only_listed_groups = 1;
  CHECK(contacts() == all);
  given.elements.only_listed_groups = 2;
  touchstone_mesh* mesh = nullptr;
  CHECK(touchstone_mesh_create(&given.elements, &mesh) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("only_listed_groups"));
  given.elements.only_listed_groups = 0;
  given.elements.group_count = given.elements.group_pair_count = 0;

  const double far = 8;
  given.elements.separate_pairs = &tip;
  given.elements.pair_separations = &far;
  given.elements.separate_pair_count = 1;
  touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
  touchstone_contacts* at_start = nullptr;
  REQUIRE(touchstone_mesh_create(&given.elements, &mesh) == TOUCHSTONE_OK);
  REQUIRE(touchstone_mesh_first_contact(mesh, given.x0.data(), given.x1.data(), 18, nullptr, &result, nullptr,
                                        &at_start) == TOUCHSTONE_OK);
  CHECK(touchstone_contacts_count(at_start) == 1);
  touchstone_contacts_destroy(at_start);
  touchstone_mesh_destroy(mesh);
}

TEST_CASE("what is wrong with a mesh is a status and a message, and no handle") {
  FallingTriangle given;
  touchstone_mesh* const kNotNull = reinterpret_cast<touchstone_mesh*>(&given);
  touchstone_mesh* mesh = kNotNull;
  const auto create = [&](touchstone_mesh_elements elements) {
    mesh = kNotNull;
    const int status = touchstone_mesh_create(&elements, &mesh);
    CHECK((mesh == nullptr) == (status != TOUCHSTONE_OK));
    return status;
  };
  CHECK(touchstone_mesh_create(nullptr, &mesh) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(mesh == nullptr);
  CHECK(touchstone_mesh_create(&given.elements, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_mesh_elements wrong = given.elements;
  wrong.vertex_count = 5;
  CHECK(create(wrong) == TOUCHSTONE_INVALID_MESH);
  CHECK(message_has("vertex 5"));
  wrong = given.elements;
  wrong.faces = nullptr;
  CHECK(create(wrong) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("faces is a null pointer"));
  wrong = given.elements;
  wrong.face_count = std::numeric_limits<std::size_t>::max() / 12 + 2;
  CHECK(create(wrong) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("more than memory"));
  wrong = given.elements;
  wrong.metric = 7;
  CHECK(create(wrong) == TOUCHSTONE_INVALID_ARGUMENT);
  wrong = given.elements;
  wrong.size -= sizeof(double);
  CHECK(create(wrong) == TOUCHSTONE_INVALID_ARGUMENT);
  wrong = given.elements;
  const touchstone_mesh_pair unknown{9, 0, 0};
  wrong.excluded_pairs = &unknown;
  wrong.excluded_pair_count = 1;
  CHECK(create(wrong) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("the kind is 9"));

  REQUIRE(create(given.elements) == TOUCHSTONE_OK);
  touchstone_first_contact result = TOUCHSTONE_FIRST_CONTACT_INIT;
  touchstone_contacts* list = reinterpret_cast<touchstone_contacts*>(&given);
  const double* x0 = given.x0.data();
  const double* x1 = given.x1.data();
  CHECK(touchstone_mesh_first_contact(nullptr, x0, x1, 18, nullptr, &result, &list, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(list == nullptr);
  CHECK(touchstone_mesh_first_contact(mesh, x0, x1, 17, nullptr, &result, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("17 values"));
  CHECK(touchstone_mesh_first_contact(mesh, nullptr, x1, 18, nullptr, &result, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_mesh_first_contact(mesh, x0, x1, 18, nullptr, nullptr, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  for (const std::size_t size : {std::size_t{0}, sizeof result - 1, sizeof result + 1}) {
    result.size = size;
    CHECK(touchstone_mesh_first_contact(mesh, x0, x1, 18, nullptr, &result, nullptr, nullptr) ==
          TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(message_has("result has the size"));
  }
  result = TOUCHSTONE_FIRST_CONTACT_INIT;
  CHECK(touchstone_mesh_all_contacts(mesh, x0, x1, 18, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_mesh_intersections(mesh, x0, 18, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_mesh_intersects(mesh, x0, 18, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  std::vector<double> positions(18);
  touchstone_options options = default_options();
  options.kept_fraction = 1;
  CHECK(touchstone_mesh_free_step(mesh, x0, x1, 18, &options, positions.data(), nullptr, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_QUERY);
  CHECK(touchstone_mesh_free_step(mesh, x0, x1, 18, nullptr, nullptr, nullptr, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  given.x1[4] = std::nan("");
  CHECK(touchstone_mesh_first_contact(mesh, x0, x1, 18, nullptr, &result, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_QUERY);
  CHECK(message_has("vertex 1"));
  touchstone_mesh_destroy(mesh);

  CHECK(touchstone_mesh_keep(nullptr, 1) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_mesh_destroy(nullptr);
  touchstone_contacts_destroy(nullptr);
  touchstone_intersections_destroy(nullptr);
  CHECK(touchstone_contacts_count(nullptr) == 0);
  CHECK(touchstone_intersections_count(nullptr) == 0);
  touchstone_intersection one;
  CHECK(touchstone_contacts_get(nullptr, 0, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_intersections_get(nullptr, 0, &one) == TOUCHSTONE_INVALID_ARGUMENT);
}

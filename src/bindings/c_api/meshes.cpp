// Meshes by the C interface. Meshes and lists are objects behind handles.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/mesh.hpp>
#include <touchstone/mesh_steps.hpp>

#include "c_api/answers.hpp"
#include "c_api/guard.hpp"
#include "c_api/handles.hpp"

struct touchstone_contacts {
  std::vector<touchstone::MeshContact> all;
};

struct touchstone_intersections {
  std::vector<touchstone::Intersection> all;
};

namespace touchstone::c_api {

namespace {

static_assert(TOUCHSTONE_ELEMENT_VERTEX == static_cast<int>(MeshElement::vertex));
static_assert(TOUCHSTONE_ELEMENT_EDGE == static_cast<int>(MeshElement::edge));
static_assert(TOUCHSTONE_ELEMENT_FACE == static_cast<int>(MeshElement::face));
static_assert(TOUCHSTONE_STEP_WHOLE == static_cast<int>(StepOutcome::whole));
static_assert(TOUCHSTONE_STEP_SHORTENED == static_cast<int>(StepOutcome::shortened));
static_assert(TOUCHSTONE_STEP_NO_ROOM == static_cast<int>(StepOutcome::no_room));
static_assert(TOUCHSTONE_STEP_CONTACT_AT_START == static_cast<int>(StepOutcome::contact_at_start));
static_assert(TOUCHSTONE_STEP_INTERSECTS_AT_START == static_cast<int>(StepOutcome::intersects_at_start));
static_assert(TOUCHSTONE_TOUCHES == static_cast<int>(IntersectionSort::touches));
static_assert(TOUCHSTONE_PIERCES == static_cast<int>(IntersectionSort::pierces));
static_assert(TOUCHSTONE_FOLDS == static_cast<int>(IntersectionSort::folds));
static_assert(TOUCHSTONE_INSIDE == static_cast<int>(IntersectionSort::inside));

/// What version 1 of the structure had.
constexpr std::size_t kFirstElementsSize =
    offsetof(touchstone_mesh_elements, only_listed_groups) + sizeof(touchstone_mesh_elements::only_listed_groups);

MeshPair pair_of(const touchstone_mesh_pair& pair) { return {kind_of(pair.kind), pair.first, pair.second}; }

MeshElements elements_of(const touchstone_mesh_elements& given) {
  MeshElements elements;
  elements.vertex_count = given.vertex_count;
  elements.dimension = given.dimension;
  elements.separation = {given.separation, metric_of(given.metric)};
  elements.radii = values(given.radii, given.radius_count, "radii");
  elements.faces = indices<3>(given.faces, given.face_count, "faces");
  elements.edges = indices<2>(given.edges, given.edge_count, "edges");
  if (given.points != nullptr || given.point_count > 0) {
    elements.points = values(given.points, given.point_count, "points");
  }
  CollisionRules& rules = elements.rules;
  rules.vertex_pairs = indices<2>(given.excluded_vertices, given.excluded_vertex_count, "excluded_vertices");
  array(given.excluded_pairs, given.excluded_pair_count, 1, "excluded_pairs");
  for (std::size_t i = 0; i < given.excluded_pair_count; ++i) {
    rules.element_pairs.push_back(pair_of(given.excluded_pairs[i]));
  }
  array(given.separate_pairs, given.separate_pair_count, 1, "separate_pairs");
  array(given.pair_separations, given.separate_pair_count, 1, "pair_separations");
  for (std::size_t i = 0; i < given.separate_pair_count; ++i) {
    elements.pair_separations.push_back({pair_of(given.separate_pairs[i]), given.pair_separations[i]});
  }
  rules.groups = values(given.groups, given.group_count, "groups");
  rules.group_pairs = indices<2>(given.group_pairs, given.group_pair_count, "group_pairs");
  rules.group_rule = group_rule_of(given.only_listed_groups);
  return elements;
}

/// Positions of as many vertices as there are doubles for; the functions of a mesh check the number of vertices.
Positions positions_of(const Mesh& mesh, const double* first, std::size_t value_count, const char* name) {
  array(first, value_count, 1, name);
  const auto dimension = static_cast<std::size_t>(mesh.dimension());
  if (value_count % dimension != 0 || value_count / dimension != mesh.vertex_count()) {
    throw InvalidArgument(std::string(name) + " has " + std::to_string(value_count) + " values, and the mesh has " +
                          std::to_string(mesh.vertex_count()) + " vertices with " + std::to_string(dimension) +
                          " coordinates each");
  }
  return {first, mesh.vertex_count(), mesh.dimension()};
}

FirstContactOptions asked_of(const touchstone_options& options) {
  FirstContactOptions asked;
  asked.threads = options.threads;
  asked.t_max = options.t_max;
  asked.check_start = flag(options.check_start, "check_start");
  return asked;
}

touchstone_first_contact c_first_contact(const FirstContact& found) {
  return {sizeof(touchstone_first_contact),
          found.contact ? 1 : 0,
          found.free() ? 1 : 0,
          found.toi,
          found.toi_upper,
          found.start_intersections.size(),
          found.start_checked ? 1 : 0,
          0};
}

}  // namespace

}  // namespace touchstone::c_api

using namespace touchstone;
using namespace touchstone::c_api;

extern "C" {

int touchstone_mesh_create(const touchstone_mesh_elements* elements, touchstone_mesh** mesh) {
  clear(mesh);
  return guarded([&] {
    required(mesh, "mesh");
    const touchstone_mesh_elements defaults = TOUCHSTONE_MESH_ELEMENTS_INIT;
    const auto given = grown(required(elements, "elements"), defaults, kFirstElementsSize, "elements");
    *mesh = new touchstone_mesh{Mesh(elements_of(given))};
  });
}

void touchstone_mesh_destroy(touchstone_mesh* mesh) { delete mesh; }

int touchstone_mesh_keep(touchstone_mesh* mesh, int keep) {
  return guarded([&] {
    required(mesh, "mesh");
    mesh->steps = flag(keep, "keep") ? std::make_unique<MeshSteps>(mesh->mesh) : nullptr;
  });
}

int touchstone_mesh_has_pairs(const touchstone_mesh* mesh, int* has_pairs) {
  return guarded([&] { required(has_pairs, "has_pairs") = required(mesh, "mesh").mesh.has_pairs() ? 1 : 0; });
}

int touchstone_mesh_edge(const touchstone_mesh* mesh, std::size_t edge, std::uint32_t corners[2]) {
  return guarded([&] {
    const auto& edges = required(mesh, "mesh").mesh.edges();
    required(corners, "corners");
    check_index(edge, edges.size());
    std::copy_n(edges[edge].begin(), 2, corners);
  });
}

int touchstone_mesh_first_contact(const touchstone_mesh* mesh, const double* x0, const double* x1,
                                  std::size_t value_count, const touchstone_options* given,
                                  touchstone_first_contact* result, touchstone_contacts** first,
                                  touchstone_contacts** at_start) {
  clear(first);
  clear(at_start);
  return guarded([&] {
    const Mesh& of = required(mesh, "mesh").mesh;
    const touchstone_options options = options_of(given, kHasTMax | kHasCheckStart);
    check_size(required(result, "result"), "result");
    const Positions start = positions_of(of, x0, value_count, "x0"), end = positions_of(of, x1, value_count, "x1");
    FirstContact contact = mesh->steps ? mesh->steps->first_contact(start, end, asked_of(options))
                                       : first_contact(of, start, end, asked_of(options));
    const touchstone_first_contact told = c_first_contact(contact);
    hand_over(contact.earliest, first, contact.at_start, at_start);
    *result = told;
  });
}

int touchstone_mesh_all_contacts(const touchstone_mesh* mesh, const double* x0, const double* x1,
                                 std::size_t value_count, const touchstone_options* given,
                                 touchstone_contacts** contacts) {
  clear(contacts);
  return guarded([&] {
    const Mesh& of = required(mesh, "mesh").mesh;
    const touchstone_options options = options_of(given, kHasTMax);
    required(contacts, "contacts");
    const Positions start = positions_of(of, x0, value_count, "x0"), end = positions_of(of, x1, value_count, "x1");
    *contacts = new touchstone_contacts{mesh->steps ? mesh->steps->all_contacts(start, end, asked_of(options))
                                                    : all_contacts(of, start, end, asked_of(options))};
  });
}

std::size_t touchstone_contacts_count(const touchstone_contacts* contacts) { return count_of(contacts); }

int touchstone_contacts_get(const touchstone_contacts* contacts, std::size_t index, touchstone_mesh_pair* pair,
                            touchstone_answer* answer) {
  return guarded([&] {
    const MeshContact& contact = item_of(contacts, index, "contacts");
    if (pair != nullptr) *pair = {static_cast<int>(contact.pair.kind), contact.pair.first, contact.pair.second};
    if (answer != nullptr) *answer = c_answer(contact.answer);
  });
}

void touchstone_contacts_destroy(touchstone_contacts* contacts) { delete contacts; }

int touchstone_mesh_intersections(const touchstone_mesh* mesh, const double* x, std::size_t value_count,
                                  const touchstone_options* given, touchstone_intersections** found) {
  clear(found);
  return guarded([&] {
    const Mesh& of = required(mesh, "mesh").mesh;
    const touchstone_options options = options_of(given, 0);
    required(found, "intersections");
    *found = new touchstone_intersections{intersections(of, positions_of(of, x, value_count, "x"), asked_of(options))};
  });
}

int touchstone_mesh_intersects(const touchstone_mesh* mesh, const double* x, std::size_t value_count,
                               const touchstone_options* given, int* found) {
  return guarded([&] {
    const Mesh& of = required(mesh, "mesh").mesh;
    const touchstone_options options = options_of(given, 0);
    int& told = required(found, "intersects");
    told = intersects(of, positions_of(of, x, value_count, "x"), asked_of(options)) ? 1 : 0;
  });
}

std::size_t touchstone_intersections_count(const touchstone_intersections* found) { return count_of(found); }

int touchstone_intersections_get(const touchstone_intersections* found, std::size_t index,
                                 touchstone_intersection* intersection) {
  return guarded([&] {
    const Intersection& one = item_of(found, index, "intersections");
    touchstone_intersection told{};
    told.first_element = static_cast<int>(one.first_element);
    told.first = one.first;
    told.second_element = static_cast<int>(one.second_element);
    told.second = one.second;
    told.pierces = one.sort == IntersectionSort::pierces ? 1 : 0;
    told.sort = static_cast<int>(one.sort);
    std::copy(one.weights_first.begin(), one.weights_first.end(), told.weights_first);
    std::copy(one.weights_second.begin(), one.weights_second.end(), told.weights_second);
    required(intersection, "intersection") = told;
  });
}

void touchstone_intersections_destroy(touchstone_intersections* found) { delete found; }

int touchstone_mesh_free_step(const touchstone_mesh* mesh, const double* x0, const double* x1, std::size_t value_count,
                              const touchstone_options* given, double* positions, double* length, int* outcome,
                              touchstone_first_contact* contact) {
  return guarded([&] {
    const Mesh& of = required(mesh, "mesh").mesh;
    const touchstone_options options = options_of(given, kHasKeptFraction | kHasFloat32 | kHasCheckStart);
    array(positions, value_count, 1, "positions");
    if (contact != nullptr) check_size(*contact, "contact");
    FreeStepOptions asked{{options.threads}, options.kept_fraction};
    asked.check_start = flag(options.check_start, "check_start");
    asked.float32 = flag(options.float32, "float32");
    const Positions start = positions_of(of, x0, value_count, "x0"), end = positions_of(of, x1, value_count, "x1");
    const FreeStep step = mesh->steps ? mesh->steps->free_step(start, end, asked) : free_step(of, start, end, asked);
    std::copy(step.positions.begin(), step.positions.end(), positions);
    if (length != nullptr) *length = step.length;
    if (outcome != nullptr) *outcome = static_cast<int>(step.outcome);
    if (contact != nullptr) *contact = c_first_contact(step.first_contact);
  });
}

}  // extern "C"

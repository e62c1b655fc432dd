// Asks a few queries whose answers are known by construction, and checks all of each answer. Exit status 0 when right.
// SPDX-License-Identifier: MIT
#include <touchstone/fuzz.hpp>
#include <touchstone/touchstone.hpp>

#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace {

int failures = 0;

void check(bool ok, const char* what) {
  if (!ok) {
    std::printf("wrong: %s\n", what);
    ++failures;
  }
}

/// Flush-to-zero and denormals-are-zero, as the start-up code of -ffast-math sets them.
bool flushes() {
#if defined(__SSE2__)
  return (_mm_getcsr() & 0x8040U) == 0x8040U;
#else
  return CONSUMER_FLUSHES != 0;
#endif
}

constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// p moves from 0 to 4 tiny past q at 3 tiny: contact at t = 3/4. A flushed subnormal would put it at t = 0.
touchstone::PointPoint subnormal_contact() {
  return {{touchstone::Vec3{0, 0, 0}, touchstone::Vec3{3 * kTiny, 0, 0}},
          {touchstone::Vec3{4 * kTiny, 0, 0}, touchstone::Vec3{3 * kTiny, 0, 0}}};
}

/// Edges that cross at right angles in projection, the smallest subnormal apart all along: no contact.
touchstone::EdgeEdge subnormal_gap() {
  const std::array<touchstone::Vec3, 4> corners = {touchstone::Vec3{-1, 0, 0}, touchstone::Vec3{1, 0, 0},
                                                   touchstone::Vec3{0, -1, kTiny}, touchstone::Vec3{0, 1, kTiny}};
  return {corners, corners};
}

/// v falls from z = 1 to z = -1 through the middle of the edge f0 f1 at t = 1/2.
touchstone::VertexFace falling_vertex() {
  const touchstone::Vec3 f0{-1, 0, 0};
  const touchstone::Vec3 f1{1, 0, 0};
  const touchstone::Vec3 f2{0, 1, 0};
  return {{touchstone::Vec3{0, 0, 1}, f0, f1, f2}, {touchstone::Vec3{0, 0, -1}, f0, f1, f2}};
}

void check_answers(touchstone::Method method) {
  touchstone::SolveOptions options;
  options.method = method;
  const touchstone::Answer contact = touchstone::solve(subnormal_contact(), options);
  check(contact.contact && contact.toi == 0.75 && contact.toi_upper == 0.75, "subnormal contact at t = 3/4");
  check(contact.nature == touchstone::Nature::isolated, "subnormal contact is isolated");

  check(!touchstone::solve(subnormal_gap(), options).contact, "edges a subnormal apart do not touch");

  const touchstone::Answer face = touchstone::solve(falling_vertex(), options);
  check(face.contact && face.toi == 0.5 && face.toi_upper == 0.5, "vertex-face contact at t = 1/2");
  check(face.nature == touchstone::Nature::crossing, "vertex-face contact crosses");
  check(face.feature_a == touchstone::Feature::v && face.feature_b == touchstone::Feature::f01, "features v and f01");
  check(face.weights_b[0] == 0.5 && face.weights_b[1] == 0.5 && face.weights_b[2] == 0, "weights 1/2, 1/2, 0");
}

}  // namespace

int main() {
  check(std::string(touchstone::version()) == EXPECTED_VERSION, "the version");
  check(flushes() == (CONSUMER_FLUSHES != 0),
        "the program was not started with the floating-point environment under test");

  check_answers(touchstone::Method::fast);
  check_answers(touchstone::Method::exact);
  for (const auto method : {touchstone::Method::oracle, touchstone::Method::fast_cgal}) {
    try {
      check_answers(method);
      check(CONSUMER_WITH_CGAL != 0, "the library was to be built without CGAL");
    } catch (const touchstone::InvalidQuery& error) {
      check(CONSUMER_WITH_CGAL == 0 && std::string(error.what()).find("without it") != std::string::npos,
            "only a library without CGAL refuses its methods, and says so");
    }
  }

  touchstone::BatchOptions options;
  options.threads = 2;
  const std::vector<touchstone::Query> queries = {subnormal_contact(), subnormal_gap(), falling_vertex()};
  const std::vector<touchstone::Answer> answers = touchstone::solve_batch(queries, options);
  check(answers.size() == 3 && answers[0].toi == 0.75 && !answers[1].contact && answers[2].toi == 0.5, "a batch");

  const auto times = touchstone::contact_times(subnormal_contact());
  check(times.size() == 1 && times[0].first.compare(0.75) == 0 && times[0].last.to_string() == "3/4", "contact times");

  touchstone::MeshElements elements;
  elements.vertex_count = 4;
  elements.faces = {{0, 1, 2}};
  const touchstone::Mesh mesh(elements);
  const std::vector<double> start = {-1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.5, 3 * kTiny};
  std::vector<double> end = start;
  end[11] = -kTiny;
  touchstone::FirstContactOptions two_threads;
  two_threads.threads = 2;
  const auto first = touchstone::first_contact(mesh, {start, 3}, {end, 3}, two_threads);
  check(first.toi == 0.75 && first.earliest.size() == 1, "the first contact of a mesh, among subnormals");
  const touchstone::FreeStep step = touchstone::free_step(mesh, {start, 3}, {end, 3});
  check(touchstone::first_contact(mesh, {start, 3}, {step.positions, 3}).free(), "a free step");

  touchstone::FuzzOptions fuzzing;
  fuzzing.cases = 2000;
  const auto ours = [](const touchstone::Query& query) {
    const touchstone::Answer answer = touchstone::solve(query);
    return touchstone::Claim{answer.contact, answer.toi};
  };
  check(touchstone::fuzz_solver(ours, fuzzing).failures == 0, "a solver that is right is found right");
  const auto denies = [](const touchstone::Query&) { return touchstone::Claim{}; };
  const touchstone::FuzzReport broken = touchstone::fuzz_solver(denies, fuzzing);
  check(broken.queries == 2000 && broken.failures > 500 && !broken.findings.empty(),
        "a solver that denies all is broken");
  check(touchstone::to_string(broken.findings.front()).rfind("missed ", 0) == 0, "and told how");

  bool refused = false;
  try {
    touchstone::solve(subnormal_contact(), 2.0);
  } catch (const touchstone::InvalidQuery&) {
    refused = true;
  }
  check(refused, "t_max = 2 is refused with the library's own exception");
  check(flushes() == (CONSUMER_FLUSHES != 0), "the floating-point environment was not restored");

  std::printf("touchstone %s, %s: %s\n", touchstone::version(),
              CONSUMER_FLUSHES ? "flush-to-zero" : "default environment",
              failures == 0 ? "every answer is right" : "some answers are wrong");
  return failures == 0 ? 0 : 1;
}

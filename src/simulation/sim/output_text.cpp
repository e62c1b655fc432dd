// SPDX-License-Identifier: MIT
#include "sim/output_text.hpp"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::sim {

namespace {

/// A corner of a frame.
struct FramePoint {
  Vector3 position, velocity;
};

/// Points and elements of particles, then those of bodies.
struct Frame {
  std::vector<FramePoint> points;
  std::vector<Index> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
};

void add_bodies(const SimulatedBodies& bodies, Frame& frame) {
  for (Index b = 0; b < bodies.system().bodies().size(); ++b) {
    const RigidBody& body = bodies.system().bodies()[b];
    const BodyState& state = bodies.state().bodies[b];
    const Vector3 spin =
        body.is_free() ? angular_velocity(body.inertia, state.pose.q, state.momentum) : body.angular_velocity;
    const Vector3 velocity = body.is_free() ? state.velocity : body.velocity;
    const Matrix3 turn = matrix_of(state.pose.q);
    for (const Vector3& x : body.points) {
      const Vector3 arm = turn * x;
      frame.points.push_back({state.pose.p + arm, velocity + spin.cross(arm)});
    }
  }
}

}  // namespace

std::string vtk_frame(const Simulation& simulation) {
  const auto& colliders = simulation.colliders();
  Frame frame;
  for (Index p = 0; p < simulation.scene().particles.size(); ++p) {
    frame.points.push_back({position(simulation.state().q, p), position(simulation.state().v, p)});
  }
  frame.vertices = colliders.points();
  for (Index e = 0; e < colliders.edges().size(); ++e) {
    if (e < colliders.before(1).edges || colliders.is_bare(e)) frame.edges.push_back(colliders.edges()[e]);
  }
  frame.faces = colliders.faces();
  if (simulation.bodies() != nullptr) add_bodies(*simulation.bodies(), frame);
  std::string text =
      fmt::format("# vtk DataFile Version 3.0\ntouchstone t = {:.9g} s\nASCII\nDATASET POLYDATA\nPOINTS {} double\n",
                  simulation.state().time, frame.points.size());
  for (const auto& [x, v] : frame.points) text += fmt::format("{} {} {}\n", x.x(), x.y(), x.z());
  if (!frame.vertices.empty()) {
    text += fmt::format("VERTICES {} {}\n", frame.vertices.size(), 2 * frame.vertices.size());
    for (const Index point : frame.vertices) text += fmt::format("1 {}\n", point);
  }
  if (!frame.edges.empty()) {
    text += fmt::format("LINES {} {}\n", frame.edges.size(), 3 * frame.edges.size());
    for (const Edge& edge : frame.edges) text += fmt::format("2 {} {}\n", edge[0], edge[1]);
  }
  if (!frame.faces.empty()) {
    text += fmt::format("POLYGONS {} {}\n", frame.faces.size(), 4 * frame.faces.size());
    for (const Face& face : frame.faces) text += fmt::format("3 {} {} {}\n", face[0], face[1], face[2]);
  }
  text += fmt::format("POINT_DATA {}\nVECTORS velocity double\n", frame.points.size());
  for (const auto& [x, v] : frame.points) text += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
  return text;
}

std::string vtk_series(const std::vector<SeriesFrame>& frames) {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
  const char* separator = "\n";
  for (const SeriesFrame& frame : frames) {
    text += fmt::format("{}    {{\"name\": \"{}\", \"time\": {}}}", separator, frame.name, frame.time);
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

std::string proof_header(const Simulation& simulation) {
  const char* const separations =
      simulation.has_separations() ? "entering,separated,least_separation,largest_separation," : "";
  const std::string bodies = simulation.bodies() == nullptr
                                 ? ""
                                 : "body_close,body_contacts,body_passes,body_sweeps,body_zones,body_pairs,body_filter,"
                                   "body_exact,";
  return std::string(
             "step,time,length,newton_iterations,first_order,close,contacts,crossing,grazing,sustained,isolated,"
             "response_"
             "queries,"
             "response_filter,response_bracket,response_exact,impulse_passes,contact_solves,impact_zones,pairs,proof_"
             "filter,"
             "proof_bracket,proof_exact,") +
         separations + bodies + "gained_energy,crossings,certified\n";
}

std::string proof_row(const Simulation& simulation, const SubstepRecord& r) {
  const auto& c = r.response;
  const auto entering = c.natures[static_cast<std::size_t>(Nature::entering)];
  const std::string separations = simulation.has_separations()
                                      ? fmt::format("{},{},{:a},{:a},", entering, r.proof.separations.pairs,
                                                    r.proof.separations.least, r.proof.separations.largest)
                                      : "";
  const BodyCounts& b = r.bodies;
  const std::string bodies = simulation.bodies() == nullptr
                                 ? ""
                                 : fmt::format("{},{},{},{},{},{},{},{},", b.close, b.contacts, b.passes, b.sweeps,
                                               b.zones, b.pairs, b.proof.filter, b.proof.bracket + b.proof.exact);
  return fmt::format("{},{:a},{:a},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}{},{},{}\n", r.step,
                     r.time, r.length, r.newton_iterations, r.first_order, c.close, c.contacts, c.natures[1],
                     c.natures[2], c.natures[3], c.natures[4], c.queries, c.levels.filter, c.levels.bracket,
                     c.levels.exact, c.passes, c.solves, c.zones, r.proof.pairs, r.proof.levels.filter,
                     r.proof.levels.bracket, r.proof.levels.exact, separations, bodies, r.gained_energy,
                     r.proof.crossings, r.proof.crossings == 0 ? 1 : 0);
}

std::string energy_header(const std::optional<Followed>& follow) {
  return std::string(
             "step,time,kinetic,stretch,bend,twist,load,total,parts,close,contacts,pairs,driven,drag,damping,friction,"
             "impacts,corrections,numerical") +
         (follow ? header_of(*follow) : "") + "\n";
}

std::string energy_row(const Simulation& simulation, const std::vector<SubstepRecord>& records,
                       const std::optional<Followed>& follow) {
  const Energies e = simulation.energies();
  std::uint64_t close = 0, contacts = 0, pairs = 0;
  EnergyFlows flows;
  double numerical = 0;
  for (const SubstepRecord& record : records) {
    close += record.response.close + record.bodies.close;
    contacts += record.response.contacts + record.bodies.contacts;
    pairs += record.proof.pairs + record.bodies.pairs;
    flows += record.flows;
    numerical += record.numerical;
  }
  std::string row = fmt::format("{},{:.9g}", simulation.steps(), simulation.state().time);
  const auto add = [&row](const std::vector<double>& numbers) {
    for (const double number : numbers) row += fmt::format(",{:.9g}", number);
  };
  add({e.kinetic, e.stretch, e.bend, e.twist, e.load, e.total()});
  row += fmt::format(",{},{},{},{}", records.size(), close, contacts, pairs);
  add({flows.driven, flows.drag, flows.damping, flows.friction, flows.impacts, flows.corrections, numerical});
  if (follow) add(values_of(simulation, *follow));
  return row + "\n";
}

std::string crossing_for_person(const Simulation& simulation, const Crossing& crossing) {
  return fmt::format("step {}, {:.9g} s: {} at ({:.6g}, {:.6g}, {:.6g}) ({})", crossing.step, crossing.time,
                     simulation.colliders().describe(crossing.pair), crossing.point.x(), crossing.point.y(),
                     crossing.point.z(), name_of(crossing.answer.nature));
}

namespace {

std::string number_of(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

constexpr const char* kNothingMoves = "nothing that collides can move";

std::string why_edges(const Colliders& colliders) {
  const std::size_t edges = colliders.before(1).edges;
  if (!colliders.passes().edge_edge && edges > 1) return kNothingMoves;
  return edges == 1 ? "1 edge" : fmt::format("{} edges", edges);
}

std::string why_faces(const Colliders& colliders) {
  const Passes& passes = colliders.passes();
  const std::size_t faces = colliders.before(1).faces;
  if (!passes.vertex_face && faces > 0) {
    return passes.anything_moves ? "no particle collides but the corners of one face" : kNothingMoves;
  }
  return faces == 1 ? "1 face" : fmt::format("{} faces", faces);
}

std::string why_separations(const Simulation& simulation) {
  const Colliders& colliders = simulation.colliders();
  if (simulation.ignores_radii()) return "the narrow phase of the paper knows none: radii are left aside";
  if (!simulation.has_separations()) return "no element has a radius";
  std::string bodies;
  if (simulation.bodies() != nullptr) {
    std::size_t thick = 0;
    double most = 0;
    for (const Body& body : simulation.scene().bodies) {
      thick += body.radius > 0 ? 1 : 0;
      most = std::max(most, body.radius);
    }
    if (thick > 0)
      bodies =
          fmt::format("{} with radii of up to {} m", thick == 1 ? "1 body" : fmt::format("{} bodies", thick), most);
    if (colliders.with_radius() == 0) return bodies;
    if (!bodies.empty()) bodies += "; ";
  }
  return bodies + fmt::format("{} with radii of up to {} m; {} of particles are neighbours",
                              number_of(colliders.with_radius(), "element"), colliders.largest_radius(),
                              number_of(colliders.neighbours().count(), "pair"));
}

std::string why_points(const Colliders& colliders) {
  const Passes& passes = colliders.passes();
  if (passes.points) return fmt::format("{} without edges collide with edges and each other", passes.free_points);
  if (passes.free_points == 0) {
    return passes.not_colliding == 0
               ? "every particle is in an edge"
               : fmt::format("every particle is in an edge, but {} that \"collides\": false exempts",
                             passes.not_colliding);
  }
  return passes.anything_moves ? "one particle is without edges, and there is nothing else" : kNothingMoves;
}

}  // namespace

std::string explain(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Colliders& colliders = simulation.colliders();
  const Passes& passes = colliders.passes();
  const auto line = [](bool on, std::string_view name, const std::string& why) {
    return fmt::format("{:4} {:22} {}\n", on ? "yes" : "no", name, why);
  };
  const auto count_if = [&](auto&& predicate) {
    return std::count_if(scene.cables.begin(), scene.cables.end(), predicate);
  };
  const auto bending = count_if([](const Cable& c) { return c.bend > 0; });
  const auto twisting = count_if([](const Cable& c) { return c.twist > 0; });
  const auto& contact = scene.settings.contact;
  std::string text;
  text += line(!simulation.system().stretch_elements.empty(), "stretch forces",
               fmt::format("{} springs and {} cables", scene.springs.size(), scene.cables.size()));
  text +=
      line(bending > 0, "bending forces", fmt::format("{} of {} cables resist bending", bending, scene.cables.size()));
  text +=
      line(twisting > 0, "twist angles", fmt::format("{} of {} cables resist twist", twisting, scene.cables.size()));
  const auto& cloth = simulation.system().cloth;
  if (!cloth.membranes.empty()) {
    text +=
        line(true, "cloth forces",
             fmt::format("{} triangles that stretch, {} edges that bend", cloth.membranes.size(), cloth.hinges.size()));
  }
  text += line(scene.settings.drag > 0, "drag", fmt::format("coefficient {} 1/s", scene.settings.drag));
  text += line(passes.edge_edge, "edge-edge pass", why_edges(colliders));
  text += line(passes.vertex_face, "vertex-face pass", why_faces(colliders));
  text += line(passes.joints, "fold pass (planar)",
               passes.joints ? "edges share particles that can move" : "no edges share a particle and can move");
  text += line(passes.points, "single-particle pass", why_points(colliders));
  text += line(simulation.has_separations(), "separations", why_separations(simulation));
  if (const SimulatedBodies* const bodies = simulation.bodies()) {
    const auto& all = bodies->system().bodies();
    const auto free = std::count_if(all.begin(), all.end(), [](const RigidBody& body) { return body.is_free(); });
    const Colliders::Counts &particles = colliders.before(1), &end = colliders.before(colliders.group_count());
    text += line(
        true, "body pass",
        fmt::format("{} bodies, {} of which are free: {} vertices, {} edges and {} faces that turn", all.size(), free,
                    end.vertices - particles.vertices, end.edges - particles.edges, end.faces - particles.faces));
  } else {
    text += line(false, "body pass", "0 bodies");
  }
  text += line(contact.friction > 0, "friction", fmt::format("coefficient {}", contact.friction));
  text += fmt::format("     integrator             {}, steps of {} s\n", integrator_name(scene.settings.integrator),
                      scene.settings.time_step);
  if (const Settings& settings = scene.settings; settings.tolerance > 0) {
    text += fmt::format("     tolerance              {} m a second; shorter substeps keep it\n", settings.tolerance);
  }
  text += fmt::format("     contact                restitution {}, thickness {} m, at most {} passes of impulses\n",
                      contact.restitution,
                      simulation.bodies() != nullptr ? simulation.bodies()->thickness() : simulation.thickness(),
                      contact.passes);
  return text;
}

}  // namespace touchstone::sim

// SPDX-License-Identifier: MIT
#include "cli/simulate/output.hpp"

#include <fmt/format.h>

#include <exception>

#include <touchstone/error.hpp>

#include "cli/shared/animation_file.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "cli/simulate/paths.hpp"
#include "io/fail.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"
#include "io/write_whole.hpp"
#include "sim/checkpoint.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

// They are all open at once, and a process may have a thousand files or so.
constexpr std::size_t kMostQueryFiles = 256;

Vec3 vec(const sim::Vector3& x) { return {x.x(), x.y(), x.z()}; }

/// The elements that collide, by the numbers of their particles, and of the vertices of bodies after them.
proofs::MotionElements motion_elements(const sim::Simulation& simulation) {
  const sim::Colliders& colliders = simulation.colliders();
  const auto of_particles = colliders.edges_of(sim::kParticles);
  proofs::MotionElements elements;
  elements.points = proofs::colliding_vertices({of_particles.begin(), of_particles.end()}, colliders.points());
  elements.edges = colliders.edges();
  elements.faces = colliders.faces();
  elements.vertex_count = simulation.scene().particles.size();
  for (sim::Index b = 0; b + 1 < colliders.group_count(); ++b) {
    for (const sim::Vector3& point : colliders.bodies().bodies()[b].points) {
      elements.on_bodies.push_back({b, vec(point)});
      elements.points.push_back(static_cast<sim::Index>(elements.vertex_count++));
    }
  }
  for (sim::Index v = 0; v < elements.vertex_count; ++v) elements.fixed.push_back(colliders.can_move(v) ? 0 : 1);
  if (!simulation.has_separations()) return elements;
  for (const sim::Index v : elements.points)
    elements.radii.points.push_back(colliders.radius_of(MeshElement::vertex, v));
  for (sim::Index e = 0; e < elements.edges.size(); ++e) {
    elements.radii.edges.push_back(colliders.radius_of(MeshElement::edge, e));
  }
  for (sim::Index f = 0; f < elements.faces.size(); ++f) {
    elements.radii.faces.push_back(colliders.radius_of(MeshElement::face, f));
  }
  colliders.neighbours().for_each([&](sim::Index a, sim::Index b) { elements.radii.near.push_back({a, b}); });
  return elements;
}

/// The positions of the scene's particles in these coordinates, and the poses of bodies.
proofs::MotionFrame motion_frame(const sim::Simulation& simulation, const sim::VectorX& q,
                                 const sim::BodyStates& bodies) {
  proofs::MotionFrame frame(simulation.scene().particles.size());
  for (sim::Index p = 0; p < frame.size(); ++p) frame[p] = sim::corner_of(q, p);
  for (const sim::BodyState& body : bodies) frame.poses.push_back({body.pose.q, vec(body.pose.p)});
  return frame;
}

/// A file that cannot be written does not keep the others from being written.
class Attempts {
 public:
  template <class Do>
  void attempt(Do&& act) {
    try {
      act();
    } catch (const Error&) {
      if (!first_) first_ = std::current_exception();
    }
  }
  /// A file that could be written only in part is removed.
  template <class File, class Do>
  void with(std::optional<File>& file, Do&& act) {
    attempt([&] {
      if (!file) return;
      try {
        act(*file);
      } catch (const Interrupted&) {  // no fault of the file
        throw;
      } catch (...) {
        file.reset();
        throw;
      }
    });
  }
  /// Throws the first failure, after all attempts.
  void end() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::exception_ptr first_;
};

}  // namespace

SimulateOutput::SimulateOutput(const SimulateOptions& options, sim::Simulation& simulation)
    : options_(&options), simulation_(&simulation) {
  // Files that cannot be written are found before the run, not after it.
  const auto open_energies = [&](const std::string& path) {
    energies_.emplace_back(path);
    energies_.back()->write(sim::energy_header(options.follow) + sim::energy_row(simulation, {}, options.follow));
  };
  if (!options.proof.empty()) proof_.emplace(options.proof).write(sim::proof_header(simulation));
  if (!options.energies.empty()) open_energies(options.energies);
  if (!options.checkpoint.empty()) checkpoint_.emplace(options.checkpoint);
  if (!options.html.empty()) {
    page_.emplace(options.html);
    animation_.emplace(simulation);
  }
  if (!options.queries.empty()) {
    folders_.make(options.queries);
    simulation.watch([this](const Query& query, double separation, const Answer& answer) {
      write_query(query, separation, answer);
    });
  }
  if (!options.prove.empty()) {
    motion_.emplace(options.prove, motion_elements(simulation), Separation{}, options.threads);
    const sim::SimulatedBodies* const bodies = simulation.bodies();
    motion_->add(
        motion_frame(simulation, simulation.state().q, bodies == nullptr ? sim::BodyStates() : bodies->state().bodies));
  }
  if (options.out.empty()) return;
  frames_ = fs::path(options.out) / kFrameFolder;
  folders_.make(frames_);
  open_energies((fs::path(options.out) / (std::string(kEnergies) + ".csv")).string());
  frame_index_.emplace((frames_ / kFrameIndex).string());
  picture_.emplace((fs::path(options.out) / (std::string(kEnergies) + ".svg")).string());
  drawn_.add(simulation.state().time, step_values(simulation, {}));
  write_frame();
}

void SimulateOutput::write_query(const Query& query, double separation, const Answer& answer) {
  std::string text;
  auto& file = queries_[{query.kind, separation}];
  if (!file) {
    if (queries_.size() > kMostQueryFiles) {
      throw Error(
          fmt::format("--queries: the scene's pairs of elements have more than {} different separations, and "
                      "each needs a file; fewer different radii would be right",
                      kMostQueryFiles));
    }
    const fs::path folder = fs::path(options_->queries) / name_of(query.kind);
    folders_.make(folder);
    file.emplace((folder / candidates_name(separation)).string());
    if (separation > 0) text += io::separation_comment({separation, Metric::euclidean});
  }
  io::append_query(text, query, answer.contact);
  Attempts attempts;
  attempts.with(file, [&](io::OutputFile& open) { open.write(text); });
  attempts.end();
}

void SimulateOutput::write_frame() {
  const std::string name = frame_name(simulation_->steps());
  io::write_whole((frames_ / name).string(), sim::vtk_frame(*simulation_));
  written_.push_back({name, simulation_->state().time});
  since_frame_ = 0;
}

void SimulateOutput::step(const std::vector<sim::SubstepRecord>& records) {
  ++steps_;
  Attempts attempts;
  attempts.with(proof_, [&](io::OutputFile& file) {
    for (const auto& record : records) file.write(sim::proof_row(*simulation_, record));
  });
  for (auto& energies : energies_) {
    attempts.with(energies,
                  [&](io::OutputFile& file) { file.write(sim::energy_row(*simulation_, records, options_->follow)); });
  }
  attempts.attempt([&] {
    if (!options_->out.empty() && ++since_frame_ >= options_->frame_every) write_frame();
  });
  if (animation_) animation_->step(records);
  if (picture_) drawn_.add(simulation_->state().time, step_values(*simulation_, records));
  attempts.with(motion_, [&](MotionProofs& motion) {
    for (const auto& record : records) motion.add(motion_frame(*simulation_, record.end, record.end_bodies));
  });
  attempts.end();
}

void SimulateOutput::finish(const std::string& summary) {
  Attempts attempts;
  const auto commit = [](io::OutputFile& file) { file.commit(); };
  attempts.with(checkpoint_, [&](io::OutputFile& file) {
    file.write(sim::checkpoint_to_json(*simulation_));
    file.commit();
  });
  attempts.with(proof_, commit);
  for (auto& file : energies_) attempts.with(file, commit);
  attempts.with(picture_, [&](io::OutputFile& file) {
    file.write(drawn_.svg());
    file.commit();
  });
  for (auto& [question, file] : queries_) attempts.with(file, commit);
  attempts.with(motion_, [&](MotionProofs& motion) {
    if (!motion.has_steps()) throw Error("--prove: no step was made, so there is nothing to prove");
    motion.commit();
  });
  attempts.with(page_, [&](io::OutputFile& file) {
    const std::string name = options_->resume.empty() ? options_->scene : options_->resume;
    page_size_ = animation_->write(file, "simulation " + name, summary);
    file.commit();
  });
  attempts.with(frame_index_, [&](io::OutputFile& file) {
    file.write(sim::vtk_series(written_));
    file.commit();
  });
  folders_.keep();
  attempts.end();
}

void SimulateOutput::finish_early() {
  Attempts attempts;
  attempts.attempt([&] {
    if (frame_index_ && since_frame_ > 0) write_frame();
  });
  attempts.attempt([&] { finish(fmt::format("The run ended early, after step {}.\n", simulation_->steps())); });
  attempts.end();
}

std::string SimulateOutput::proofs_summary() const {
  if (!motion_) return {};
  std::string text = motion_->summary();
  if (simulation_->has_separations()) {
    text += "the proofs are about the distances that radii ask for\n";
  }
  return text;
}

std::string SimulateOutput::page_summary() const {
  if (page_size_ == 0) return {};
  return animation_summary(options_->html, page_size_);
}

}  // namespace touchstone::cli

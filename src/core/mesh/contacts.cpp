// SPDX-License-Identifier: MIT
#include "mesh/contacts.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <tuple>

#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "mesh/candidates.hpp"
#include "mesh/earliest.hpp"
#include "mesh/intersections.hpp"
#include "mesh/narrow.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "solver/validate.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

/// The whole answers for pairs, in ascending order. They are asked about again, over the whole range of times: an
/// answer that was found by a shorter one may have other last bits in its weights, and the range depends on the
/// threads.
std::vector<MeshContact> with_answers(const Mesh::Impl& mesh, const Motion& motion, std::vector<Found<MeshPair>>& found,
                                      const ContactSearch& search) {
  std::sort(found.begin(), found.end());
  std::vector<MeshContact> contacts(found.size());
  threads::for_each_range(found.size(), kContactsAtATime, search.threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      check_stop(search.stop);
      const Separation separation{found[i].distance, mesh.separation.metric};
      const Query query = query_of(motion, found[i].pair.kind, corners_of(mesh, found[i].pair));
      contacts[i] = {found[i].pair, separation, solve(query, {.t_max = search.t_max, .separation = separation})};
    }
  });
  return contacts;
}

/// Hands out the pairs that may come nearer than they are to keep.
void for_each_near_block(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search,
                         const std::atomic<double>* until, const CandidateConsumer& take) {
  const broad_phase::PairSearch pairs{search.threads, until};
  if (search.candidates != nullptr) {
    search.candidates->for_each_block(motion, search.kept_fraction, pairs, search.stop, take);
  } else {
    for_each_candidate_block(mesh, motion, reach_of(mesh, motion, search.kept_fraction, broad_phase::until(pairs)),
                             pairs, take);
  }
}

/// Tells of all contacts that may be the earliest, and of those at the start.
void find_earliest(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search,
                   Earliest<MeshPair>& earliest) {
  const KeptDistances distances(mesh, motion, search.kept_fraction);
  const ContactConsumer tell = [&](const MeshPair& pair, double distance, const Answer& answer) {
    earliest.tell(pair, distance, answer);
  };
  for_each_near_block(mesh, motion, search, &earliest.until(),
                      [&](Kind kind, const broad_phase::Pair* pairs, std::size_t count) {
                        check_stop(search.stop);
                        const double t_max = earliest.until().load(std::memory_order_relaxed);
                        for_each_contact(mesh, motion, distances, kind, pairs, count, t_max, Wanted::time, tell);
                      });
}

}  // namespace

double first_time(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search) {
  ContactSearch touching = search;
  touching.kept_fraction = 0;
  touching.candidates = nullptr;
  if (search.candidates != nullptr) search.candidates->count_search();
  Earliest<MeshPair> earliest(search.t_max);
  find_earliest(mesh, motion, touching, earliest);
  return earliest.until();
}

FirstContact find_first(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search) {
  Earliest<MeshPair> earliest(std::min(search.t_max, search.known_by));
  find_earliest(mesh, motion, search, earliest);
  FirstContact result;
  result.contact = !earliest.first().empty();
  result.toi = earliest.toi();
  result.toi_upper = earliest.toi_upper();
  result.earliest = with_answers(mesh, motion, earliest.first(), search);
  keep_exactly_first(result.earliest, search.threads, [&](const MeshContact& contact) {
    const Query query = query_of(motion, contact.pair.kind, corners_of(mesh, contact.pair));
    return contact_times(query, contact.separation, contact.answer.toi_upper).front().first;
  });
  result.at_start = with_answers(mesh, motion, earliest.at_start(), search);
  result.start_checked = search.check_start;
  if (search.check_start) result.start_intersections = find_intersections(mesh, motion, search.threads, search.stop);
  return result;
}

std::vector<MeshContact> find_all(const Mesh::Impl& mesh, const Motion& motion, const ContactSearch& search) {
  const KeptDistances distances(mesh, motion, search.kept_fraction);
  std::mutex lock;
  std::vector<MeshContact> contacts;
  const ContactConsumer tell = [&](const MeshPair& pair, double distance, const Answer& answer) {
    const std::lock_guard<std::mutex> guard(lock);
    contacts.push_back({pair, {distance, mesh.separation.metric}, answer});
  };
  for_each_near_block(mesh, motion, search, nullptr, [&](Kind kind, const broad_phase::Pair* pairs, std::size_t count) {
    check_stop(search.stop);
    for_each_contact(mesh, motion, distances, kind, pairs, count, search.t_max, Wanted::all, tell);
  });
  std::sort(contacts.begin(), contacts.end(), [](const MeshContact& a, const MeshContact& b) {
    return std::tie(a.answer.toi, a.answer.toi_upper, a.pair) < std::tie(b.answer.toi, b.answer.toi_upper, b.pair);
  });
  return contacts;
}

namespace {

TOUCHSTONE_BEHIND_GUARD FirstContact first_of(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                                              const FirstContactOptions& options, StepMemory& memory) {
  set_motion(memory.motion, mesh, x0, x1, options.threads);
  return find_first(mesh, memory.motion,
                    {options.t_max, options.threads, 0, options.stop, options.check_start, memory.candidates()});
}

TOUCHSTONE_BEHIND_GUARD std::vector<MeshContact> all_of(const Mesh::Impl& mesh, const Positions& x0,
                                                        const Positions& x1, const StepOptions& options,
                                                        StepMemory& memory) {
  set_motion(memory.motion, mesh, x0, x1, options.threads);
  return find_all(mesh, memory.motion, {options.t_max, options.threads, 0, options.stop, false, memory.candidates()});
}

}  // namespace

FirstContact first_contact(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                           const FirstContactOptions& options, StepMemory& memory) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_t_max(options.t_max);
  return first_of(mesh, x0, x1, options, memory);
}

std::vector<MeshContact> all_contacts(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1,
                                      const StepOptions& options, StepMemory& memory) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_t_max(options.t_max);
  return all_of(mesh, x0, x1, options, memory);
}

}  // namespace touchstone::mesh

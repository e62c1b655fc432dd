// Bodies for Python: bodies with their rules, and the questions about their motions.
// SPDX-License-Identifier: MIT
#include <touchstone/bodies.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "python/arguments.hpp"
#include "python/curved/curved_queries.hpp"
#include "python/questions.hpp"
#include "python/rigid/body_arguments.hpp"
#include "python/rigid/define_bodies.hpp"
#include "python/rigid/rigid_members.hpp"
#include "rigid/body_data.hpp"
#include "rigid/body_search.hpp"

namespace touchstone::python {
namespace {

constexpr char kBodiesHelp[] = R"(Rigid bodies that move and turn, and the pairs of them that are asked about.

Bodies(bodies, *, separation=0.0, metric='euclidean', ignore=(), groups=None, group_pairs=None,
       only_listed_groups=False)

bodies        a list of k Body objects; one object may be there several times
separation    contact is to be within this of each other, in the unit of the points; with 0, to touch. Radii come on top
metric        'euclidean' or 'max'
ignore        (m, 2): pairs of bodies that never collide, by their numbers from 0
groups        k whole numbers: the group of each body
group_pairs   (m, 2): the pairs of groups that never collide, or with only_listed_groups the only ones that do

The methods are the questions:

first_contact(start, end, *, quaternion, turn='shorter', t_max=1.0, threads=1, check_start=True)
    FirstBodyContact: the first contact. check_start=True asks also where bodies intersect at the start
all_contacts(start, end, *, quaternion, turn='shorter', t_max=1.0, threads=1)
    BodyPairs: every pair that comes into contact, those in contact at the start too, by time and then by pair
candidates(start, end, *, quaternion, turn='shorter', threads=1)
    BodyPairs without answers: every pair in contact is among them
free_step(start, end, *, quaternion, turn='shorter', threads=1, check_start=True)
    FreeBodyStep: a long step that is proved free of contact, to poses rounded as they are returned
solve_screw(start, end, *, quaternion, turn='shorter', inner=None, t_max=1.0, threads=1, check_start=True, arcs=8,
            most_arcs=256)
    BodyScrewAnswer: of bodies that turn at constant rates between their poses, as slerp has it: they are free, or meet
    in a range of times, or come so near that a bound leaves it open. arcs and most_arcs, powers of two, are into how
    many arcs a step is cut first and at most: more of them leave less open. inner has the control points between both
    positions, of shape (k, m, 3) or (n, k, m, 3): with m = 1 or 2 the origins are on Bezier curves of degree 2 or 3
contact_normal(contacts, start, end, *, quaternion, turn='shorter', t_max=1.0, threads=1)
    (m, 3) float64: the unit normal of each of the BodyPairs at its first contact in one motion, from the first element
    to the second, as touchstone.contact_normal; NaN where there is none
intersections(poses, *, quaternion, threads=1)
    BodyIntersections: where bodies intersect at rest, exactly; separation and radii do not count
distance(poses, *, quaternion, threads=1)
    BodyDistance: the least distance of two bodies at rest and the pairs that have it, exactly, in the bodies' metric;
    separation and radii do not count

start, end    the poses at t = 0 and t = 1, of shape (k, 7): x, y, z of the body's origin, then the quaternion, of any
              length but 0. (n, k, 7) is n motions of the same bodies, and the result is a list of n results; the other
              argument may be (k, 7) then, and counts for all
quaternion    'wxyz' or 'xyzw': the order of the components. It has no default, because both orders are common, and the
              wrong one gives other orientations without an error
turn          'shorter': where q0 . q1 < 0, as recorded poses often have it by chance, the body takes the shorter turn
              to the same orientation, by -q1; `turned` of the results has these bodies. 'as-given': it takes the longer
threads       1 (default) to 1024, or 0 for as many as the machine has; it changes nothing in the result

Over the step the quaternion is (1 - t) q0 + t q1, and the position (1 - t) p0 + t p1: both ends are met exactly. Every
pair of elements of two bodies has the exact answer; nothing is sampled. The motion of solve_screw is another one, and
its answer is proved, but not exact. Raises TypeError for an argument of another type. Raises ValueError for shapes that
do not fit, numbers that are not finite, a quaternion that is zero at an end or between them, and rules without meaning;
the message names the body, and of many motions the motion.

A rod makes a quarter turn about z, and its tip meets a ball:

>>> import touchstone
>>> rod = touchstone.Body([[0, 0, 0], [2, 0, 0]], edges=[[0, 1]])
>>> ball = touchstone.Body([[0, 0, 0]], radii=[0.5])
>>> bodies = touchstone.Bodies([rod, ball])
>>> start = [[0, 0, 0, 1, 0, 0, 0], [0, 2, 0, 1, 0, 0, 0]]
>>> end = [[0, 0, 0, 1, 0, 0, 1], [0, 2, 0, 1, 0, 0, 0]]
>>> found = bodies.first_contact(start, end, quaternion='wxyz')
>>> found
<FirstBodyContact: toi 0.7745966692414833, 1 earliest, 0 at the start>
>>> bodies.describe(found.earliest[0])
'vertex 0 of body 1 and edge 0 (0-1) of body 0')";

Bodies bodies_of(const py::iterable& list, py::handle separation, py::handle metric, py::handle ignore,
                 py::handle groups, py::handle group_pairs, bool only_listed_groups) {
  Bodies bodies;
  for (const py::handle body : list) {
    if (!py::isinstance<Body>(body)) {
      throw py::type_error("bodies[" + std::to_string(bodies.bodies.size()) + "] is of type " +
                           Py_TYPE(body.ptr())->tp_name + "; it must be a touchstone.Body");
    }
    bodies.bodies.push_back(body.cast<const Body&>());
  }
  bodies.separation = {number_of(separation, "separation"), metric_of(metric)};
  bodies.rules.body_pairs = index_rows<2>(ignore, "ignore");
  bodies.rules.groups = indices(groups, "groups");
  bodies.rules.group_pairs = index_rows<2>(group_pairs, "group_pairs");
  if (only_listed_groups) bodies.rules.group_rule = GroupRule::only_listed;
  return bodies;
}

/// Whether two bodies with elements may collide.
bool may_any_collide(const Bodies& bodies, const rigid::CollidingBodies& colliding) {
  for (BodyIndex b = 1; b < bodies.bodies.size(); ++b) {
    if (bodies.bodies[b].impl().tree.empty()) continue;
    for (BodyIndex a = 0; a < b; ++a) {
      if (!bodies.bodies[a].impl().tree.empty() && colliding.may_collide(a, b)) return true;
    }
  }
  return false;
}

BodiesRecord record_of_all(const Bodies& bodies) {
  BodiesRecord record;
  std::vector<const Body::Impl*> written;
  for (const Body& body : bodies.bodies) {
    const auto found = std::find(written.begin(), written.end(), &body.impl());
    record.which.push_back(static_cast<std::uint32_t>(found - written.begin()));
    if (found != written.end()) continue;
    written.push_back(&body.impl());
    record.bodies.push_back(record_of(body));
  }
  record.rules = bodies.rules;
  record.separation = bodies.separation;
  return record;
}

Bodies bodies_of_record(BodiesRecord&& record) {
  std::vector<Body> made;
  for (BodyRecord& one : record.bodies) made.push_back(body_of(std::move(one)));
  Bodies bodies;
  for (const std::uint32_t i : record.which) {
    if (i >= made.size()) throw py::value_error("the pickle is damaged");
    bodies.bodies.push_back(made[i]);
  }
  bodies.rules = std::move(record.rules);
  bodies.separation = record.separation;
  return bodies;
}

/// A pair as Python gives it: (kind, (body, first), (body, second)).
BodyPair body_pair_of(const py::object& given) {
  using Number = std::pair<BodyIndex, MeshIndex>;
  try {
    const auto [kind, first, second] = given.cast<std::tuple<py::object, Number, Number>>();
    return {kind_of(kind), {first.first, first.second}, {second.first, second.second}};
  } catch (const py::cast_error&) {
    throw py::value_error("a pair is a tuple (kind, (body, first), (body, second)), not " +
                          std::string(py::str(py::repr(given))));
  }
}

int arcs_of(py::handle number, const char* name) {
  try {
    return number.cast<int>();
  } catch (const py::cast_error&) {
    throw py::type_error(std::string(name) + " is " + std::string(py::str(py::repr(number))) +
                         "; it must be a whole number, a power of two");
  }
}

BodyStepOptions step_options(const MeshOptions& with, double t_max, bool check_start) {
  BodyStepOptions options;
  static_cast<MeshOptions&>(options) = with;
  options.t_max = t_max;
  options.check_start = check_start;
  return options;
}

FoundBodyContact found_of(FirstBodyContact&& found, const AskedMotions& motions, double t_max) {
  return {std::move(found), motions.turned, t_max};
}

py::object contact_normals(const Bodies& self, const BodyPairs& contacts, py::handle start, py::handle end,
                           py::handle order, py::handle turn, py::handle t_max, py::handle threads) {
  const BodySteps steps(self, start, end, order_of(order), turn_of(turn));
  if (!steps.is_single()) throw py::value_error("there are many motions; the normals are those of one");
  CurvedQueries queries;
  py::array_t<double> separations(static_cast<py::ssize_t>(contacts.pairs.size()));
  double* to = separations.mutable_data();
  for (const BodyPair& pair : contacts.pairs) {
    const Separation separation = separation_of(self, pair);
    if (separation.metric != Metric::euclidean && separation.distance > 0) {
      throw py::value_error("the bodies' metric is 'max'; with a separation above 0 a normal needs 'euclidean'");
    }
    *to++ = separation.distance;
    queries.all.push_back(query_of(self, pair, steps.first().motions));
  }
  return contact_normals_of(queries, t_max, separations, threads);
}

void define_questions(py::class_<Bodies>& bound) {
  const auto start = py::arg("start"), end = py::arg("end");
  const auto quaternion = py::arg("quaternion") = py::none();
  const auto turn = py::arg("turn") = "shorter";
  const auto t_max = py::arg("t_max") = 1.0;
  const auto threads = py::arg("threads") = 1;
  const auto check_start = py::arg("check_start") = true;
  bound
      .def(
          "first_contact",
          [](const Bodies& self, py::handle x0, py::handle x1, py::handle order, py::handle which, py::handle until,
             py::handle thread_count, bool check) {
            const BodySteps steps(self, x0, x1, order_of(order), turn_of(which));
            const double last = number_of(until, "t_max");
            return steps.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              return found_of(first_contact(self, one.motions, step_options(options, last, check)), one, last);
            });
          },
          start, end, py::kw_only(), quaternion, turn, t_max, threads, check_start,
          "The first contact of the bodies in a step: a FirstBodyContact. See Bodies.")
      .def(
          "all_contacts",
          [](const Bodies& self, py::handle x0, py::handle x1, py::handle order, py::handle which, py::handle until,
             py::handle thread_count) {
            const BodySteps steps(self, x0, x1, order_of(order), turn_of(which));
            const double last = number_of(until, "t_max");
            const std::size_t excluded = rigid::CollidingBodies(self).excluded();
            return steps.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              return pairs_of(all_contacts(self, one.motions, step_options(options, last, false)),
                              {excluded, one.turned});
            });
          },
          start, end, py::kw_only(), quaternion, turn, t_max, threads,
          "Every pair that comes into contact in [0, t_max]: BodyPairs. See Bodies.")
      .def(
          "candidates",
          [](const Bodies& self, py::handle x0, py::handle x1, py::handle order, py::handle which,
             py::handle thread_count) {
            const BodySteps steps(self, x0, x1, order_of(order), turn_of(which));
            const std::size_t excluded = rigid::CollidingBodies(self).excluded();
            return steps.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              return BodyPairs{candidates(self, one.motions, options), {}, {}, {excluded, one.turned}};
            });
          },
          start, end, py::kw_only(), quaternion, turn, threads,
          "Pairs of which every pair in contact is one: BodyPairs without answers. See Bodies.")
      .def(
          "free_step",
          [](const Bodies& self, py::handle x0, py::handle x1, py::handle order_name, py::handle which,
             py::handle thread_count, bool check) {
            const QuaternionOrder order = order_of(order_name);
            const BodySteps steps(self, x0, x1, order, turn_of(which));
            return steps.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              FreeBodyStep step = free_step(self, one.motions, step_options(options, 1, check));
              FoundBodyStep found{
                  step.outcome, step.length, {}, found_of(std::move(step.first_contact), one, 1), step.proofs};
              for (const Pose& pose : step.poses) found.poses.push_back(pose_numbers(pose, order));
              return found;
            });
          },
          start, end, py::kw_only(), quaternion, turn, threads, check_start,
          "A long step that is proved free of contact: a FreeBodyStep. See Bodies.")
      .def(
          "solve_screw",
          [](const Bodies& self, py::handle x0, py::handle x1, py::handle order, py::handle which, py::handle inner,
             py::handle until, py::handle thread_count, bool check, py::handle arcs, py::handle most_arcs) {
            const BodySteps steps(self, x0, x1, order_of(order), turn_of(which), inner);
            BodyScrewOptions how;
            how.t_max = number_of(until, "t_max");
            how.check_start = check;
            how.arcs = arcs_of(arcs, "arcs");
            how.most_arcs = arcs_of(most_arcs, "most_arcs");
            return steps.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              BodyScrewOptions with = how;
              static_cast<MeshOptions&>(with) = options;
              return FoundBodyScrew{solve_screw(self, one.motions, with), one.turned, how.t_max};
            });
          },
          start, end, py::kw_only(), quaternion, turn, py::arg("inner") = py::none(), t_max, threads, check_start,
          py::arg("arcs") = 8, py::arg("most_arcs") = 256,
          "Whether bodies that turn at constant rates come into contact: a BodyScrewAnswer. See Bodies.")
      .def("contact_normal", &contact_normals, py::arg("contacts"), start, end, py::kw_only(), quaternion, turn, t_max,
           threads, "The unit normals of contacts, from the first element to the second. See Bodies.")
      .def(
          "intersections",
          [](const Bodies& self, py::handle x, py::handle order, py::handle thread_count) {
            const BodySteps rest(self, x, order_of(order));
            return rest.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              BodyIntersections found;
              found.all = intersections(self, rigid::starts_of(one.motions), options, &found.left_out);
              return found;
            });
          },
          py::arg("poses"), py::kw_only(), quaternion, threads,
          "Where bodies intersect at rest: BodyIntersections. See Bodies.")
      .def(
          "distance",
          [](const Bodies& self, py::handle x, py::handle order, py::handle thread_count) {
            const BodySteps rest(self, x, order_of(order));
            return rest.each(thread_count, [&](const AskedMotions& one, const MeshOptions& options) {
              return FoundBodyDistance{distance(self, rigid::starts_of(one.motions), options)};
            });
          },
          py::arg("poses"), py::kw_only(), quaternion, threads,
          "The least distance of two bodies at rest: a BodyDistance. See Bodies.");
}

}  // namespace

void define_bodies(py::module_& module) {
  define_rigid_results(module);
  define_body(module);
  py::class_<Bodies> bound = define_class<Bodies>(module, "Bodies", kBodiesHelp);
  define_pickle(bound, &record_of_all, &bodies_of_record);
  bound
      .def(py::init([](const py::iterable& list, const py::object& separation, const py::object& metric,
                       const py::object& ignore, const py::object& groups, const py::object& group_pairs,
                       bool only_listed_groups) {
             Bodies bodies = bodies_of(list, separation, metric, ignore, groups, group_pairs, only_listed_groups);
             const rigid::CollidingBodies colliding(bodies);
             if (!may_any_collide(bodies, colliding) &&
                 PyErr_WarnEx(PyExc_UserWarning,
                              "no two of these bodies may collide, so no question about them asks anything", 1) != 0) {
               throw py::error_already_set();
             }
             return bodies;
           }),
           py::arg("bodies"), py::kw_only(), py::arg("separation") = 0.0, py::arg("metric") = "euclidean",
           py::arg("ignore") = py::tuple(), py::arg("groups") = py::none(), py::arg("group_pairs") = py::none(),
           py::arg("only_listed_groups") = false)
      .def("__len__", [](const Bodies& self) { return self.bodies.size(); })
      .def_property_readonly(
          "bodies",
          [](const Bodies& self) {
            py::list list;
            for (const Body& body : self.bodies) list.append(body);
            return list;
          },
          "a list of the Body objects")
      .def_property_readonly(
          "separation", [](const Bodies& self) { return self.separation.distance; }, "the distance of contact")
      .def_property_readonly(
          "metric", [](const Bodies& self) { return std::string(name_of(self.separation.metric)); },
          "'euclidean' or 'max'")
      .def(
          "separation_of",
          [](const Bodies& self, const py::object& pair) { return separation_of(self, body_pair_of(pair)).distance; },
          py::arg("pair"), "The separation of a pair (kind, (body, first), (body, second)), with the radii.")
      .def(
          "describe", [](const Bodies& self, const py::object& pair) { return describe(self, body_pair_of(pair)); },
          py::arg("pair"), "A pair for a person: 'edge 7 (3-4) of body 0 and edge 9 (10-11) of body 2'.")
      .def("__repr__", [](const Bodies& self) {
        const std::size_t excluded = rigid::CollidingBodies(self).excluded();
        return "<Bodies: " + std::to_string(self.bodies.size()) +
               (excluded > 0 ? ", " + std::to_string(excluded) + " pairs left out>" : ">");
      });
  define_questions(bound);
}

}  // namespace touchstone::python

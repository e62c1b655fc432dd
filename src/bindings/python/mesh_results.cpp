// SPDX-License-Identifier: MIT
#include "python/mesh_results.hpp"

#include <algorithm>
#include <string>

#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/items.hpp"
#include "python/pickles.hpp"

namespace touchstone::python {
namespace {

py::tuple tuple_of(const MeshPair& pair) {
  return py::make_tuple(std::string(name_of(pair.kind)), pair.first, pair.second);
}

void define_pairs(py::module_& module) {
  py::class_<Pairs> pairs = define_class<Pairs>(
      module, "Pairs", "Pairs of elements: arrays that cannot be written to. pairs[i] is (kind, first, second).");
  define_pickle(pairs);
  const auto items = [](const Pairs& self) -> const std::vector<MeshPair>& { return self.pairs; };
  define_items(
      pairs, "pair", items, [](const MeshPair& pair) { return tuple_of(pair); },
      [](const Pairs& self, const std::vector<std::size_t>& chosen) {
        return Pairs{items_at(self.pairs, chosen), items_at(self.separations, chosen), items_at(self.answers, chosen)};
      });
  pairs.def("__repr__", [](const Pairs& self) { return "<Pairs: " + std::to_string(self.pairs.size()) + ">"; })
      .def_property_readonly(
          "kind",
          [](const Pairs& self) {
            py::list kinds;
            for (const MeshPair& pair : self.pairs) kinds.append(py::str(std::string(name_of(pair.kind))));
            return kinds;
          },
          "a list of the kinds: 'edge-edge', 'vertex-face', 'point-edge' or 'point-point'")
      .def_property_readonly(
          "first",
          [](const py::object& self) {
            const auto& all = self.cast<const Pairs&>().pairs;
            return column_of<MeshIndex>(all, all.empty() ? nullptr : &all[0].first, self);
          },
          "(n,) uint32: the numbers of the first elements, edges or vertices")
      .def_property_readonly(
          "second",
          [](const py::object& self) {
            const auto& all = self.cast<const Pairs&>().pairs;
            return column_of<MeshIndex>(all, all.empty() ? nullptr : &all[0].second, self);
          },
          "(n,) uint32: the numbers of the second elements, edges, faces or vertices")
      .def_property_readonly(
          "separation",
          [](const py::object& self) {
            const auto& all = self.cast<const Pairs&>().separations;
            return column_of<double>(all, all.data(), self);
          },
          "of contacts: (n,) float64, the separations that they are about")
      .def_property_readonly(
          "answers", [](const Pairs& self) { return Answers(self.answers); },
          "of contacts: the Answers to the pairs' queries");
}

void define_intersections(py::module_& module) {
  py::class_<Intersections> found =
      define_class<Intersections>(module, "Intersections",
                                  "Where a mesh intersects itself: arrays that cannot be written to. found[i] "
                                  "is\n(first_element, first, second_element, second, sort).");
  define_pickle(found);
  define_items(
      found, "intersection", [](const Intersections& self) -> const std::vector<Intersection>& { return self.all; },
      [](const Intersection& one) {
        return py::make_tuple(std::string(name_of(one.first_element)), one.first,
                              std::string(name_of(one.second_element)), one.second, std::string(name_of(one.sort)));
      },
      [](const Intersections& self, const std::vector<std::size_t>& chosen) {
        return Intersections{items_at(self.all, chosen)};
      });
  found.def("__repr__",
            [](const Intersections& self) { return "<Intersections: " + std::to_string(self.all.size()) + ">"; });
  const auto names = [&](const char* name, auto member, const char* help) {
    const auto get = [member](const Intersections& self) {
      py::list elements;
      for (const Intersection& one : self.all) elements.append(std::string(name_of(one.*member)));
      return elements;
    };
    found.def_property_readonly(name, get, help);
  };
  names("first_element", &Intersection::first_element, "a list of 'edge' or 'vertex'");
  names("second_element", &Intersection::second_element, "a list of 'face', 'edge' or 'vertex'");
  const auto column = [&](const char* name, auto member, auto number, std::size_t width, const char* help) {
    const auto get = [member, number, width](const py::object& self) {
      static_cast<void>(number);
      const auto& all = self.cast<const Intersections&>().all;
      return column_of<decltype(number)>(all, all.empty() ? nullptr : &(all[0].*member), self, width);
    };
    found.def_property_readonly(name, get, help);
  };
  column("first", &Intersection::first, MeshIndex(), 0, "(n,) uint32: the numbers of the first elements");
  column("second", &Intersection::second, MeshIndex(), 0, "(n,) uint32: the numbers of the second elements");
  found.def_property_readonly(
      "sort",
      [](const Intersections& self) {
        py::list sorts;
        for (const Intersection& one : self.all) sorts.append(std::string(name_of(one.sort)));
        return sorts;
      },
      "a list of 'touches', 'pierces', 'folds' or 'inside'");
  found.def_property_readonly(
      "pierces",
      [](const Intersections& self) {
        py::array_t<bool> pierces(static_cast<py::ssize_t>(self.all.size()));
        bool* next = pierces.mutable_data();
        for (const Intersection& one : self.all) *next++ = one.sort == IntersectionSort::pierces;
        py::detail::array_proxy(pierces.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
        return pierces;
      },
      "(n,) bool: whether the edge passes through");
  column("weights_first", &Intersection::weights_first, double(), 3,
         "(n, 3) float64: a common point, as barycentric coordinates on the first element");
  column("weights_second", &Intersection::weights_second, double(), 3, "(n, 3) float64: on the second element");
}

void define_first_contact(py::module_& module) {
  py::class_<FirstContact> bound =
      define_class<FirstContact>(module, "FirstContact", "The first contact of a mesh in a step.");
  define_pickle(bound);
  bound
      .def_readonly("contact", &FirstContact::contact,
                    "whether elements that are not in contact at the start come into contact")
      .def_readonly("toi", &FirstContact::toi, "the largest double <= the exact first time of it; inf without one")
      .def_readonly("toi_upper", &FirstContact::toi_upper, "the smallest double >= it")
      .def_property_readonly("free", &FirstContact::free,
                             "whether there is no contact at all in the step, and no intersection at the start, if "
                             "start_checked")
      .def_readonly("start_checked", &FirstContact::start_checked,
                    "whether the start was asked about, by check_start=True")
      .def_property_readonly(
          "start_intersections", [](const FirstContact& self) { return Intersections{self.start_intersections}; },
          "Intersections: where the mesh intersects itself at the start; empty when that was not asked")
      .def_property_readonly(
          "earliest", [](const FirstContact& self) { return pairs_of(self.earliest); },
          "Pairs: every pair whose contact begins at exactly that time")
      .def_property_readonly(
          "at_start", [](const FirstContact& self) { return pairs_of(self.at_start); },
          "Pairs: every pair in contact at t = 0")
      .def("__repr__", [](const FirstContact& self) {
        if (self.free()) {
          return std::string(self.start_checked ? "<FirstContact: free>" : "<FirstContact: free, start not checked>");
        }
        if (!self.start_intersections.empty()) {
          return "<FirstContact: " + std::to_string(self.start_intersections.size()) + " intersections at the start>";
        }
        return "<FirstContact: toi " + std::string(py::repr(py::float_(self.toi))) + ", " +
               std::to_string(self.earliest.size()) + " earliest, " + std::to_string(self.at_start.size()) +
               " at the start>";
      });
}

void define_closest_approach(py::module_& module) {
  py::class_<ClosestApproach> bound =
      define_class<ClosestApproach>(module, "ClosestApproach", "How near the elements of a mesh come to each other.");
  define_pickle(bound);
  bound
      .def_readonly("distance", &ClosestApproach::distance,
                    "the least distance, rounded up; inf where no two elements may collide")
      .def_readonly("first_contact", &ClosestApproach::first_contact,
                    "FirstContact: that with this distance as the separation: when and where they are so near first")
      .def("__repr__", [](const ClosestApproach& self) {
        return "<ClosestApproach: distance " + std::string(py::repr(py::float_(self.distance))) + ">";
      });
}

void define_free_step(py::module_& module) {
  py::class_<Step> bound = define_class<Step>(module, "FreeStep", "A step that is proved free of contact.");
  define_pickle(bound);
  bound
      .def_property_readonly(
          "outcome", [](const Step& self) { return outcome_text(self.step.outcome); },
          "'whole', 'shortened', 'no_room', 'contact_at_start' or 'intersects_at_start'")
      .def_property_readonly(
          "length", [](const Step& self) { return self.step.length; }, "the fraction of the step, in [0, 1]")
      .def_property_readonly(
          "positions",
          [](const py::object& self) {
            const Step& step = self.cast<const Step&>();
            const auto& all = step.step.positions;
            return py::array(py::dtype::of<double>(),
                             {static_cast<py::ssize_t>(all.size()) / step.dimension, py::ssize_t{step.dimension}}, {},
                             all.data(), self);
          },
          "(n, dimension) float64: the end; the path to it, rounded as it is, is free")
      .def_property_readonly(
          "first_contact", [](const Step& self) { return self.step.first_contact; },
          "FirstContact: that of the whole step, about the distances to keep")
      .def_property_readonly(
          "proofs", [](const Step& self) { return self.step.proofs; },
          "the number of times that all pairs were asked about")
      .def("__repr__", [](const Step& self) {
        return std::string("<FreeStep: ") + outcome_text(self.step.outcome) + ", length " +
               std::string(py::repr(py::float_(self.step.length))) +
               (self.step.first_contact.start_checked ? ">" : ", start not checked>");
      });
}

}  // namespace

std::string outcome_text(StepOutcome outcome) {
  std::string name(name_of(outcome));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Pairs pairs_of(const std::vector<MeshContact>& contacts) {
  Pairs all;
  for (const MeshContact& contact : contacts) {
    all.pairs.push_back(contact.pair);
    all.separations.push_back(contact.separation.distance);
    all.answers.push_back(contact.answer);
  }
  return all;
}

void define_mesh_results(py::module_& module) {
  define_pairs(module);
  define_intersections(module);
  define_first_contact(module);
  define_closest_approach(module);
  define_free_step(module);
}

}  // namespace touchstone::python

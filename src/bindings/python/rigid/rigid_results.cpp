// SPDX-License-Identifier: MIT
#include "python/rigid/rigid_results.hpp"

#include <string>
#include <utility>

#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/items.hpp"
#include "python/mesh_results.hpp"
#include "python/rigid/rigid_members.hpp"

namespace touchstone::python {
namespace {

py::tuple tuple_of(const BodyElement& one) { return py::make_tuple(one.body, one.element); }

/// Attributes of a list of Items, which is a member of Results: words as lists, and whole numbers as arrays.
template <class Results, class Item>
class ResultColumns {
 public:
  ResultColumns(py::class_<Results>& bound, std::vector<Item> Results::*all) : bound_(bound), all_(all) {}

  template <class Member>
  void words(const char* name, Member Item::*member, const char* help) {
    const auto get = [all = all_, member](const Results& self) {
      py::list list;
      for (const Item& item : self.*all) list.append(py::str(std::string(name_of(item.*member))));
      return list;
    };
    bound_.def_property_readonly(name, get, help);
  }

  /// The body and the number of an element.
  void elements(const char* body, const char* number, BodyElement Item::*element, const char* which) {
    const auto add = [&](const char* name, MeshIndex BodyElement::*field, const std::string& help) {
      const auto get = [all = all_, element, field](const py::object& self) {
        const std::vector<Item>& items = self.cast<const Results&>().*all;
        return column_of<MeshIndex>(items, items.empty() ? nullptr : &(items[0].*element.*field), self);
      };
      bound_.def_property_readonly(name, get, help.c_str());
    };
    add(body, &BodyElement::body, std::string("(n,) uint32: the bodies of the ") + which + " elements");
    add(number, &BodyElement::element,
        std::string("(n,) uint32: the numbers of the ") + which + " elements in their bodies' meshes");
  }

 private:
  py::class_<Results>& bound_;
  std::vector<Item> Results::*all_;
};

/// "; 3 pairs of bodies left out", or nothing where there are none.
std::string count_text(std::size_t count, const char* one, const char* many) {
  return count == 0 ? "" : "; " + std::to_string(count) + " " + (count == 1 ? one : many);
}
std::string excluded_text(std::size_t excluded) {
  return count_text(excluded, "pair of bodies left out", "pairs of bodies left out");
}
/// What was not asked: "; 1 pair of bodies left out".
std::string left_out_text(const BodiesLeftOut& found) {
  return excluded_text(found.excluded) +
         count_text(found.in_open, "piece in the box of open surfaces", "pieces in the box of open surfaces") +
         count_text(found.cancelled, "piece in a cavity", "pieces in a cavity");
}
std::string turned_text(std::size_t turned) {
  return count_text(turned, "body takes the shorter turn", "bodies take the shorter turn");
}

/// Defines what nobody can tell to be inside or outside. @param of  the BodiesLeftOut of results
template <class Results, class Of>
void define_unclear(py::class_<Results>& bound, const Of& of) {
  bound
      .def_property_readonly(
          "in_open", [of](const Results& self) { return of(self).in_open; },
          "how many pieces of bodies are in the box around another body's open surfaces, which have no inside")
      .def_property_readonly(
          "cancelled", [of](const Results& self) { return of(self).cancelled; },
          "how many pieces are in closed surfaces of opposite orientation, as in a cavity");
}

/// The same, and what the rules left out.
template <class Results, class Of>
void define_left_out_at_rest(py::class_<Results>& bound, const Of& of) {
  define_unclear(bound, of);
  bound.def_property_readonly(
      "excluded", [of](const Results& self) { return of(self).excluded; },
      "how many pairs of bodies the rules left out");
}

/// Defines what a question about bodies leaves out, and what it changed before.
template <class Results, class Excluded, class Turned>
void define_left_out(py::class_<Results>& bound, const Excluded& excluded, const Turned& turned) {
  bound.def_property_readonly("excluded", excluded, "how many pairs of bodies the rules left out")
      .def_property_readonly(
          "turned",
          [turned](const py::object& self) {
            const std::vector<BodyIndex>& all = turned(self.cast<const Results&>());
            return column_of<BodyIndex>(all, all.data(), self);
          },
          "(m,) uint32: the bodies that took the shorter turn in place of the longer one that their quaternions say");
}

void define_body_pairs(py::module_& module) {
  py::class_<BodyPairs> bound = define_class<BodyPairs>(
      module, "BodyPairs",
      "Pairs of elements of two bodies: arrays that cannot be written to. pairs[i] is (kind, (body, first), (body,\n"
      "second)).");
  define_pickle(bound);
  define_items(
      bound, "pair", [](const BodyPairs& self) -> const std::vector<BodyPair>& { return self.pairs; },
      [](const BodyPair& pair) {
        return py::make_tuple(std::string(name_of(pair.kind)), tuple_of(pair.first), tuple_of(pair.second));
      },
      [](const BodyPairs& self, const std::vector<std::size_t>& chosen) {
        return BodyPairs{items_at(self.pairs, chosen), items_at(self.separations, chosen),
                         items_at(self.answers, chosen), self.left_out};
      });
  define_left_out(
      bound, [](const BodyPairs& self) { return self.left_out.excluded; },
      [](const BodyPairs& self) -> const std::vector<BodyIndex>& { return self.left_out.turned; });
  bound
      .def("__repr__",
           [](const BodyPairs& self) {
             const auto& [excluded, turned] = self.left_out;
             return "<BodyPairs: " + std::to_string(self.pairs.size()) + excluded_text(excluded) +
                    turned_text(turned.size()) + ">";
           })
      .def_property_readonly(
          "separation",
          [](const py::object& self) {
            const auto& all = self.cast<const BodyPairs&>().separations;
            return column_of<double>(all, all.data(), self);
          },
          "of contacts: (n,) float64, the separations that they are about, with the radii")
      .def_property_readonly(
          "answers", [](const BodyPairs& self) { return Answers(self.answers); },
          "of contacts: the Answers to the pairs' queries: times, natures, features and weights");
  ResultColumns<BodyPairs, BodyPair> columns(bound, &BodyPairs::pairs);
  columns.words("kind", &BodyPair::kind,
                "a list of the kinds: 'edge-edge', 'vertex-face', 'point-edge' or 'point-point'");
  columns.elements("first_body", "first", &BodyPair::first, "first");
  columns.elements("second_body", "second", &BodyPair::second, "second");
}

void define_body_intersections(py::module_& module) {
  py::class_<BodyIntersections> bound = define_class<BodyIntersections>(
      module, "BodyIntersections",
      "Where bodies intersect at rest: arrays that cannot be written to. found[i] is (first_element, (body, first),\n"
      "second_element, (body, second), sort).");
  define_pickle(bound);
  define_items(
      bound, "intersection",
      [](const BodyIntersections& self) -> const std::vector<BodyIntersection>& { return self.all; },
      [](const BodyIntersection& one) {
        return py::make_tuple(std::string(name_of(one.first_element)), tuple_of(one.first),
                              std::string(name_of(one.second_element)), tuple_of(one.second),
                              std::string(name_of(one.sort)));
      },
      [](const BodyIntersections& self, const std::vector<std::size_t>& chosen) {
        return BodyIntersections{items_at(self.all, chosen), self.left_out};
      });
  define_left_out_at_rest(bound, [](const BodyIntersections& self) -> const BodiesLeftOut& { return self.left_out; });
  bound.def("__repr__", [](const BodyIntersections& self) {
    return "<BodyIntersections: " + std::to_string(self.all.size()) + left_out_text(self.left_out) + ">";
  });
  ResultColumns<BodyIntersections, BodyIntersection> columns(bound, &BodyIntersections::all);
  columns.words("first_element", &BodyIntersection::first_element, "a list of 'edge' or 'vertex'");
  columns.elements("first_body", "first", &BodyIntersection::first, "first");
  columns.words("second_element", &BodyIntersection::second_element, "a list of 'face', 'edge' or 'vertex'");
  columns.elements("second_body", "second", &BodyIntersection::second, "second");
  columns.words("sort", &BodyIntersection::sort, "a list of 'touches', 'pierces' or 'inside'");
}

std::string double_text(double number) { return std::string(py::repr(py::float_(number))); }

/// The same, and what was changed before the question.
template <class Found>
std::string asked_text(const Found& self) {
  std::string text;
  if (self.t_max < 1) text += "; only up to " + double_text(self.t_max);
  if (!self.found.start_checked) text += "; start not checked";
  return text + left_out_text(self.found) + turned_text(self.turned.size());
}

std::string verdict_of(const FoundBodyContact& self) {
  const FirstBodyContact& found = self.found;
  if (found.free()) return "free";
  if (!found.start_intersections.empty()) {
    return std::to_string(found.start_intersections.size()) + " intersections at the start";
  }
  return "toi " + double_text(found.toi) + ", " + std::to_string(found.earliest.size()) + " earliest, " +
         std::to_string(found.at_start.size()) + " at the start";
}

template <class Member>
auto of_found(Member FirstBodyContact::*member) {
  return [member](const FoundBodyContact& self) { return self.found.*member; };
}
auto contacts_of(std::vector<BodyContact> FirstBodyContact::*member) {
  return [member](const FoundBodyContact& self) {
    return pairs_of(self.found.*member, {self.found.excluded, self.turned});
  };
}

void define_first_body_contact(py::module_& module) {
  py::class_<FoundBodyContact> bound =
      define_class<FoundBodyContact>(module, "FirstBodyContact", "The first contact of bodies in a step.");
  define_pickle(bound);
  define_left_out(
      bound, [](const FoundBodyContact& self) { return self.found.excluded; },
      [](const FoundBodyContact& self) -> const std::vector<BodyIndex>& { return self.turned; });
  define_unclear(bound, [](const FoundBodyContact& self) -> const BodiesLeftOut& { return self.found; });
  bound
      .def_property_readonly("contact", of_found(&FirstBodyContact::contact),
                             "whether elements of two bodies that are not in contact at the start come into contact")
      .def_property_readonly("toi", of_found(&FirstBodyContact::toi),
                             "the largest double <= the exact first time of it; inf without one")
      .def_property_readonly("toi_upper", of_found(&FirstBodyContact::toi_upper), "the smallest double >= it")
      .def_property_readonly(
          "free", [](const FoundBodyContact& self) { return self.found.free(); },
          "whether there is no contact at all in the step, and no intersection at the start, if start_checked")
      .def_property_readonly("start_checked", of_found(&FirstBodyContact::start_checked),
                             "whether the start was asked about, by check_start=True")
      .def_property_readonly(
          "start_intersections",
          [](const FoundBodyContact& self) {
            return BodyIntersections{self.found.start_intersections, self.found};
          },
          "BodyIntersections: where bodies intersect at the start; empty when that was not asked")
      .def_property_readonly("earliest", contacts_of(&FirstBodyContact::earliest),
                             "BodyPairs: every pair whose contact begins at exactly that time")
      .def_property_readonly("at_start", contacts_of(&FirstBodyContact::at_start),
                             "BodyPairs: every pair in contact at t = 0")
      .def_readonly("t_max", &FoundBodyContact::t_max, "the end of the time that was asked about")
      .def("__repr__", [](const FoundBodyContact& self) {
        return "<FirstBodyContact: " + verdict_of(self) + asked_text(self) + ">";
      });
}

void define_free_body_step(py::module_& module) {
  py::class_<FoundBodyStep> bound =
      define_class<FoundBodyStep>(module, "FreeBodyStep", "A step of bodies that is proved free of contact.");
  define_pickle(bound);
  bound
      .def_property_readonly(
          "outcome", [](const FoundBodyStep& self) { return outcome_text(self.outcome); },
          "'whole', 'shortened', 'no_room', 'contact_at_start' or 'intersects_at_start'")
      .def_readonly("length", &FoundBodyStep::length, "the fraction of the step, in [0, 1]")
      .def_property_readonly(
          "poses",
          [](const py::object& self) {
            const auto& poses = self.cast<const FoundBodyStep&>().poses;
            return column_of<double>(poses, poses.data(), self, 7);
          },
          "(k, 7) float64: the poses at the end, as start and end have them; the motion to them, rounded as they are, "
          "is free")
      .def_readonly("first_contact", &FoundBodyStep::first_contact, "FirstBodyContact: that of the whole step")
      .def_readonly("proofs", &FoundBodyStep::proofs, "the number of times that all pairs were asked about")
      .def("__repr__", [](const FoundBodyStep& self) {
        return "<FreeBodyStep: " + outcome_text(self.outcome) + ", length " + double_text(self.length) +
               asked_text(self.first_contact) + ">";
      });
}

/// An attribute of the pairs of a BodyScrewAnswer, as an array.
template <class Member>
auto of_screw_pairs(Member ScrewAnswer::*member) {
  return [member](const py::object& self) {
    const std::vector<BodyScrewContact>& all = self.cast<const FoundBodyScrew&>().found.pairs;
    return column_of<Member>(all, all.empty() ? nullptr : &(all[0].answer.*member), self);
  };
}

template <class Member>
auto of_screw(Member BodyScrewAnswer::*member) {
  return [member](const FoundBodyScrew& self) { return self.found.*member; };
}

void define_body_screw_answer(py::module_& module) {
  py::class_<FoundBodyScrew> bound = define_class<FoundBodyScrew>(
      module, "BodyScrewAnswer", "Whether bodies that turn at constant rates come into contact.");
  define_pickle(bound);
  define_left_out(
      bound, [](const FoundBodyScrew& self) { return self.found.excluded; },
      [](const FoundBodyScrew& self) -> const std::vector<BodyIndex>& { return self.turned; });
  define_unclear(bound, [](const FoundBodyScrew& self) -> const BodiesLeftOut& { return self.found; });
  bound
      .def_property_readonly(
          "verdict", [](const FoundBodyScrew& self) { return std::string(name_of(self.found.verdict)); },
          "'free', 'contact', or 'within the bound' where elements come so near that the bound leaves it open")
      .def_property_readonly(
          "free", [](const FoundBodyScrew& self) { return self.found.free(); },
          "whether there is certainly no contact, and no intersection at the start, if start_checked")
      .def_property_readonly("free_until", of_screw(&BodyScrewAnswer::free_until),
                             "there is certainly no contact before this time; t_max for 'free'")
      .def_property_readonly("contact_by", of_screw(&BodyScrewAnswer::contact_by),
                             "for 'contact': there certainly is one at this time or before it; t_max otherwise")
      .def_property_readonly("start_checked", of_screw(&BodyScrewAnswer::start_checked),
                             "whether the start was asked about, by check_start=True")
      .def_property_readonly(
          "start_intersections",
          [](const FoundBodyScrew& self) {
            return BodyIntersections{self.found.start_intersections, self.found};
          },
          "BodyIntersections: where bodies intersect at the start; empty when that was not asked")
      .def_property_readonly(
          "pairs",
          [](const FoundBodyScrew& self) {
            BodyPairs pairs;
            pairs.left_out = {self.found.excluded, self.turned};
            for (const BodyScrewContact& one : self.found.pairs) pairs.pairs.push_back(one.pair);
            return pairs;
          },
          "BodyPairs without answers: every pair that meets, or may meet, by contact_by")
      .def_property_readonly(
          "pair_verdict",
          [](const FoundBodyScrew& self) {
            py::list list;
            for (const BodyScrewContact& one : self.found.pairs) list.append(std::string(name_of(one.answer.verdict)));
            return list;
          },
          "a list of the pairs' verdicts: 'contact' or 'within the bound'")
      .def_property_readonly("pair_free_until", of_screw_pairs(&ScrewAnswer::free_until),
                             "(n,) float64: free_until of each pair")
      .def_property_readonly("pair_contact_by", of_screw_pairs(&ScrewAnswer::contact_by),
                             "(n,) float64: contact_by of each pair")
      .def_property_readonly("pair_deviation", of_screw_pairs(&ScrewAnswer::deviation),
                             "(n,) float64: no corner was ever farther than this from where it should be")
      .def_readonly("t_max", &FoundBodyScrew::t_max, "the end of the time that was asked about")
      .def("__repr__", [](const FoundBodyScrew& self) {
        const BodyScrewAnswer& found = self.found;
        std::string text = "<BodyScrewAnswer: " + std::string(name_of(found.verdict));
        if (found.verdict != ScrewVerdict::free) {
          text += ", free until " + double_text(found.free_until);
          if (found.verdict == ScrewVerdict::contact) text += ", contact by " + double_text(found.contact_by);
          text += ", " + std::to_string(found.pairs.size()) + " pairs";
        }
        if (!found.start_intersections.empty()) {
          text += ", " + std::to_string(found.start_intersections.size()) + " intersections at the start";
        }
        return text + asked_text(self) + ">";
      });
}

void define_body_distance(py::module_& module) {
  py::class_<FoundBodyDistance> bound =
      define_class<FoundBodyDistance>(module, "BodyDistance", "How near bodies come to each other at rest.");
  define_pickle(bound);
  define_left_out_at_rest(bound, [](const FoundBodyDistance& self) -> const BodiesLeftOut& { return self.found; });
  bound
      .def_property_readonly(
          "distance", [](const FoundBodyDistance& self) { return self.found.distance; },
          "the least distance, rounded up to a double; 0 where bodies intersect, inf where none may collide")
      .def_property_readonly(
          "pairs",
          [](const FoundBodyDistance& self) {
            return pairs_of(self.found.pairs, {self.found.excluded, {}});
          },
          "BodyPairs: every pair within this distance")
      .def_property_readonly(
          "intersections",
          [](const FoundBodyDistance& self) {
            return BodyIntersections{self.found.intersections, self.found};
          },
          "BodyIntersections: where bodies intersect")
      .def("__repr__", [](const FoundBodyDistance& self) {
        const BodyDistance& found = self.found;
        return "<BodyDistance: " + double_text(found.distance) + ", " + std::to_string(found.pairs.size()) +
               " pairs, " + std::to_string(found.intersections.size()) + " intersections" + left_out_text(found) + ">";
      });
}

}  // namespace

BodyPairs pairs_of(const std::vector<BodyContact>& contacts, LeftOut left_out) {
  BodyPairs all;
  all.left_out = std::move(left_out);
  for (const BodyContact& contact : contacts) {
    all.pairs.push_back(contact.pair);
    all.separations.push_back(contact.separation.distance);
    all.answers.push_back(contact.answer);
  }
  return all;
}

void define_rigid_results(py::module_& module) {
  define_body_pairs(module);
  define_body_intersections(module);
  define_first_body_contact(module);
  define_free_body_step(module);
  define_body_screw_answer(module);
  define_body_distance(module);
}

}  // namespace touchstone::python

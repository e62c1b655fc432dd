// SPDX-License-Identifier: MIT
#include "python/answers.hpp"

#include <array>
#include <cstdint>
#include <string>

#include "python/items.hpp"
#include "python/pickles.hpp"

namespace touchstone::python {
namespace {

/// The members of the four enumerations, in order. They live as long as the process: modules are not unloaded.
struct NamedMembers {
  py::tuple natures, features, levels, trends;
};

const NamedMembers& named_members() {
  static const NamedMembers* const names = [] {
    const py::module_ module = py::module_::import("touchstone._names");
    const auto members = [&](const char* name) { return py::tuple(module.attr(name)); };
    return new NamedMembers{members("Nature"), members("Feature"), members("Level"), members("Trend")};
  }();
  return *names;
}

template <class Enumeration>
py::object member(const py::tuple& names, Enumeration value) {
  return names[static_cast<std::size_t>(value)];
}

py::tuple tuple_of(const std::array<double, 3>& weights) { return py::make_tuple(weights[0], weights[1], weights[2]); }

std::string text_of(const Answer& answer) {
  if (!answer.contact) return "Answer(contact=False, level=" + std::string(name_of(answer.level)) + ")";
  const auto number = [](double x) { return std::string(py::repr(py::float_(x))); };
  return "Answer(contact=True, toi=" + number(answer.toi) + ", toi_upper=" + number(answer.toi_upper) +
         ", nature=" + std::string(name_of(answer.nature)) + ", feature_a=" + std::string(name_of(answer.feature_a)) +
         ", feature_b=" + std::string(name_of(answer.feature_b)) + ", level=" + std::string(name_of(answer.level)) +
         ")";
}

std::string text_of(const Answers& answers) {
  std::size_t contacts = 0;
  for (const Answer& answer : answers.all()) contacts += answer.contact ? 1 : 0;
  return "<Answers: " + std::to_string(answers.all().size()) + ", " + std::to_string(contacts) + " with contact>";
}

/// A property whose value is a column of the answers. `Number` is the type of the array's elements, which a member that
/// is an enumeration or a flag is stored as.
template <class Number, class Member>
void column(py::class_<Answers>& answers, const char* name, Member Answer::*member, const char* help) {
  static_assert(sizeof(Member) % sizeof(Number) == 0);
  const auto get = [member](const py::object& self) {
    const auto& all = self.cast<const Answers&>().all();
    constexpr std::size_t kWidth = sizeof(Member) / sizeof(Number);
    return column_of<Number>(all, all.empty() ? nullptr : &(all[0].*member), self, kWidth > 1 ? kWidth : 0);
  };
  answers.def_property_readonly(name, get, help);
}

void define_answer(py::module_& module) {
  py::class_<Answer> bound =
      define_class<Answer>(module, "Answer", "The answer to one query. Without contact only contact and level count.");
  define_pickle(bound);
  bound.def_readonly("contact", &Answer::contact, "whether the elements touch at any time in [0, t_max]")
      .def_readonly("toi", &Answer::toi, "the largest double <= the exact first time; inf without contact")
      .def_readonly("toi_upper", &Answer::toi_upper, "the smallest double >= the exact first time")
      .def_readonly("starts_within", &Answer::starts_within, "whether the contact exists at t = 0 already")
      .def_property_readonly(
          "nature", [](const Answer& answer) { return name_object(answer.nature); }, "a Nature")
      .def_property_readonly(
          "feature_a", [](const Answer& answer) { return name_object(answer.feature_a); },
          "a Feature: the touched part of the first element")
      .def_property_readonly(
          "feature_b", [](const Answer& answer) { return name_object(answer.feature_b); },
          "a Feature: the touched part of the second element")
      .def_property_readonly(
          "level", [](const Answer& answer) { return name_object(answer.level); }, "a Level: which level decided")
      .def_property_readonly(
          "trend", [](const Answer& answer) { return name_object(answer.trend); }, "a Trend, with a separation above 0")
      .def_property_readonly(
          "weights_a", [](const Answer& answer) { return tuple_of(answer.weights_a); },
          "three barycentric coordinates on the first element, each within 2^-50")
      .def_property_readonly(
          "weights_b", [](const Answer& answer) { return tuple_of(answer.weights_b); },
          "three barycentric coordinates on the second element, each within 2^-50")
      .def("__bool__", [](const Answer& answer) { return answer.contact; })
      .def("__repr__", [](const Answer& answer) { return text_of(answer); });
}

}  // namespace

py::object name_object(Nature nature) { return member(named_members().natures, nature); }
py::object name_object(Feature feature) { return member(named_members().features, feature); }
py::object name_object(Level level) { return member(named_members().levels, level); }
py::object name_object(Trend trend) { return member(named_members().trends, trend); }

void define_answers(py::module_& module) {
  define_answer(module);
  py::class_<Answers> answers =
      define_class<Answers>(module, "Answers",
                            "The answers to n queries, in their order: arrays without copies that cannot be written\n"
                            "to. answers[i] is an Answer.");
  define_pickle(
      answers, [](const Answers& self) { return self.all(); },
      [](std::vector<Answer>&& all) { return Answers(std::move(all)); });
  const auto items = [](const Answers& self) -> const std::vector<Answer>& { return self.all(); };
  define_items(
      answers, "answer", items, [](const Answer& answer) { return answer; },
      [](const Answers& self, const std::vector<std::size_t>& chosen) {
        return Answers(items_at(self.all(), chosen));
      });
  answers.def("__repr__", [](const Answers& self) { return text_of(self); });
  column<bool>(answers, "contact", &Answer::contact, "(n,) bool: whether the elements touch at any time in [0, t_max]");
  column<double>(answers, "toi", &Answer::toi,
                 "(n,) float64: the largest double <= the exact first time; inf without contact");
  column<double>(answers, "toi_upper", &Answer::toi_upper,
                 "(n,) float64: the smallest double >= the exact first time; inf without contact");
  column<std::uint8_t>(answers, "nature", &Answer::nature, "(n,) uint8: codes of Nature");
  column<std::uint8_t>(answers, "feature_a", &Answer::feature_a,
                       "(n,) uint8: codes of Feature, the touched part of the first element");
  column<std::uint8_t>(answers, "feature_b", &Answer::feature_b,
                       "(n,) uint8: codes of Feature, the touched part of the second element");
  column<std::uint8_t>(answers, "level", &Answer::level, "(n,) uint8: codes of Level, which level decided");
  column<std::uint8_t>(answers, "trend", &Answer::trend, "(n,) uint8: codes of Trend, with a separation above 0");
  column<bool>(answers, "starts_within", &Answer::starts_within,
               "(n,) bool: whether the contact exists at t = 0 already");
  column<double>(answers, "weights_a", &Answer::weights_a,
                 "(n, 3) float64: barycentric coordinates on the first element, each within 2^-50");
  column<double>(answers, "weights_b", &Answer::weights_b,
                 "(n, 3) float64: barycentric coordinates on the second element, each within 2^-50");
}

}  // namespace touchstone::python

// Replies about a step, of a mesh or of whole bodies, judged by the exact answers to all pairs of elements.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <touchstone/fuzz.hpp>

#include "fuzz/processes/no_reply.hpp"
#include "fuzz/scenes/scene_search.hpp"
#include "geometry/kind_traits.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::fuzz {

/// The pair whose elements, if they are of one sort, are in ascending order.
template <class Pair>
Pair with_ascending(const Pair& pair) noexcept {
  const geometry::KindTraits& traits = geometry::traits_of(pair.kind);
  if (traits.first.sort != traits.second.sort || !(pair.second < pair.first)) return pair;
  return {pair.kind, pair.second, pair.first};
}

/// Whether a mesh has the element with this number.
inline bool has_element(const Mesh& mesh, MeshElement sort, MeshIndex number) {
  return number < (sort == MeshElement::face   ? mesh.faces().size()
                   : sort == MeshElement::edge ? mesh.edges().size()
                                               : mesh.vertex_count());
}

/// Whether two replies are equal, in any order of the candidates.
template <class Reply>
bool same_replies(const Reply& a, const Reply& b) {
  const auto in_order = [](const Reply& reply) {
    auto pairs = reply.candidates;
    if (!pairs) return pairs;
    for (auto& pair : *pairs) pair = with_ascending(pair);
    std::sort(pairs->begin(), pairs->end());
    return pairs;
  };
  return a.free == b.free && a.first_contact == b.first_contact && in_order(a) == in_order(b);
}

inline std::string at_time(double time) { return std::string(" at ").append(numbers::decimal_text(time)); }

/// The judge of replies about one scene. @tparam Contact  has a pair and its exact answer
template <class Contact>
class ReplyJudge {
 public:
  using Pair = decltype(Contact::pair);

  /// @param exact     every pair in contact
  /// @param fault     why a pair is none of the scene's; empty for one that is
  /// @param describe  a pair for a person
  /// @param intersects_at_start  whether elements pierce each other at the start: then 0 is right, too
  ReplyJudge(std::vector<Contact> exact, std::function<std::string(const Pair&)> fault,
             std::function<std::string(const Pair&)> describe, std::function<bool()> intersects_at_start,
             const StepFuzzOptions& options)
      : exact_(std::move(exact)),
        fault_(std::move(fault)),
        describe_(std::move(describe)),
        intersects_at_start_(std::move(intersects_at_start)),
        options_(options) {
    const auto earlier = [](const Contact& a, const Contact& b) {
      return std::tie(a.answer.toi, a.answer.toi_upper) < std::tie(b.answer.toi, b.answer.toi_upper);
    };
    if (!exact_.empty()) first_ = &*std::min_element(exact_.begin(), exact_.end(), earlier);
  }
  ReplyJudge(const ReplyJudge&) = delete;
  ReplyJudge& operator=(const ReplyJudge&) = delete;

  /// Asks, twice if the options say so. @param ask  for the reply of the function under test
  /// @return nothing when all of it is right
  template <class Ask>
  std::optional<SceneFailure> judge(const Ask& ask) const {
    try {
      const auto reply = ask();
      if (reply.candidates) {
        if (auto wrong = judge_candidates(*reply.candidates)) return wrong;
      }
      if (reply.free) {
        if (auto wrong = judge_free(*reply.free)) return wrong;
      }
      if (reply.first_contact) {
        if (auto wrong = judge_first(*reply.first_contact)) return wrong;
      }
      if (options_.twice && !same_replies(ask(), reply))
        return SceneFailure{FuzzFailure::differs, "all", "asked again, it says something else"};
    } catch (const NoReply& trouble) {
      return SceneFailure{trouble.failure(), "all", trouble.what()};
    } catch (const std::exception& error) {
      return SceneFailure{FuzzFailure::crash, "all", error.what()};
    }
    return std::nullopt;
  }

 private:
  static bool is_fraction(double x) { return x >= 0 && x <= 1; }

  /// "vertex 5 and face 2 (0-1-9) at 0.25"; "... between 0.3 and the next double".
  std::string text_of(const Contact& contact) const {
    const double toi = contact.answer.toi;
    if (toi == contact.answer.toi_upper) return describe_(contact.pair) + at_time(toi);
    return describe_(contact.pair) + " between " + numbers::decimal_text(toi) + " and the next double";
  }

  std::optional<SceneFailure> judge_candidates(std::vector<Pair> told) const {
    for (Pair& pair : told) {
      if (const std::string fault = fault_(pair); !fault.empty())
        return SceneFailure{FuzzFailure::malformed, "candidates", fault};
      pair = with_ascending(pair);
    }
    std::sort(told.begin(), told.end());
    for (const Contact& one : exact_) {
      if (std::binary_search(told.begin(), told.end(), one.pair)) continue;
      return SceneFailure{FuzzFailure::missed, "candidates", text_of(one) + " is not among them"};
    }
    return std::nullopt;
  }

  std::optional<SceneFailure> judge_free(double free) const {
    const auto wrong = [&](FuzzFailure failure, const std::string& what) {
      return SceneFailure{failure, "free", "a step of " + numbers::decimal_text(free) + what};
    };
    if (!is_fraction(free)) return wrong(FuzzFailure::malformed, ", which is not from 0 to 1");
    if (first_ != nullptr && first_->answer.toi_upper <= free) {
      const bool ends_there = first_->answer.toi == free && first_->answer.toi_upper == free;
      if (!(ends_there && (options_.may_end_in_contact || free == 0))) {
        return wrong(free == 1 ? FuzzFailure::missed : FuzzFailure::late,
                     (ends_there ? " ends in the first contact: " : " is longer than the way to the first contact: ") +
                         text_of(*first_));
      }
    }
    if (free == 0 && intersects_at_start_()) return std::nullopt;
    const double room = first_ == nullptr ? 1 : first_->answer.toi;
    const std::string text = first_ == nullptr ? ", and no contact" : ", and " + text_of(*first_);
    if (free < options_.stall * room) return wrong(FuzzFailure::early, text + ": a stall");
    // The double before a contact is the longest step.
    if (options_.early_fraction && room - free > *options_.early_fraction && free < std::nextafter(room, 0))
      return wrong(FuzzFailure::early, text);
    return std::nullopt;
  }

  std::optional<SceneFailure> judge_first(double told) const {
    const auto wrong = [&](FuzzFailure failure, const std::string& what) {
      return SceneFailure{failure, "first contact", what};
    };
    const bool denies = told == std::numeric_limits<double>::infinity();
    const std::string text = "told" + at_time(told) + ", and exactly ";
    if (!denies && !is_fraction(told)) return wrong(FuzzFailure::malformed, "told" + at_time(told));
    if (told == 0 && intersects_at_start_()) return std::nullopt;
    if (denies && first_ != nullptr) return wrong(FuzzFailure::missed, text_of(*first_));
    if (!denies && first_ == nullptr) return wrong(FuzzFailure::phantom, text + "none");
    if (denies) return std::nullopt;
    if (told - first_->answer.toi > options_.late_fraction) return wrong(FuzzFailure::late, text + text_of(*first_));
    if (options_.early_fraction && first_->answer.toi - told > *options_.early_fraction)
      return wrong(FuzzFailure::early, text + text_of(*first_));
    return std::nullopt;
  }

  std::vector<Contact> exact_;
  std::function<std::string(const Pair&)> fault_, describe_;
  std::function<bool()> intersects_at_start_;
  const StepFuzzOptions& options_;
  const Contact* first_ = nullptr;
};

}  // namespace touchstone::fuzz

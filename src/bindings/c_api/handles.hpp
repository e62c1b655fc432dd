// What functions with handles have in common: arrays of indices, flags, lists, and the handle of a mesh.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/mesh.hpp>
#include <touchstone/mesh_steps.hpp>

#include "c_api/guard.hpp"

struct touchstone_mesh {
  touchstone::Mesh mesh;
  std::unique_ptr<touchstone::MeshSteps> steps = nullptr;  ///< or null where nothing is kept from call to call
};

namespace touchstone::c_api {

/// `count` elements of N numbers each.
template <std::size_t N>
std::vector<std::array<MeshIndex, N>> indices(const std::uint32_t* first, std::size_t count, const char* name) {
  array(first, count, N, name);
  std::vector<std::array<MeshIndex, N>> elements(count);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(first + N * i, N, elements[i].begin());
  return elements;
}

template <typename T>
std::vector<T> values(const T* first, std::size_t count, const char* name) {
  array(first, count, 1, name);
  return first == nullptr ? std::vector<T>() : std::vector<T>(first, first + count);
}

/// @throws InvalidArgument  for another number than 0 and 1
inline bool flag(int value, const char* name) {
  if (value == 0 || value == 1) return value == 1;
  throw InvalidArgument(std::string(name) + " is " + std::to_string(value) + "; it must be 0 or 1");
}

inline GroupRule group_rule_of(int only_listed_groups) {
  return flag(only_listed_groups, "only_listed_groups") ? GroupRule::only_listed : GroupRule::all_but_listed;
}

/// Refuses a result that its macro did not initialise.
template <typename Result>
void check_size(const Result& result, const char* name) {
  grown(result, result, sizeof result, name);
}

/// Refuses an index that is not below the count of a list.
inline void check_index(std::size_t index, std::size_t count) {
  if (index >= count) {
    throw InvalidArgument("the index is " + std::to_string(index) + "; it must be less than " + std::to_string(count));
  }
}

/// An item of a list. Refuses a null pointer, and such an index.
template <typename List>
const auto& item_of(const List* list, std::size_t index, const char* name) {
  const auto& all = required(list, name).all;
  check_index(index, all.size());
  return all[index];
}

template <typename List>
std::size_t count_of(const List* list) noexcept {
  return list == nullptr ? 0 : list->all.size();
}

/// Makes the caller's handle null, for the case of an error.
template <typename Handle>
void clear(Handle** handle) {
  if (handle != nullptr) *handle = nullptr;
}

/// Makes lists of both, for the handles that are not null: all of them, or none where memory runs out.
template <typename Items, typename List, typename OtherItems, typename OtherList>
void hand_over(Items& items, List** handle, OtherItems& others, OtherList** other_handle) {
  std::unique_ptr<List> list;
  std::unique_ptr<OtherList> other_list;
  if (handle != nullptr) list.reset(new List{std::move(items)});
  if (other_handle != nullptr) other_list.reset(new OtherList{std::move(others)});
  if (handle != nullptr) *handle = list.release();
  if (other_handle != nullptr) *other_handle = other_list.release();
}

}  // namespace touchstone::c_api

// SPDX-License-Identifier: MIT
#include "python/arguments.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/kind_aliases.hpp"

namespace touchstone::python {
namespace {

template <class E>
std::optional<E> value_named(const std::string& name) {
  return from_name<E>(name);
}
template <>
std::optional<Kind> value_named<Kind>(const std::string& name) {
  return geometry::kind_named(name);
}

/// The value of E with this name, in which '_' may stand for '-'. @param none  a value that is not one of those
template <class E>
E value_of(py::handle name, const char* what, std::optional<E> none = std::nullopt) {
  if (!PyUnicode_Check(name.ptr())) {
    throw py::type_error(std::string(what) + " is of type " + Py_TYPE(name.ptr())->tp_name + "; it must be a string");
  }
  Py_ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(name.ptr(), &size);
  if (text == nullptr) throw py::error_already_set();
  std::string given(text, static_cast<std::size_t>(size));
  std::replace(given.begin(), given.end(), '_', '-');
  if (const auto value = value_named<E>(given); value && value != none) return *value;
  std::string message = std::string(what) + " is " + std::string(py::str(py::repr(name))) + "; it must be one of ";
  const Names names = names_of<E>();
  const char* before = "'";
  for (const std::string_view& known : names) {
    if (none && known == name_of(*none)) continue;
    message.append(std::exchange(before, ", '")).append(known).append("'");
  }
  throw py::value_error(message);
}

/// The Python half of the module, for what needs no speed.
py::object array_helper(const char* name) { return py::module_::import("touchstone._arrays").attr(name); }

py::dtype of_doubles() { return py::dtype::of<double>(); }

/// Whether an array is of NumPy's own type, not of a subclass.
bool is_plain(py::handle array) { return Py_TYPE(array.ptr()) == py::detail::npy_api::get().PyArray_Type_; }

}  // namespace

Kind kind_of(py::handle name) { return value_of<Kind>(name, "kind"); }
Metric metric_of(py::handle name) { return value_of<Metric>(name, "metric"); }
Method method_of(py::handle name) { return value_of<Method>(name, "method"); }
Wanted wanted_of(py::handle name) { return value_of<Wanted>(name, "wanted"); }
MeshElement element_of(py::handle name) { return value_of<MeshElement>(name, "the element"); }
IntersectionSort intersection_sort_of(py::handle name) {
  return value_of<IntersectionSort>(name, "the sort of the intersection");
}
Verdict refuted_verdict_of(py::handle name) { return value_of<Verdict>(name, "one of classes", Verdict::holds); }

MeshIndex number_in(const py::tuple& pair, std::size_t i) {
  constexpr long long kMost = 4294967294;
  int too_long = 0;
  check_whole(pair[i], "item " + std::to_string(i) + " of the pair " + std::string(py::str(py::repr(pair))));
  const long long value = PyLong_AsLongLongAndOverflow(pair[i].ptr(), &too_long);
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (too_long != 0 || value < 0 || value > kMost) {
    throw py::value_error("the pair " + std::string(py::str(py::repr(pair))) + " has an index outside [0, 2^32 - 2]");
  }
  return static_cast<MeshIndex>(value);
}

MeshPair pair_of(py::handle given) {
  if (!py::isinstance<py::tuple>(given) || py::len(given) != 3) {
    throw py::value_error("a pair is a tuple (kind, first, second), not " + std::string(py::str(py::repr(given))));
  }
  const auto pair = py::reinterpret_borrow<py::tuple>(given);
  return {kind_of(pair[0]), number_in(pair, 1), number_in(pair, 2)};
}

py::dict all_names() {
  py::dict all;
  const auto add = [&all](const char* enumeration, const Names& names) {
    py::tuple words(names.size());
    std::size_t i = 0;
    for (const std::string_view name : names) words[i++] = py::str(name.data(), name.size());
    all[enumeration] = words;
  };
  add("Kind", names_of<Kind>());
  add("Metric", names_of<Metric>());
  add("Method", names_of<Method>());
  add("Wanted", names_of<Wanted>());
  add("Nature", names_of<Nature>());
  add("Trend", names_of<Trend>());
  add("Feature", names_of<Feature>());
  add("Level", names_of<Level>());
  return all;
}

void check_whole(py::handle number, const std::string& what) {
  if (py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()))) return;
  if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
  PyErr_Clear();
  throw py::type_error(what + " is of type " + Py_TYPE(number.ptr())->tp_name + "; it must be a whole number");
}

int whole_in(py::handle number, const char* what, int least, int most, const char* right) {
  check_whole(number, what);
  int too_long = 0;
  const long value = PyLong_AsLongAndOverflow(number.ptr(), &too_long);
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (too_long != 0 || value < least || value > most) {
    throw py::value_error(std::string(what) + " is " + std::string(py::str(number)) + "; it must be " + right);
  }
  return static_cast<int>(value);
}

int threads_of(py::handle threads) {
  return whole_in(threads, "threads", 0, 1024, "in [0, 1024], 0 for as many as the machine has");
}

double number_of(py::handle number, const char* what) {
  if (PyFloat_Check(number.ptr())) return PyFloat_AS_DOUBLE(number.ptr());
  const double value = PyFloat_AsDouble(number.ptr());
  if (value == -1 && PyErr_Occurred() != nullptr) {
    if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
    PyErr_Clear();
    throw py::type_error(std::string(what) + " is of type " + Py_TYPE(number.ptr())->tp_name + "; it must be a number");
  }
  // A float of another size, an int or a fraction may be no double.
  if (!py::bool_(py::float_(value).equal(number)) && value == value) {
    throw py::value_error(std::string(what) + " is " + std::string(py::str(number)) + ", which no double equals");
  }
  return value;
}

std::string shape_text(const py::array& array) { return std::string(py::str(py::object(array.attr("shape")))); }

py::array exact_array(py::handle values, const char* what) {
  // Subclasses go the other way: a masked array has elements that do not count.
  if (py::isinstance<py::array>(values) && is_plain(values)) {
    const auto array = py::reinterpret_borrow<py::array>(values);
    const py::dtype type = array.dtype();
    if (type.is(of_doubles())) return array;
    if (type.kind() == 'f' && type.itemsize() == sizeof(float) && type.attr("isnative").cast<bool>()) return array;
  }
  return py::array(array_helper("exact_doubles")(values, what));
}

CornerArray::CornerArray(py::handle values, Kind kind, const char* what)
    : owner_(exact_array(values, what)), corners_(corner_count(kind)) {
  const auto dimensions = owner_.ndim();
  const auto fits = [&] {
    if (dimensions != 2 && dimensions != 3) return false;
    const py::ssize_t coordinates = owner_.shape(dimensions - 1);
    return owner_.shape(dimensions - 2) == static_cast<py::ssize_t>(corners_) && (coordinates == 2 || coordinates == 3);
  };
  if (!fits()) {
    const std::string corners = std::to_string(corners_);
    throw py::value_error(std::string(what) + " has the shape " + shape_text(owner_) + "; for " +
                          std::string(name_of(kind)) + " it must be (n, " + corners + ", 3) or (n, " + corners +
                          ", 2), or without n for a single query");
  }
  single_ = dimensions == 2;
  if (!single_) {
    count_ = static_cast<std::size_t>(owner_.shape(0));
    query_stride_ = owner_.strides(0);
  }
  corner_stride_ = owner_.strides(dimensions - 2);
  coordinate_stride_ = owner_.strides(dimensions - 1);
  coordinates_ = static_cast<std::size_t>(owner_.shape(dimensions - 1));
  is_float_ = owner_.itemsize() == sizeof(float);
  data_ = static_cast<const char*>(owner_.data());
}

void CornerArray::read(std::size_t q, std::array<Vec3, 4>& corners) const noexcept {
  for (std::size_t c = 0; c < corners_; ++c) corners[c] = {at(q, c, 0), at(q, c, 1), at(q, c, 2)};
}

bool CornerArray::has_columns() const noexcept {
  constexpr std::ptrdiff_t kDouble = sizeof(double);
  return !is_float_ && query_stride_ == kDouble && corner_stride_ % kDouble == 0 && coordinate_stride_ % kDouble == 0 &&
         reinterpret_cast<std::uintptr_t>(data_) % alignof(double) == 0;
}

const double* CornerArray::column(std::size_t first, std::size_t c, std::size_t k, const double* zeros) const noexcept {
  if (k >= coordinates_) return zeros;
  const char* const address =
      data_ + static_cast<std::ptrdiff_t>(c) * corner_stride_ + static_cast<std::ptrdiff_t>(k) * coordinate_stride_;
  return reinterpret_cast<const double*>(address) + first;
}

template <class Number>
void CornerArray::copy(std::size_t first, std::size_t size, double* to) const noexcept {
  const char* const start = data_ + static_cast<std::ptrdiff_t>(first) * query_stride_;
  for (std::size_t c = 0; c < corners_; ++c) {
    for (std::size_t k = 0; k < 3; ++k, to += size) {
      if (k >= coordinates_) {
        std::fill_n(to, size, 0.0);
        continue;
      }
      const char* address =
          start + static_cast<std::ptrdiff_t>(c) * corner_stride_ + static_cast<std::ptrdiff_t>(k) * coordinate_stride_;
      for (std::size_t q = 0; q < size; ++q, address += query_stride_) to[q] = load<Number>(address);
    }
  }
}

void CornerArray::copy_columns(std::size_t first, std::size_t size, double* to) const noexcept {
  is_float_ ? copy<float>(first, size, to) : copy<double>(first, size, to);
}

SeparationArgument separation_of(py::handle distance, py::handle metric, std::size_t count, bool single) {
  SeparationArgument argument;
  argument.separation.metric = metric_of(metric);
  if (PyFloat_Check(distance.ptr()) || PyLong_Check(distance.ptr())) {
    argument.separation.distance = number_of(distance, "separation");
    return argument;
  }
  const py::array all = exact_array(distance, "separation");
  if (all.ndim() == 0) {
    argument.separation.distance = number_of(distance, "separation");
    return argument;
  }
  if (single || all.ndim() != 1 || static_cast<std::size_t>(all.shape(0)) != count) {
    throw py::value_error(
        "separation has the shape " + shape_text(all) + "; it must be a number" +
        (single ? "" : ", or an array of one number for each of the " + std::to_string(count) + " queries"));
  }
  argument.separations = numbers(distance, "separation");
  return argument;
}

namespace {

/// Whole numbers with the right shape, as an array of uint32 without gaps.
py::array index_array(py::handle values, const char* what, std::size_t columns) {
  return py::array(array_helper("indices")(values, what, columns));
}

}  // namespace

template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> index_rows(py::handle values, const char* what) {
  static_assert(sizeof(std::array<std::uint32_t, N>) == N * sizeof(std::uint32_t));
  if (values.is_none()) return {};
  const py::array array = index_array(values, what, N);
  std::vector<std::array<std::uint32_t, N>> rows(static_cast<std::size_t>(array.shape(0)));
  if (!rows.empty()) std::memcpy(rows.data(), array.data(), rows.size() * sizeof(rows[0]));
  return rows;
}

template std::vector<std::array<std::uint32_t, 2>> index_rows(py::handle, const char*);
template std::vector<std::array<std::uint32_t, 3>> index_rows(py::handle, const char*);

std::vector<std::uint32_t> indices(py::handle values, const char* what) {
  if (values.is_none()) return {};
  const py::array array = index_array(values, what, 0);
  std::vector<std::uint32_t> all(static_cast<std::size_t>(array.shape(0)));
  if (!all.empty()) std::memcpy(all.data(), array.data(), all.size() * sizeof(all[0]));
  return all;
}

std::vector<std::size_t> chosen_of(const py::object& several, std::size_t count, const char* what) {
  std::vector<std::size_t> chosen;
  if (py::isinstance<py::slice>(several)) {
    std::size_t start = 0, stop = 0, step = 0, size = 0;
    if (!several.cast<py::slice>().compute(count, &start, &stop, &step, &size)) throw py::error_already_set();
    chosen.reserve(size);
    for (std::size_t i = 0; i < size; ++i, start += step) chosen.push_back(start);
    return chosen;
  }
  const auto array = array_helper("places")(several, count, what).cast<py::array_t<std::int64_t>>();
  chosen.assign(array.data(), array.data() + array.size());
  return chosen;
}

std::vector<double> numbers(py::handle values, const char* what) {
  if (values.is_none()) return {};
  const py::array given = exact_array(values, what);
  if (given.ndim() != 1) {
    throw py::value_error(std::string(what) + " has the shape " + shape_text(given) + "; it must be (n,)");
  }
  const auto doubles = py::array_t<double, py::array::c_style | py::array::forcecast>(given);
  return {doubles.data(), doubles.data() + doubles.size()};
}

}  // namespace touchstone::python

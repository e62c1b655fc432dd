// What the module has about whole bodies.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/bodies.hpp>

#include "python/define.hpp"

namespace touchstone::python {

struct BodyRecord;

/// What a pickle has of a body, and the body of it.
BodyRecord record_of(const Body& body);
Body body_of(BodyRecord&& record);

/// `Body`.
void define_body(py::module_& module);
/// `Bodies`, whose methods are the questions, and what they return.
void define_bodies(py::module_& module);

}  // namespace touchstone::python

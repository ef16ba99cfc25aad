// The values of the Python module: materials, meshes, bodies, settings, states.
#pragma once
#include <pybind11/pybind11.h>

namespace fascia::python {

void define_values(pybind11::module_& m);

}  // namespace fascia::python

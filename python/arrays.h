// Arrays between Python and C++. Results are numpy arrays where numpy can be imported, else memoryviews of the same
// shape; either way the numbers are not copied again. What is given may be anything with such a shape: numpy arrays,
// other buffers, lists of lists.
#pragma once
#include <pybind11/pybind11.h>

#include <cstdint>
#include <span>
#include <vector>

namespace fascia::python {

namespace py = pybind11;

/// [count][columns] numbers that Python then owns; one column: [count].
py::object array_of(std::vector<double> numbers, std::size_t columns = 1);
/// The same, read only, of numbers that live as long as `owner` does.
py::object view_of(std::span<const double> numbers, std::size_t columns, const py::object& owner);
py::object view_of(std::span<const std::uint32_t> numbers, std::size_t columns, const py::object& owner);

/// The numbers of any shape one after the other, the last index fastest. Throws TypeError for what is no array of
/// numbers.
std::vector<double> numbers_of(const py::object& array);
/// Throws ValueError for numbers that are no index.
std::vector<std::uint32_t> indices_of(const py::object& array);

void define_arrays(py::module_& module);

}  // namespace fascia::python

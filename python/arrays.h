// Arrays between Python and C++. Results are numpy arrays if numpy can be imported, else memoryviews of the same shape;
// in both cases the numbers are not copied again. Arguments may be anything of the right shape: numpy arrays, other
// buffers, lists of lists.
#pragma once
#include <pybind11/pybind11.h>

#include <cstdint>
#include <span>
#include <vector>

namespace fascia::python {

namespace py = pybind11;

/// [count][columns] numbers, owned by Python; one column: [count].
py::object array_of(std::vector<double> numbers, std::size_t columns = 1);
/// The same, read-only, for numbers that exist as long as `owner`.
py::object view_of(std::span<const double> numbers, std::size_t columns, const py::object& owner);
py::object view_of(std::span<const std::uint32_t> numbers, std::size_t columns, const py::object& owner);

/// The numbers of any shape in sequence, the last index fastest. Throws TypeError if the argument is no array of
/// numbers.
std::vector<double> numbers_of(const py::object& array);
/// Throws ValueError for numbers that are not indices.
std::vector<std::uint32_t> indices_of(const py::object& array);

void define_arrays(py::module_& module);

}  // namespace fascia::python

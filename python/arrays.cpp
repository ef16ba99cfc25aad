#include "python/arrays.h"

#include <cmath>
#include <variant>

namespace fascia::python {
namespace {

/// The memory behind a numpy array or a memoryview.
struct Block {
  std::variant<std::vector<double>, std::span<const double>, std::span<const std::uint32_t>> numbers;
  std::size_t columns = 1;
  py::object owner;
};

template <class T>
py::buffer_info info_of(const T* data, std::size_t size, std::size_t columns, bool read_only) {
  const auto rows = static_cast<py::ssize_t>(size / columns), width = static_cast<py::ssize_t>(columns);
  const auto item = static_cast<py::ssize_t>(sizeof(T));
  std::vector<py::ssize_t> shape{rows}, strides{width * item};
  if (columns > 1) {
    shape.push_back(width);
    strides.push_back(item);
  }
  return py::buffer_info(const_cast<T*>(data), item, py::format_descriptor<T>::format(),
                         static_cast<py::ssize_t>(shape.size()), shape, strides, read_only);
}

/// numpy, or None.
py::object numpy() {
  try {
    return py::module_::import("numpy");
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ImportError)) throw;
    return py::none();
  }
}

py::object shown(Block block) {
  py::object python = py::cast(std::move(block));
  const py::object np = numpy();
  return np.is_none() ? py::object(py::memoryview(python)) : py::object(np.attr("asarray")(python));
}

void collect(const py::handle& value, std::vector<double>& to) {
  if (py::hasattr(value, "tolist")) return collect(value.attr("tolist")(), to);
  if (PyNumber_Check(value.ptr())) {
    to.push_back(value.cast<double>());
    return;
  }
  if (!py::isinstance<py::iterable>(value) || py::isinstance<py::str>(value))
    throw py::type_error("expected an array of numbers");
  for (const py::handle element : value) collect(element, to);
}

}  // namespace

py::object array_of(std::vector<double> numbers, std::size_t columns) {
  return shown({std::move(numbers), columns, py::none()});
}
py::object view_of(std::span<const double> numbers, std::size_t columns, const py::object& owner) {
  return shown({numbers, columns, owner});
}
py::object view_of(std::span<const std::uint32_t> numbers, std::size_t columns, const py::object& owner) {
  return shown({numbers, columns, owner});
}

std::vector<double> numbers_of(const py::object& array) {
  if (py::isinstance<py::buffer>(array)) {
    const py::buffer_info info = py::reinterpret_borrow<py::buffer>(array).request();
    py::ssize_t expected = info.itemsize;
    bool dense = info.format == py::format_descriptor<double>::format();
    for (py::ssize_t d = info.ndim; d-- > 0; expected *= info.shape[static_cast<std::size_t>(d)])
      dense = dense && info.strides[static_cast<std::size_t>(d)] == expected;
    const auto* data = static_cast<const double*>(info.ptr);
    if (dense) return {data, data + info.size};
  }
  std::vector<double> numbers;
  collect(array, numbers);
  return numbers;
}

std::vector<std::uint32_t> indices_of(const py::object& array) {
  std::vector<std::uint32_t> indices;
  for (const double number : numbers_of(array)) {
    if (!(number >= 0 && number <= 4294967295.0 && number == std::floor(number)))
      throw py::value_error("expected indices from 0");
    indices.push_back(static_cast<std::uint32_t>(number));
  }
  return indices;
}

void define_arrays(py::module_& module) {
  py::class_<Block>(module, "_Block", py::buffer_protocol()).def_buffer([](Block& block) {
    return std::visit(
        [&](auto& numbers) {
          constexpr bool kOwned = std::is_same_v<std::decay_t<decltype(numbers)>, std::vector<double>>;
          return info_of(numbers.data(), numbers.size(), block.columns, !kOwned);
        },
        block.numbers);
  });
}

}  // namespace fascia::python

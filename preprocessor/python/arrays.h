// SPDX-License-Identifier: GPL-2.0-or-later
// NumPy arrays of the library's data, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <span>

#include "nanocarbon/core/cell.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Integers = pybind11::array_t<std::int64_t, pybind11::array::c_style | pybind11::array::forcecast>;

//! \name Views: they share memory with the owner, which they keep alive
//! @{
pybind11::array view_of(const std::vector<Vec3>& points, pybind11::handle owner, bool writable);
pybind11::array view_of_bonds(const std::vector<Bond>& bonds, pybind11::handle owner);
pybind11::array view_of_images(const std::vector<Bond>& bonds, pybind11::handle owner);
//! @}

template <typename Number>
pybind11::array_t<Number> copy_of(std::span<const Number> values) {
  return pybind11::array_t<Number>(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

//! \throw pybind11::value_error where the shape is not (N, 3) or a number is not finite
std::vector<Vec3> points_from(const Doubles& array);

//! 6 and 1.
std::vector<Element> elements_from(const Integers& numbers, std::size_t atoms);
pybind11::array_t<std::int64_t> numbers_of(std::span<const Element> elements);

//! Rows are the cell's edges, as in ASE. A left-handed cell has two edges swapped, which is the same lattice.
std::optional<Cell> cell_from(const std::optional<Doubles>& rows, std::array<bool, 3> periodic);
pybind11::object rows_of(const std::optional<Cell>& cell);

}  // namespace nanocarbon::python

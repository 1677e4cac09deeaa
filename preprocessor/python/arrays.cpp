// SPDX-License-Identifier: GPL-2.0-or-later
#include "arrays.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

namespace nanocarbon::python {
namespace {

namespace py = pybind11;

py::array locked(py::array array) {
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace

py::array view_of(const std::vector<Vec3>& points, py::handle owner, bool writable) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  py::array array(py::dtype::of<double>(), {static_cast<py::ssize_t>(points.size()), py::ssize_t{3}},
                  {static_cast<py::ssize_t>(sizeof(Vec3)), static_cast<py::ssize_t>(sizeof(double))},
                  points.empty() ? nullptr : points.front().data(), owner);
  return writable ? array : locked(array);
}

py::array view_of_bonds(const std::vector<Bond>& bonds, py::handle owner) {
  static_assert(offsetof(Bond, second) == offsetof(Bond, first) + sizeof(AtomIndex));
  return locked(
      py::array(py::dtype::of<AtomIndex>(), {static_cast<py::ssize_t>(bonds.size()), py::ssize_t{2}},
                {static_cast<py::ssize_t>(sizeof(Bond)), static_cast<py::ssize_t>(sizeof(AtomIndex))},
                bonds.empty() ? nullptr : &bonds.front().first, owner));
}

py::array view_of_images(const std::vector<Bond>& bonds, py::handle owner) {
  return locked(
      py::array(py::dtype::of<std::int32_t>(), {static_cast<py::ssize_t>(bonds.size()), py::ssize_t{3}},
                {static_cast<py::ssize_t>(sizeof(Bond)), static_cast<py::ssize_t>(sizeof(std::int32_t))},
                bonds.empty() ? nullptr : bonds.front().image.data(), owner));
}

std::vector<Vec3> points_from(const Doubles& array) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error("positions must have the shape (number of atoms, 3)");
  std::vector<Vec3> points(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    for (py::ssize_t d = 0; d < 3; ++d) {
      const double x = array.at(i, d);
      if (!std::isfinite(x)) throw py::value_error(fmt::format("the position of atom {} is not finite", i));
      points[static_cast<std::size_t>(i)][d] = x;
    }
  return points;
}

std::vector<Element> elements_from(const Integers& numbers, std::size_t atoms) {
  if (numbers.ndim() != 1 || static_cast<std::size_t>(numbers.shape(0)) != atoms)
    throw py::value_error("there must be one atomic number for each position");
  std::vector<Element> elements;
  elements.reserve(atoms);
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i) {
    const std::int64_t z = numbers.at(i);
    if (z != 6 && z != 1)
      throw py::value_error(
          fmt::format("atom {} has atomic number {}; only carbon (6) and hydrogen (1) are known", i, z));
    elements.push_back(z == 6 ? Element::carbon : Element::hydrogen);
  }
  return elements;
}

py::array_t<std::int64_t> numbers_of(std::span<const Element> elements) {
  py::array_t<std::int64_t> numbers(static_cast<py::ssize_t>(elements.size()));
  auto out = numbers.mutable_unchecked<1>();
  for (std::size_t i = 0; i < elements.size(); ++i)
    out(static_cast<py::ssize_t>(i)) = elements[i] == Element::carbon ? 6 : 1;
  return numbers;
}

std::optional<Cell> cell_from(const std::optional<Doubles>& rows, std::array<bool, 3> periodic) {
  if (!rows || !(periodic[0] || periodic[1] || periodic[2])) return std::nullopt;
  if (rows->ndim() != 2 || rows->shape(0) != 3 || rows->shape(1) != 3)
    throw py::value_error("a cell must have the shape (3, 3), an edge in each row");
  Cell cell{Mat3::Zero(), Vec3::Zero(), periodic};
  for (py::ssize_t k = 0; k < 3; ++k)
    for (py::ssize_t d = 0; d < 3; ++d) cell.vectors(d, k) = rows->at(k, d);
  const double volume = cell.vectors.determinant();
  if (!(std::abs(volume) > 1e-9)) throw py::value_error("the cell has no volume");
  if (volume < 0.0) {
    cell.vectors.col(0).swap(cell.vectors.col(1));
    std::swap(cell.periodic[0], cell.periodic[1]);
  }
  return cell;
}

py::object rows_of(const std::optional<Cell>& cell) {
  if (!cell) return py::none();
  py::array_t<double> rows({3, 3});
  auto out = rows.mutable_unchecked<2>();
  for (py::ssize_t k = 0; k < 3; ++k)
    for (py::ssize_t d = 0; d < 3; ++d) out(k, d) = cell->vectors(d, k);
  return rows;
}

}  // namespace nanocarbon::python

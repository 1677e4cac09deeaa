// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/cell_minimum.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace nanocarbon::minimisation {

namespace {

constexpr double strain_length = 1.4;  // Angstrom for the root of the number of atoms
// The reference of the strains is renewed this often at most; the second time there is hardly anything left.
constexpr int renewals = 4;
constexpr double small_strain = 1e-6;

// Orthonormal, along the periodic edges in their order.
std::vector<Vec3> periodic_axes(const Cell& cell) {
  std::vector<Vec3> axes;
  for (int d = 0; d < 3; ++d) {
    if (!cell.periodic[static_cast<std::size_t>(d)]) continue;
    Vec3 axis = cell.vectors.col(d);
    for (const Vec3& earlier : axes) axis -= axis.dot(earlier) * earlier;
    axes.push_back(axis.normalized());
  }
  return axes;
}

// The freed strains, orthonormal.
std::vector<Mat3> freed_strains(const Cell& cell, CellRelaxation relaxation) {
  const std::vector<Vec3> axes = periodic_axes(cell);
  std::vector<Mat3> strains;
  const auto alike = [&](std::size_t first, std::size_t last) {
    Mat3 sum = Mat3::Zero();
    for (std::size_t i = first; i < last; ++i) sum += axes[i] * axes[i].transpose();
    if (first < last) strains.push_back(sum / sum.norm());
  };
  if (relaxation == CellRelaxation::isotropic) alike(0, axes.size());
  if (relaxation == CellRelaxation::uniaxial) {
    const std::size_t across = axes.size() - (cell.periodic[2] ? 1 : 0);
    alike(0, across);
    alike(across, axes.size());
  }
  if (relaxation == CellRelaxation::orthogonal || relaxation == CellRelaxation::triclinic)
    for (const Vec3& axis : axes) strains.push_back(axis * axis.transpose());
  if (relaxation == CellRelaxation::triclinic)
    for (std::size_t i = 0; i < axes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Mat3 shear = axes[i] * axes[j].transpose();
        strains.push_back((shear + shear.transpose()) / std::sqrt(2.0));
      }
  return strains;
}

Cell strained(const Cell& cell, const Mat3& deformation) {
  Cell result = cell;
  result.vectors = deformation * cell.vectors;
  result.origin = deformation * cell.origin;
  return result;
}

// One minimisation, of positions and strains that start from none. Returns the deformation.
Mat3 relax_once(Molecule& molecule, potential::Potential& potential, const std::vector<Mat3>& strains,
                const MinimisationOptions& options, LbfgsResult& relaxed) {
  const std::size_t atoms = molecule.size();
  const double length = strain_length * std::sqrt(static_cast<double>(atoms));
  const Cell reference = *molecule.cell;
  const auto deformation_of = [&](std::span<const Vec3> variables) {
    Mat3 deformation = Mat3::Identity();
    for (std::size_t k = 0; k < strains.size(); ++k)
      deformation += variables[atoms + k / 3][static_cast<int>(k % 3)] / length * strains[k];
    return deformation;
  };
  std::vector<Vec3> placed(atoms);
  const auto energy = [&](std::span<const Vec3> variables, std::span<Vec3> gradient) {
    const Mat3 deformation = deformation_of(variables);
    for (std::size_t a = 0; a < atoms; ++a) placed[a] = deformation * variables[a];
    const Cell cell = strained(reference, deformation);
    const potential::Evaluation& result = potential.evaluate(placed, molecule.elements, &cell, {});
    for (std::size_t a = 0; a < atoms; ++a) gradient[a] -= deformation.transpose() * result.forces[a];
    const Mat3 by_deformation = -result.virial.transpose() * deformation.inverse().transpose();
    for (std::size_t k = 0; k < strains.size(); ++k)
      gradient[atoms + k / 3][static_cast<int>(k % 3)] +=
          by_deformation.cwiseProduct(strains[k]).sum() / length;
    return result.energy;
  };
  std::vector<Vec3> variables = molecule.positions;
  variables.resize(atoms + (strains.size() + 2) / 3, Vec3::Zero());
  relaxed =
      minimise_lbfgs(variables, energy,
                     {.max_iterations = options.max_iterations, .force_tolerance = options.force_tolerance});
  const Mat3 deformation = deformation_of(variables);
  for (std::size_t a = 0; a < atoms; ++a) molecule.positions[a] = deformation * variables[a];
  molecule.cell = strained(reference, deformation);
  return deformation;
}

}  // namespace

std::string_view name(CellRelaxation relaxation) {
  switch (relaxation) {
    case CellRelaxation::none:
      return "none";
    case CellRelaxation::isotropic:
      return "isotropic";
    case CellRelaxation::uniaxial:
      return "uniaxial";
    case CellRelaxation::orthogonal:
      return "orthogonal";
    case CellRelaxation::triclinic:
      return "triclinic";
  }
  return "";
}

CellMinimum minimise_in_cell(Molecule& molecule, potential::Potential& potential, CellRelaxation relaxation,
                             const MinimisationOptions& options) {
  CellMinimum result;
  if (!molecule.cell) {
    result.minimum = minimise_molecule(molecule, potential, options);
    return result;
  }
  int iterations = 0;
  if (relaxation != CellRelaxation::none)
    for (int round = 0; round < renewals; ++round) {
      LbfgsResult relaxed;
      const Mat3 step =
          relax_once(molecule, potential, freed_strains(*molecule.cell, relaxation), options, relaxed);
      result.deformation = step * result.deformation;
      iterations += relaxed.iterations;
      if (relaxed.converged && (step - Mat3::Identity()).norm() < small_strain) break;
    }
  result.minimum = minimise_molecule(molecule, potential, options);
  result.minimum.iterations += iterations;
  const potential::Evaluation& end =
      potential.evaluate(molecule.positions, molecule.elements, &*molecule.cell, {});
  result.stress = -end.virial / volume(*molecule.cell);
  return result;
}

}  // namespace nanocarbon::minimisation

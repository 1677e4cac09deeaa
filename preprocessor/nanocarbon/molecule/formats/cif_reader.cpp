// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/cif_reader.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <exception>
#include <gemmi/cif.hpp>
#include <gemmi/numb.hpp>
#include <gemmi/symmetry.hpp>
#include <initializer_list>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/space.h"

namespace nanocarbon::molecule {
namespace {

namespace cif = gemmi::cif;

//! A block, and where errors in it are.
struct Block {
  cif::Block& data;
  const TextInput& input;

  [[noreturn]] void fail(const std::string& message, Failure failure = Failure::malformed) const {
    throw UserError(failure,
                    fmt::format("{}: in block data_{}: {}", input.name(), shown(data.name), message));
  }
  //! The value of the first of these tags that is there, unquoted; empty for none, `?` and `.`.
  std::string value(std::initializer_list<const char*> tags) const {
    for (const char* tag : tags)
      if (const std::string* found = data.find_value(tag); found != nullptr && !cif::is_null(*found))
        return cif::as_string(*found);
    return {};
  }
  double number(const std::string& text, const std::string& what) const {
    const double value = cif::as_number(text);
    if (!std::isfinite(value) || std::abs(value) > 1e6)
      fail(fmt::format("{} must be a number, found '{}'", what, shown(text)));
    return value;
  }
};

// a along x, b in the xy plane.
Cell cell_of(const Block& block) {
  double length[3], angle[3];
  const char* lengths[] = {"_cell_length_a", "_cell_length_b", "_cell_length_c"};
  const char* angles[] = {"_cell_angle_alpha", "_cell_angle_beta", "_cell_angle_gamma"};
  for (int d = 0; d < 3; ++d) {
    length[d] = block.number(block.value({lengths[d]}), lengths[d]);
    angle[d] = block.number(block.value({angles[d]}), angles[d]);
    if (!(length[d] > 0.0)) block.fail(fmt::format("{} must be above zero", lengths[d]));
    if (!(angle[d] > 0.0 && angle[d] < 180.0))
      block.fail(fmt::format("{} must be between 0 and 180", angles[d]));
  }
  // Cosines of right angles are to be zero, not 6e-17.
  const auto cosine = [](double degrees) {
    return degrees == 90.0 ? 0.0 : std::cos(degrees * std::numbers::pi / 180.0);
  };
  const double alpha = cosine(angle[0]), beta = cosine(angle[1]), gamma = cosine(angle[2]);
  const double sine = std::sqrt(1.0 - gamma * gamma);
  const double cy = (alpha - beta * gamma) / sine, cz_squared = 1.0 - beta * beta - cy * cy;
  if (!(cz_squared > 1e-9)) block.fail("the angles of the cell do not span a volume");
  Cell cell;
  cell.vectors << length[0], length[1] * gamma, length[2] * beta, 0.0, length[1] * sine, length[2] * cy, 0.0,
      0.0, length[2] * std::sqrt(cz_squared);
  return cell;
}

using Operation = gemmi::Op;

Operation operation_of(const Block& block, const std::string& text) {
  const bool plausible =
      text.size() < 80 && text.find_first_not_of("xyzXYZ0123456789+-*/,. ") == std::string::npos;
  std::size_t digits = 0, longest = 0;
  for (const char c : text) longest = std::max(longest, digits = c >= '0' && c <= '9' ? digits + 1 : 0);
  if (plausible && longest < 6) {
    try {
      return gemmi::parse_triplet(text);
    } catch (const std::exception&) {  // said below
    }
  }
  block.fail(fmt::format("'{}' is not a symmetry operation (such as x, y+1/2, -z)", shown(text)));
}

std::vector<Operation> operations_of(const Block& block, std::vector<std::string>& warnings) {
  std::vector<Operation> operations;
  for (const char* tag : {"_space_group_symop_operation_xyz", "_symmetry_equiv_pos_as_xyz",
                          "_space_group_symop.operation_xyz"}) {
    for (const std::string& text : block.data.find_values(tag))
      operations.push_back(operation_of(block, cif::as_string(text)));
    if (operations.size() > 192)
      block.fail("it lists more than 192 symmetry operations, the most that a group has");
    if (!operations.empty()) return operations;
  }
  const auto all = [](const gemmi::GroupOps& group) {
    std::vector<Operation> listed;
    for (const Operation op : group) listed.push_back(op);
    return listed;
  };
  const std::string hall = block.value({"_space_group_name_Hall", "_symmetry_space_group_name_Hall"});
  const std::string name = block.value({"_space_group_name_H-M_alt", "_symmetry_space_group_name_H-M"});
  try {
    if (!hall.empty()) return all(gemmi::symops_from_hall(hall.c_str()));
    if (const gemmi::SpaceGroup* group = name.empty() ? nullptr : gemmi::find_spacegroup_by_name(name))
      return all(group->operations());
  } catch (const std::exception&) {  // said below
  }
  if (!hall.empty() || !name.empty())
    block.fail(fmt::format("the space group '{}' is not known, and its operations are not listed",
                           shown(hall.empty() ? name : hall)),
               Failure::unsuitable);
  if (!block.value({"_space_group_IT_number", "_symmetry_Int_Tables_number"}).empty() &&
      block.value({"_space_group_IT_number", "_symmetry_Int_Tables_number"}) != "1")
    block.fail(
        "the space group is given by its number alone, which leaves its setting open; list its operations "
        "(_space_group_symop_operation_xyz)",
        Failure::unsuitable);
  if (block.value({"_space_group_IT_number", "_symmetry_Int_Tables_number"}).empty())
    warnings.push_back(
        fmt::format("block data_{} does not give its symmetry; the atoms listed are taken to be all of them",
                    shown(block.data.name)));
  return {Operation::identity()};
}

struct Site {
  std::string label;
  Element element;
  Vec3 fraction;
};

std::vector<Site> sites_of(const Block& block, const Cell& cell, ReadSettings& settings) {
  enum Tag { x, y, z, label, symbol, occupancy, calc_flag };
  const bool fractions = static_cast<bool>(block.data.find_values("_atom_site_fract_x"));
  const std::string prefix = fractions ? "fract_" : "Cartn_";
  cif::Table table = block.data.find("_atom_site_", {prefix + "x", prefix + "y", prefix + "z", "?label",
                                                     "?type_symbol", "?occupancy", "?calc_flag"});
  if (!table.ok()) block.fail("the atoms need three coordinates (_atom_site_fract_x, y, z)");
  if (!table.has_column(label) && !table.has_column(symbol))
    block.fail("the atoms have no labels (_atom_site_label)");
  const Mat3 to_fraction = cell.vectors.inverse();
  SpeciesReader species(settings.types);
  std::vector<Site> sites;
  for (const auto row : table) {
    Site site;
    site.label = table.has_column(label) ? cif::as_string(row[label]) : cif::as_string(row[symbol]);
    const std::string what = fmt::format("atom '{}'", shown(site.label));
    const auto coordinate = [&](int tag) { return block.number(row[tag], "a coordinate of " + what); };
    if (table.has_column(occupancy) && !cif::is_null(row[occupancy]) &&
        std::abs(block.number(row[occupancy], "the occupancy of " + what) - 1.0) > 1e-6)
      block.fail(
          fmt::format("{} has the occupancy {}: the structure is disordered; keep one of the alternatives",
                      what, shown(row[occupancy])),
          Failure::unsuitable);
    if (table.has_column(calc_flag) && lower_case(cif::as_string(row[calc_flag])) == "dum") continue;
    const Vec3 position(coordinate(x), coordinate(y), coordinate(z));
    site.fraction = fractions ? position : Vec3(to_fraction * position);
    const bool has_symbol = table.has_column(symbol) && !cif::is_null(row[symbol]);
    site.element = species.of_name(block.input, has_symbol ? cif::as_string(row[symbol]) : site.label);
    sites.push_back(std::move(site));
  }
  return sites;
}

void add_images(const Site& site, const std::vector<Operation>& operations, const Space& space,
                const Cell& cell, Molecule& molecule) {
  constexpr double special = 0.3;  // Angstrom: coordinates are rounded, and no two atoms are that close
  const std::size_t first = molecule.size();
  for (const Operation& op : operations) {
    const auto image = op.apply_to_xyz({site.fraction[0], site.fraction[1], site.fraction[2]});
    Vec3 fraction(image[0], image[1], image[2]);
    if (!(op == Operation::identity())) fraction -= Vec3(fraction.array().floor());
    const Vec3 position = cell.vectors * fraction;
    bool known = false;
    for (std::size_t k = first; k < molecule.size() && !known; ++k)
      known = space.displacement(molecule.positions[k], position).norm() < special;
    if (known) continue;
    molecule.positions.push_back(position);
    molecule.elements.push_back(site.element);
  }
}

MoleculeFrame frame_of(const Block& block, ReadSettings& settings) {
  MoleculeFrame frame;
  const Cell cell = cell_of(block);
  const std::vector<Operation> operations = operations_of(block, frame.warnings);
  const std::vector<Site> sites = sites_of(block, cell, settings);
  if (sites.size() * operations.size() > 50'000'000) block.fail("it has too many atoms");
  const Space space(cell);
  for (const Site& site : sites) add_images(site, operations, space, cell, frame.molecule);
  for (std::size_t i = 0; i < frame.molecule.size(); ++i)
    frame.ids.push_back(static_cast<std::int64_t>(i) + 1);
  frame.molecule.cell = cell_as_read(block.input, cell, settings);
  return frame;
}

}  // namespace

std::vector<MoleculeFrame> read_cif(TextInput& input, ReadSettings& settings) {
  const std::string text = input.rest(std::size_t{256} << 20);
  cif::Document document;
  try {
    document = cif::read_memory(text.data(), text.size(), input.name().c_str());
  } catch (const std::exception& error) {
    throw UserError(Failure::malformed, fmt::format("{} (CIF)", shown(error.what(), 300)));
  }
  std::vector<MoleculeFrame> frames;
  for (cif::Block& block : document.blocks) {
    const auto has = [&](const char* tag) { return static_cast<bool>(block.find_values(tag)); };
    if (has("_atom_site.id") || has("_atom_site.label_atom_id"))
      throw UserError(
          Failure::malformed,
          fmt::format("{}: it is an mmCIF file of macromolecules; convert it to XYZ", input.name()));
    if (has("_atom_site_fract_x") || has("_atom_site_Cartn_x"))
      frames.push_back(frame_of({block, input}, settings));
  }
  if (frames.empty())
    throw UserError(Failure::malformed,
                    fmt::format("{}: no block has atoms (_atom_site_fract_x)", input.name()));
  return frames;
}

}  // namespace nanocarbon::molecule

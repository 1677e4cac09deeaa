// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/cif_reader.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <exception>
#include <gemmi/symmetry.hpp>
#include <initializer_list>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/space.h"
#include "nanocarbon/molecule/formats/cif_document.h"

namespace nanocarbon::molecule {
namespace {

//! A block, and where errors in it are.
struct Block {
  const CifBlock& data;
  const TextInput& input;

  [[noreturn]] void fail(const std::string& message, Failure failure = Failure::malformed) const {
    throw UserError(failure,
                    fmt::format("{}: in block data_{}: {}", input.name(), shown(data.name), message));
  }
  bool has(const char* tag) const { return data.table_with(tag) != nullptr; }
  //! The value of the first of these tags that has one; else empty.
  std::string value(std::initializer_list<const char*> tags) const {
    for (const char* tag : tags)
      if (std::string found = data.value(tag); !found.empty()) return found;
    return {};
  }
  double number(const std::string& text, const std::string& what) const {
    const double value = cif_number(text);
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

// Whether each part of a Hall symbol with a screw axis says along which axis it is, as the first one need not. Where it
// does not, gemmi::symops_from_hall() (0.5.7) writes beside an array.
bool screws_have_axes(std::string_view hall) {
  constexpr std::string_view blanks = " \t_";
  hall = hall.substr(0, hall.find('('));
  const std::size_t lattice = hall.find_first_not_of(" \t-");
  if (lattice == std::string_view::npos) return false;
  hall.remove_prefix(lattice + 1);
  for (bool first = true;; first = false) {
    const std::size_t begin = hall.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return true;
    std::string_view part = hall.substr(begin);
    part = part.substr(0, part.find_first_of(blanks));
    hall.remove_prefix(begin + part.size());
    if (part.front() == '-') part.remove_prefix(1);
    const bool is_screw = part.find_first_of("12345", 1) != std::string_view::npos;
    const bool is_diagonal = part.find_first_of("'\"*") != std::string_view::npos;
    const bool has_axis = part.find_first_of("xyz") != std::string_view::npos || (first && !is_diagonal);
    if (is_screw && !has_axis) return false;
  }
}

std::vector<Operation> operations_of(const Block& block, std::vector<std::string>& warnings) {
  std::vector<Operation> operations;
  for (const char* tag : {"_space_group_symop_operation_xyz", "_symmetry_equiv_pos_as_xyz",
                          "_space_group_symop.operation_xyz"}) {
    const CifTable* table = block.data.table_with(tag);
    for (std::size_t row = 0; table != nullptr && row < table->rows(); ++row)
      operations.push_back(operation_of(block, table->at(row, *table->column(tag))));
    if (operations.size() > 192)
      block.fail("it lists more than 192 symmetry operations, the most that a group has");
    if (!operations.empty()) return operations;
  }
  const auto all = [](const gemmi::GroupOps& group) {
    std::vector<Operation> listed;
    for (const Operation op : group) listed.push_back(op);
    return listed;
  };
  const std::string hall = block.value({"_space_group_name_hall", "_symmetry_space_group_name_hall"});
  const std::string name = block.value({"_space_group_name_h-m_alt", "_symmetry_space_group_name_h-m"});
  bool origin_is_open = false;
  try {
    if (!hall.empty() && !screws_have_axes(hall)) throw std::invalid_argument("no axis");
    if (!hall.empty()) return all(gemmi::symops_from_hall(hall.c_str()));
    const bool is_number = name.find_first_not_of("0123456789 ") == std::string::npos;
    const double alpha = cif_number(block.value({"_cell_angle_alpha"})),
                 gamma =
                     cif_number(block.value({"_cell_angle_gamma"}));  // tell hexagonal axes from rhombohedral
    const gemmi::SpaceGroup* group = is_number ? nullptr : gemmi::find_spacegroup_by_name(name, alpha, gamma);
    if (group != nullptr && group->ext == '1' && name.find(':') == std::string::npos) origin_is_open = true;
    if (group != nullptr && !origin_is_open) return all(group->operations());
  } catch (const std::exception&) {  // said below
  }
  if (origin_is_open)
    block.fail(fmt::format("the space group '{}' has two origins in use; list its operations "
                           "(_space_group_symop_operation_xyz), or write '{} :1' or '{} :2'",
                           shown(name), shown(name), shown(name)),
               Failure::unsuitable);
  if (!hall.empty() || !name.empty())
    block.fail(fmt::format("the space group '{}' is not known, and its operations are not listed",
                           shown(hall.empty() ? name : hall)),
               Failure::unsuitable);
  if (!block.value({"_space_group_it_number", "_symmetry_int_tables_number"}).empty() &&
      block.value({"_space_group_it_number", "_symmetry_int_tables_number"}) != "1")
    block.fail(
        "the space group is given by its number alone, which leaves its setting open; list its operations "
        "(_space_group_symop_operation_xyz)",
        Failure::unsuitable);
  if (block.value({"_space_group_it_number", "_symmetry_int_tables_number"}).empty())
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
  const bool fractions = block.has("_atom_site_fract_x");
  const std::string first = fractions ? "_atom_site_fract_x" : "_atom_site_cartn_x";
  const CifTable& table = *block.data.table_with(first);
  const auto x = table.column(first), y = table.column(first.substr(0, first.size() - 1) + "y"),
             z = table.column(first.substr(0, first.size() - 1) + "z");
  if (!y || !z) block.fail("the atoms need three coordinates (_atom_site_fract_x, y, z)");
  const auto label = table.column("_atom_site_label"), symbol = table.column("_atom_site_type_symbol");
  if (!label && !symbol) block.fail("the atoms have no labels (_atom_site_label)");
  const auto occupancy = table.column("_atom_site_occupancy"), flag = table.column("_atom_site_calc_flag");
  const Mat3 to_fraction = cell.vectors.inverse();
  SpeciesReader species(settings.types);
  std::vector<Site> sites;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = [&](std::optional<std::size_t> column) {
      return column ? table.at(row, *column) : std::string();
    };
    Site site;
    site.label = label ? value(label) : value(symbol);
    const std::string what = fmt::format("atom '{}'", shown(site.label));
    const std::string occupied = value(occupancy);
    if (!occupied.empty() && std::abs(block.number(occupied, "the occupancy of " + what) - 1.0) > 1e-6)
      block.fail(
          fmt::format("{} has the occupancy {}: the structure is disordered; keep one of the alternatives",
                      what, shown(occupied)),
          Failure::unsuitable);
    if (lower_case(value(flag)) == "dum") continue;
    const auto coordinate = [&](std::optional<std::size_t> column) {
      return block.number(value(column), "a coordinate of " + what);
    };
    const Vec3 position(coordinate(x), coordinate(y), coordinate(z));
    site.fraction = fractions ? position : Vec3(to_fraction * position);
    const std::string element = value(symbol);
    site.element = species.of_name(block.input, element.empty() ? site.label : element);
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
  frame.has_ids = false;
  frame.molecule.cell = cell_as_read(block.input, cell, settings);
  return frame;
}

}  // namespace

std::vector<MoleculeFrame> read_cif(TextInput& input, ReadSettings& settings) {
  const std::string text = input.rest(std::size_t{256} << 20);
  std::vector<CifBlock> blocks;
  try {
    blocks = parse_cif(text, input.name());
  } catch (const std::exception& error) {
    throw UserError(Failure::malformed, fmt::format("{} (CIF)", shown(error.what(), 300)));
  }
  std::vector<MoleculeFrame> frames;
  for (const CifBlock& data : blocks) {
    const Block block{data, input};
    if (block.has("_atom_site.id") || block.has("_atom_site.label_atom_id"))
      throw UserError(
          Failure::malformed,
          fmt::format("{}: it is an mmCIF file of macromolecules; convert it to XYZ", input.name()));
    if (block.has("_atom_site_fract_x") || block.has("_atom_site_cartn_x"))
      frames.push_back(frame_of(block, settings));
  }
  if (frames.empty())
    throw UserError(Failure::malformed,
                    fmt::format("{}: no block has atoms (_atom_site_fract_x)", input.name()));
  return frames;
}

}  // namespace nanocarbon::molecule

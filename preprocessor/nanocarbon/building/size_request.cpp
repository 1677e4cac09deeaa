// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/size_request.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/repair/drop_specks.h"

namespace nanocarbon::building {
namespace {

// Both recipes need more than this at their peak, which is enough to refuse what cannot end well: a machine
// that runs out of memory does so after hours, and may take other programs with it.
constexpr double least_bytes_per_atom = 400.0;

double bytes_of_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct ScaleOf {
  const TriangleMesh& surface;
  double surface_area;     // square mesh units
  double area_of_an_atom;  // square Angstrom

  double for_atoms(std::size_t atoms) const {
    return std::sqrt(static_cast<double>(atoms) * area_of_an_atom / surface_area);
  }
  double operator()(AtomPerTriangle) const { return for_atoms(surface.triangles.size()); }
  double operator()(AtomCount request) const { return for_atoms(request.atoms); }
  double operator()(LongestSide request) const { return request.length / longest_side(); }
  // In a cell that of its longest periodic edge: the length that the molecule repeats itself by.
  double longest_side() const {
    const Cell* cell = surface.space.cell();
    if (!cell) return mesh::bounding_box(surface.points).longest_side();
    double longest = 0.0;
    for (int d = 0; d < 3; ++d)
      if (cell->periodic[static_cast<std::size_t>(d)])
        longest = std::max(longest, cell->vectors.col(d).norm());
    return longest;
  }
  double operator()(UnitScale request) const { return request.scale; }
};

}  // namespace

bool keeps_size(const SizeRequest& request) {
  return std::holds_alternative<LongestSide>(request) || std::holds_alternative<UnitScale>(request);
}

double area_per_atom(double bond_length) { return 0.75 * std::sqrt(3.0) * bond_length * bond_length; }

SizedSurface sized_surface(const TriangleMesh& surface, const SizeRequest& request, double bond_length) {
  const double surface_area = mesh::area(surface);
  if (!(surface_area > 0.0) || !std::isfinite(surface_area))
    throw UserError(Failure::unsuitable, "the surface has no area: all its triangles are degenerate");
  const ScaleOf scale_of{surface, surface_area, area_per_atom(bond_length)};

  SizedSurface sized{surface, std::visit(scale_of, request), 0};
  const double atoms = surface_area * sized.scale * sized.scale / scale_of.area_of_an_atom;
  if (!(atoms < 4e9))
    throw UserError(
        Failure::size,
        fmt::format("the size asked for needs about {:.3g} atoms, more than this program can number; "
                    "ask for less with --atoms, --length or --scale",
                    atoms));
  if (atoms * least_bytes_per_atom > bytes_of_memory())
    throw UserError(
        Failure::size,
        fmt::format("the size asked for needs about {:.3g} atoms and {:.3g} GB of memory, and this "
                    "machine has {:.3g} GB; ask for less with --atoms, --length or --scale",
                    atoms, 1e-9 * atoms * least_bytes_per_atom, 1e-9 * bytes_of_memory()));
  sized.atoms = static_cast<std::size_t>(std::llround(atoms));
  if (sized.atoms < smallest_cage)
    throw UserError(
        Failure::size,
        fmt::format("the size asked for leaves room for {} atom(s), and no cage has fewer than {}; "
                    "ask for more with --atoms N, --length {:.3g} or --scale {:.3g}",
                    sized.atoms, smallest_cage, scale_of.longest_side() * scale_of.for_atoms(smallest_cage),
                    scale_of.for_atoms(smallest_cage)));
  rescale(sized.mesh, sized.scale);
  return sized;
}

SizedSurface sized_without_specks(const TriangleMesh& surface, const SizeRequest& request, double bond_length,
                                  bool drop, std::size_t& dropped) {
  dropped = 0;
  TriangleMesh rest = surface;
  // An atom for each triangle means those of the file.
  const SizeRequest meant =
      std::holds_alternative<AtomPerTriangle>(request) ? AtomCount{surface.triangles.size()} : request;
  for (;;) {
    SizedSurface sized = sized_surface(rest, meant, bond_length);
    const double least = static_cast<double>(smallest_cage) * area_per_atom(bond_length);
    const std::vector<double> areas = mesh::component_areas(sized.mesh);
    const auto specks = static_cast<std::size_t>(
        std::count_if(areas.begin(), areas.end(), [&](double a) { return a < least; }));
    if (specks == 0 || areas.size() == 1) return sized;
    double largest = 0;
    for (const double a : areas)
      if (a < least) largest = std::max(largest, a / area_per_atom(bond_length));
    if (specks == areas.size())
      throw UserError(
          Failure::size,
          fmt::format("all {} pieces are specks: the largest has room for {:.2g} atoms, and no cage has "
                      "fewer than {}; ask for more atoms",
                      specks, largest, smallest_cage));
    if (!drop)
      throw UserError(
          Failure::size,
          fmt::format("{} of {} pieces are specks: with {} atoms in all, the largest of them has room for "
                      "{:.2g}, and no cage has fewer than {}; leave them out with --drop-specks",
                      specks, areas.size(), sized.atoms, largest, smallest_cage));
    const std::size_t left_out = mesh::drop_specks(rest, least / (sized.scale * sized.scale));
    if (left_out == 0) return sized;  // it lacks no more than rounding
    dropped += left_out;
  }
}

}  // namespace nanocarbon::building

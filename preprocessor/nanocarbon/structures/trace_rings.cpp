#include "nanocarbon/structures/trace_rings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace nanocarbon {
namespace {

//! A bond seen from one of its ends.
struct HalfBond {
  AtomIndex to;
  std::uint32_t reverse;  // index of the same bond seen from the other end
  Vec3 vector;            // Angstrom
  double angle;           // around the atom's normal
};

struct OrderedNeighbours {
  std::vector<std::uint32_t> start;  // row of each atom, counter-clockwise around its normal
  std::vector<HalfBond> half_bonds;

  //! The half-bond at the same atom that follows (+1) or precedes (-1) this one counter-clockwise.
  std::uint32_t turn(AtomIndex atom, std::uint32_t half_bond, int direction) const {
    const std::uint32_t count = start[atom + 1] - start[atom];
    return start[atom] + (half_bond - start[atom] + (direction > 0 ? 1 : count - 1)) % count;
  }
};

OrderedNeighbours order_neighbours(const Molecule& molecule, std::span<const Vec3> normals) {
  const std::size_t n = molecule.size();
  OrderedNeighbours ordered;
  ordered.start.assign(n + 1, 0);
  for (const Bond& b : molecule.bonds) ++ordered.start[b.first + 1], ++ordered.start[b.second + 1];
  for (std::size_t i = 0; i < n; ++i) ordered.start[i + 1] += ordered.start[i];

  struct End {
    std::uint32_t bond;
    HalfBond half;
  };
  std::vector<End> ends(ordered.start[n]);
  std::vector<std::uint32_t> fill(ordered.start.begin(), ordered.start.end() - 1);
  for (std::uint32_t b = 0; b < molecule.bonds.size(); ++b) {
    const Bond& bond = molecule.bonds[b];
    Vec3 vector = molecule.positions[bond.second] - molecule.positions[bond.first];
    if (molecule.cell) vector += image_shift(*molecule.cell, bond.image);
    ends[fill[bond.first]++] = {2 * b, {bond.second, 0, vector, 0.0}};
    ends[fill[bond.second]++] = {2 * b + 1, {bond.first, 0, -vector, 0.0}};
  }

  std::vector<std::uint32_t> place(ends.size());  // of end 2 b or 2 b + 1 of bond b
  for (std::size_t i = 0; i < n; ++i) {
    const auto first = ends.begin() + ordered.start[i], last = ends.begin() + ordered.start[i + 1];
    const Vec3 x = normals[i].unitOrthogonal(), y = normals[i].normalized().cross(x);
    for (auto end = first; end != last; ++end)
      end->half.angle = std::atan2(end->half.vector.dot(y), end->half.vector.dot(x));
    std::sort(first, last, [](const End& a, const End& b) { return a.half.angle < b.half.angle; });
    for (auto end = first; end != last; ++end)
      place[end->bond] = static_cast<std::uint32_t>(end - ends.begin());
  }
  ordered.half_bonds.reserve(ends.size());
  for (const End& end : ends) {
    ordered.half_bonds.push_back(end.half);
    ordered.half_bonds.back().reverse = place[end.bond ^ 1u];
  }
  return ordered;
}

}  // namespace

Rings trace_rings(const Molecule& molecule, std::span<const Vec3> normals, std::size_t largest) {
  const OrderedNeighbours ordered = order_neighbours(molecule, normals);
  // A corner is the sector between a half-bond and the next one counter-clockwise; each belongs to one walk.
  std::vector<bool> corner_done(ordered.half_bonds.size(), false);

  Rings rings;
  std::vector<AtomIndex> ring;
  for (AtomIndex origin = 0; origin < molecule.size(); ++origin)
    for (std::uint32_t corner = ordered.start[origin]; corner < ordered.start[origin + 1]; ++corner) {
      if (corner_done[corner]) continue;
      ring.clear();
      Vec3 point = Vec3::Zero(), area = Vec3::Zero(), normal = Vec3::Zero();
      AtomIndex atom = origin;
      std::uint32_t out = corner, at_corner = corner;
      int side = 1;
      do {
        corner_done[at_corner] = true;
        ring.push_back(atom);
        normal += side * normals[atom];
        const HalfBond& half = ordered.half_bonds[out];
        area += 0.5 * point.cross(point + half.vector);
        point += half.vector;
        if (normals[atom].dot(normals[half.to]) < 0.0) side = -side;
        atom = half.to;
        // The face lies to the left: leave by the half-bond next to the one we came by, clockwise seen from
        // our side.
        out = ordered.turn(atom, half.reverse, -side);
        at_corner = side > 0 ? out : half.reverse;
      } while (!corner_done[at_corner]);
      if (ring.size() > largest || area.dot(normal) <= 0.0) continue;
      rings.atoms.insert(rings.atoms.end(), ring.begin(), ring.end());
      rings.offsets.push_back(static_cast<std::uint32_t>(rings.atoms.size()));
    }
  return rings;
}

}  // namespace nanocarbon

#include "nanocarbon/structures/sheet_normals.h"

#include <Eigen/Geometry>

namespace nanocarbon {
namespace {

struct Partner {
  AtomIndex atom;
  Vec3 vector;  // Angstrom
};

}  // namespace

std::vector<Vec3> sheet_normals(const Molecule& molecule) {
  std::vector<std::vector<Partner>> partners(molecule.size());
  for (const Bond& bond : molecule.bonds) {
    Vec3 vector = molecule.positions[bond.second] - molecule.positions[bond.first];
    if (molecule.cell) vector += image_shift(*molecule.cell, bond.image);
    partners[bond.first].push_back({bond.second, vector});
    partners[bond.second].push_back({bond.first, -vector});
  }
  const auto own_normal = [&](AtomIndex atom) -> Vec3 {
    const auto& p = partners[atom];
    if (p.size() < 3) return Vec3::Zero();
    return (p[1].vector - p[0].vector).cross(p[2].vector - p[0].vector).normalized();
  };

  std::vector<Vec3> normals(molecule.size(), Vec3::Zero());
  std::vector<AtomIndex> front;
  const auto spread = [&] {
    for (std::size_t next = 0; next < front.size(); ++next) {
      const Vec3& known = normals[front[next]];
      for (const Partner& partner : partners[front[next]]) {
        Vec3& normal = normals[partner.atom];
        if (!normal.isZero(0.0)) continue;
        normal = own_normal(partner.atom);
        if (normal.isZero(0.0)) normal = known;
        if (normal.dot(known) < 0.0) normal = -normal;
        front.push_back(partner.atom);
      }
    }
    front.clear();
  };
  for (AtomIndex seed = 0; seed < molecule.size(); ++seed) {
    if (!normals[seed].isZero(0.0) || own_normal(seed).isZero(0.0)) continue;
    normals[seed] = own_normal(seed);
    front.push_back(seed);
    spread();
  }
  for (Vec3& normal : normals)
    if (normal.isZero(0.0)) normal = Vec3::UnitZ();
  return normals;
}

}  // namespace nanocarbon

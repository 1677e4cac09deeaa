// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/hydrocarbons.h"

#include <cmath>
#include <numbers>

#include "nanocarbon/structures/close_bonds.h"

namespace nanocarbon::structures {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

class Builder {
 public:
  Builder& carbon(double x, double y, double z) { return add(Element::carbon, {x, y, z}); }
  Builder& hydrogen(double x, double y, double z) { return add(Element::hydrogen, {x, y, z}); }

  //! In all these molecules bonds are shorter than 1.6 and everything else is further apart than 1.7
  //! Angstrom.
  Molecule bonded() {
    add_bonds(molecule_);
    return std::move(molecule_);
  }

 private:
  Builder& add(Element element, const Vec3& position) {
    molecule_.elements.push_back(element);
    molecule_.positions.push_back(position);
    return *this;
  }
  Molecule molecule_;
};

}  // namespace

Molecule methane() {
  const double h = 1.09 / std::numbers::sqrt3;
  return Builder()
      .carbon(0, 0, 0)
      .hydrogen(h, h, h)
      .hydrogen(-h, -h, h)
      .hydrogen(-h, h, -h)
      .hydrogen(h, -h, -h)
      .bonded();
}

Molecule methyl_radical() {
  Builder builder;
  builder.carbon(0, 0, 0);
  for (int i = 0; i < 3; ++i)
    builder.hydrogen(1.08 * std::cos(120 * degree * i), 1.08 * std::sin(120 * degree * i), 0);
  return builder.bonded();
}

Molecule acetylene() {
  return Builder().carbon(-0.60, 0, 0).carbon(0.60, 0, 0).hydrogen(-1.66, 0, 0).hydrogen(1.66, 0, 0).bonded();
}

Molecule ethynyl_radical() {
  return Builder().carbon(-0.60, 0, 0).carbon(0.60, 0, 0).hydrogen(1.66, 0, 0).bonded();
}

Molecule ethylene() {
  const double along = 0.665 + 1.087 * std::cos(58.6 * degree), across = 1.087 * std::sin(58.6 * degree);
  return Builder()
      .carbon(-0.665, 0, 0)
      .carbon(0.665, 0, 0)
      .hydrogen(along, across, 0)
      .hydrogen(along, -across, 0)
      .hydrogen(-along, across, 0)
      .hydrogen(-along, -across, 0)
      .bonded();
}

Molecule ethane() {
  Builder builder;
  builder.carbon(-0.765, 0, 0).carbon(0.765, 0, 0);
  const double along = 0.765 + 1.09 * std::cos(68.8 * degree), across = 1.09 * std::sin(68.8 * degree);
  for (int i = 0; i < 3; ++i) {
    builder.hydrogen(along, across * std::cos(120 * degree * i), across * std::sin(120 * degree * i));
    // Staggered: the other end is turned by 60 degrees.
    builder.hydrogen(-along, -across * std::cos(120 * degree * i), -across * std::sin(120 * degree * i));
  }
  return builder.bonded();
}

Molecule cyclopropane() {
  Builder builder;
  const double carbon_radius = 1.51 / std::numbers::sqrt3;
  const double out = carbon_radius + 1.08 * std::cos(57.5 * degree), up = 1.08 * std::sin(57.5 * degree);
  for (int i = 0; i < 3; ++i) {
    const double x = std::cos(120 * degree * i), y = std::sin(120 * degree * i);
    builder.carbon(carbon_radius * x, carbon_radius * y, 0)
        .hydrogen(out * x, out * y, up)
        .hydrogen(out * x, out * y, -up);
  }
  return builder.bonded();
}

Molecule benzene() {
  Builder builder;
  for (int i = 0; i < 6; ++i) {
    const double x = std::cos(60 * degree * i), y = std::sin(60 * degree * i);
    builder.carbon(1.397 * x, 1.397 * y, 0).hydrogen(2.483 * x, 2.483 * y, 0);
  }
  return builder.bonded();
}

}  // namespace nanocarbon::structures

// SPDX-License-Identifier: GPL-2.0-or-later
// Defects of graphene by their names (F. Banhart, J. Kotakoski and A. V. Krasheninnikov, ACS Nano 5, 26 (2011)).
#include <gmock/gmock.h>

#include <map>

#include "bonded.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/onion.h"

namespace nanocarbon::analysis {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

std::map<std::string, int> kinds(const Analysis& analysis) {
  std::map<std::string, int> result;
  for (const Defect& defect : analysis.defects) ++result[defect.kind];
  return result;
}

Molecule sheet() { return test::bonded(structures::graphene(7, 4)); }

Vec3 middle(const Molecule& molecule) {
  return molecule.cell->origin + molecule.cell->vectors.rowwise().sum() / 2.0;
}

TEST(Defects, GrapheneAndDiamondHaveNone) {
  EXPECT_THAT(kinds(test::analysed(sheet())), IsEmpty());
  EXPECT_THAT(kinds(test::analysed(test::bonded(structures::diamond(2, 2, 2)))), IsEmpty());
}

TEST(Defects, ATurnedBondIsAStoneWalesDefectWhereItWasTurned) {
  const Molecule turned = test::graphene_with_turned_bond(7, 4);
  const Analysis analysis = test::analysed(turned);
  ASSERT_THAT(kinds(analysis), ElementsAre(Pair("Stone-Wales", 1)));
  const Defect& defect = analysis.defects[0];
  EXPECT_THAT(defect.ring_sizes, ElementsAre(5, 5, 7, 7));
  EXPECT_EQ(defect.atoms.size(), 16u);  // of four hexagons around one bond
  EXPECT_LT((defect.position - middle(turned)).norm(), 2.0);
  EXPECT_TRUE(analysis.components.all_surfaces());
}

TEST(Defects, IsolatedPentagonsOfALargeFullereneAreOneDefectEach) {
  EXPECT_THAT(kinds(test::analysed(test::bonded(structures::fullerene(2, 2)))),
              ElementsAre(Pair("pentagon", 12)));
}

// Two neighbours missing: a face of 14 atoms, four of which have lost a bond.
TEST(Defects, TwoMissingNeighboursAreAnOpenDivacancyWhereTheyWere) {
  const Molecule whole = test::bonded(sheet());
  const AtomIndex first = test::nearest_atom(whole, middle(whole));
  AtomIndex second = first;
  for (const Bond& bond : whole.bonds)
    if (bond.first == first) second = bond.second;
  ASSERT_NE(first, second);
  const Analysis analysis = test::analysed(test::bonded(test::without(whole, {first, second})));
  ASSERT_THAT(kinds(analysis), ElementsAre(Pair("open divacancy", 1)));
  EXPECT_EQ(analysis.defects[0].atoms.size(), 14u);
  EXPECT_LT((analysis.defects[0].position - whole.positions[first]).norm(), 1.5);
}

TEST(Defects, AHoleIsADefectAndTheEdgeOfAFlakeIsNot) {
  Molecule flake = sheet();
  std::vector<AtomIndex> hole;
  for (AtomIndex a = 0; a < flake.size(); ++a)
    if ((flake.positions[a] - middle(flake)).norm() < 3.0) hole.push_back(a);
  const Molecule punched = test::without(flake, hole);
  ASSERT_EQ(test::analysed(test::bonded(punched)).defects.size(), 1u);
  EXPECT_THAT(test::analysed(test::bonded(punched)).defects[0].kind, testing::StartsWith("hole of "));
  flake.cell.reset();
  for (const Defect& defect : test::analysed(test::bonded(flake)).defects)
    EXPECT_EQ(defect.kind, "carbon with one bond");  // at its corners
}

TEST(Defects, PositionsAreInTheCellWhereAtomsHaveWanderedOutOfIt) {
  Molecule turned = test::graphene_with_turned_bond(7, 4);
  const Vec3 before = test::analysed(turned).defects.at(0).position;
  for (Vec3& position : turned.positions) position += turned.cell->vectors.col(0);
  EXPECT_LT((test::analysed(turned).defects.at(0).position - before).norm(), 1e-9);
}

TEST(Defects, AMissingAtomIsAVacancy) {
  const Molecule whole = sheet();
  const Analysis analysis =
      test::analysed(test::bonded(test::without(whole, {test::nearest_atom(whole, middle(whole))})));
  ASSERT_THAT(kinds(analysis), ElementsAre(Pair("vacancy", 1)));
  EXPECT_THAT(analysis.defects[0].ring_sizes, ElementsAre(12));
  EXPECT_DOUBLE_EQ(analysis.bonds.share_with(2), 3.0 / static_cast<double>(whole.size() - 1));
}

TEST(Defects, AnAtomAcrossABondIsAnAdatom) {
  Molecule molecule = sheet();
  const AtomIndex a = test::nearest_atom(molecule, middle(molecule));
  const auto rows = bond_rows(molecule);
  const Vec3 half = bond_vector(molecule, a, rows.of(a)[0]) / 2.0;
  molecule.positions.push_back(molecule.positions[a] + half + Vec3(0, 0, 1.3));
  molecule.elements.push_back(Element::carbon);
  const Analysis analysis = test::analysed(test::bonded(molecule));
  EXPECT_FALSE(analysis.components.all_surfaces());  // two carbons have four neighbours
  EXPECT_EQ(kinds(analysis)["adatom"], 1);
  EXPECT_EQ(analysis.components.ring_counts[6], molecule.size() / 2);  // King's rings still find the hexagons
  EXPECT_EQ(analysis.components.ring_counts[3], 1u);
}

// Rings by hand, bonded along themselves.
std::map<std::string, int> kinds_of_rings(const std::vector<std::vector<AtomIndex>>& rings) {
  Molecule molecule;
  MoleculeComponents components;
  for (const auto& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto [low, high] = std::minmax(ring[k], ring[(k + 1) % ring.size()]);
      molecule.bonds.push_back({low, high});
      if (high >= molecule.size()) molecule.positions.resize(high + 1, Vec3::Zero());
    }
    components.rings.atoms.insert(components.rings.atoms.end(), ring.begin(), ring.end());
    components.rings.offsets.push_back(static_cast<std::uint32_t>(components.rings.atoms.size()));
  }
  molecule.elements.assign(molecule.size(), Element::carbon);
  std::sort(molecule.bonds.begin(), molecule.bonds.end());
  molecule.bonds.erase(std::unique(molecule.bonds.begin(), molecule.bonds.end()), molecule.bonds.end());
  std::map<std::string, int> result;
  for (const Defect& defect : find_defects(molecule, bond_rows(molecule), components)) ++result[defect.kind];
  return result;
}

TEST(Defects, AreNamedByTheirRings) {
  EXPECT_THAT(kinds_of_rings({{0, 1, 2, 3, 4}, {0, 1, 5, 6, 7, 8, 9}}), ElementsAre(Pair("5-7 pair", 1)));
  EXPECT_THAT(kinds_of_rings({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 8, 9, 10}, {4, 5, 11, 12, 13}}),
              ElementsAre(Pair("divacancy 5-8-5", 1)));
  // Heptagons that share bonds with each other, but with the pentagons at their far ends.
  EXPECT_THAT(kinds_of_rings(
                  {{0, 1, 2, 3, 4, 5, 6}, {0, 1, 7, 8, 9, 10, 11}, {3, 4, 12, 13, 14}, {8, 9, 15, 16, 17}}),
              ElementsAre(Pair("two 5-7 pairs", 1)));
  // Three heptagons around one atom, pentagons between their outer ends.
  EXPECT_THAT(kinds_of_rings({{0, 1, 4, 5, 6, 7, 2},
                              {0, 2, 8, 9, 10, 11, 3},
                              {0, 3, 12, 13, 14, 15, 1},
                              {1, 4, 16, 17, 15},
                              {2, 7, 18, 19, 8},
                              {3, 11, 20, 21, 12}}),
              ElementsAre(Pair("divacancy 555-777", 1)));
  EXPECT_THAT(kinds_of_rings({{0, 1, 2, 3}, {10, 11, 12, 13, 14, 15, 16, 17}}),
              ElementsAre(Pair("octagon", 1), Pair("square", 1)));
}

TEST(Defects, TwoSheetsPulledTogetherAtOneAtomAreCrosslinked) {
  Molecule molecule = sheet();
  const Molecule lower = molecule;
  const AtomIndex a = test::nearest_atom(lower, middle(lower));
  structures::append(molecule, lower);
  for (std::size_t i = lower.size(); i < molecule.size(); ++i) molecule.positions[i].z() += 3.35;
  molecule.positions[a].z() += 0.9;
  molecule.positions[a + lower.size()].z() -= 0.9;
  const Analysis analysis = test::analysed(test::bonded(molecule));
  ASSERT_EQ(kinds(analysis)["crosslink"], 1);
  const auto found = std::find_if(analysis.defects.begin(), analysis.defects.end(),
                                  [](const Defect& defect) { return defect.kind == "crosslink"; });
  EXPECT_THAT(found->atoms, ElementsAre(a, a + lower.size()));
}

TEST(MoleculeComponents, AFaultyPieceDoesNotHideTheSurfaceOfAnother) {
  Molecule molecule = test::bonded(structures::fullerene(1, 1));
  Molecule far = test::bonded(structures::diamond(1, 1, 1));
  far.cell.reset();
  for (Vec3& p : far.positions) p.x() += 30.0;
  structures::append(molecule, test::bonded(far));
  const Analysis analysis = test::analysed(test::bonded(molecule));
  ASSERT_GE(analysis.components.list.size(), 2u);
  EXPECT_TRUE(analysis.components.surface.problem);
  EXPECT_TRUE(analysis.components.list[0].is_surface());
  EXPECT_EQ(analysis.components.list[0].topology.euler_characteristic(), 2);
  EXPECT_FALSE(analysis.components.list[1].is_surface());
  EXPECT_EQ(analysis.components.ring_counts[5], 12u);
}

}  // namespace
}  // namespace nanocarbon::analysis

// SPDX-License-Identifier: GPL-2.0-or-later
// The fast sum against the printed formulas, pair by pair, with every instruction set of this machine.
#include "nanocarbon/potential/airebo/lj/lj_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/airebo/lj/lj_dispatch.h"
#include "potential/airebo/plain_lj_sum.h"

namespace nanocarbon::airebo {
namespace {

using test::LjSystem;
using test::PlainSum;

struct Evaluated {
  LjResult sum;
  std::vector<Vec3> forces;
};

Evaluated evaluate(LjSum& sum, const LjSystem& system, LjWanted wanted = {}) {
  Evaluated e;
  e.forces.assign(system.size(), Vec3::Zero());
  e.sum = sum.evaluate(e.forces.empty() ? nullptr : e.forces.front().data(), wanted);
  return e;
}

bool place(LjSum& sum, const LjSystem& system) {
  return sum.place(system.positions.empty() ? nullptr : system.positions.front().data(),
                   system.cell_or_none());
}

void find_pairs(LjSum& sum, const LjSystem& system) {
  sum.find_pairs(system.positions, system.elements, system.cell_or_none(), system.exclusions);
}

//! Pairs closer than 2 Angstrom have forces of thousands of eV/Angstrom, so rounding is measured by them.
void expect_same(const Evaluated& fast, const PlainSum& plain, const std::string& what) {
  SCOPED_TRACE(what);
  EXPECT_NEAR(fast.sum.energy, plain.energy, 2e-14 * plain.sum_of_magnitudes);
  const double force_tolerance = 1e-13 * plain.largest_pair_force + 1e-15;
  for (std::size_t i = 0; i < plain.forces.size(); ++i)
    EXPECT_LT((fast.forces[i] - plain.forces[i]).norm(), force_tolerance) << "atom " << i;
  // The virial is a sum of positions times forces, whose products are larger than it.
  EXPECT_LT((fast.sum.virial - plain.virial).norm(), 1e-10 * plain.virial.norm() + 1e-13) << what;
}

std::vector<LjSystem> systems() {
  std::vector<LjSystem> all;
  for (const std::size_t atoms : {1, 2, 3, 4, 5, 17, 150})
    all.push_back(test::random_system(atoms, std::nullopt, 0.5, static_cast<unsigned>(atoms)));
  all.push_back(test::random_system(120, std::nullopt, 0.0, 7));
  all.push_back(test::random_system(120, std::nullopt, 1.0, 8));
  all.push_back(test::random_system(150, orthogonal_cell({13.0, 12.0, 14.0}), 0.5, 9));
  all.push_back(test::random_system(60, orthogonal_cell({11.0, 9.0, 30.0}, {true, true, false}), 0.3, 10));
  all.push_back(test::random_system(25, orthogonal_cell({20.0, 4.2, 20.0}, {false, true, false}), 0.7, 11));
  all.push_back(test::random_system(6, orthogonal_cell({4.0, 4.5, 5.0}), 0.5, 12));
  all.push_back(test::random_system(1, orthogonal_cell({3.7, 3.7, 3.7}), 0.0, 13));
  Cell tilted;
  tilted.vectors << 9.0, 4.0, -3.0, 0.0, 8.0, 5.0, 0.0, 0.0, 7.0;
  tilted.origin = Vec3(-3.0, 100.0, 5.0);
  all.push_back(test::random_system(40, tilted, 0.5, 14));
  LjSystem far = test::random_system(40, std::nullopt, 0.5, 15);
  far.positions[11] += Vec3(1e5, -2e4, 3e3);
  for (Vec3& p : far.positions) p += Vec3(50.0, 60.0, -70.0);
  all.push_back(far);
  return all;
}

std::vector<LjParameters> parameter_sets() {
  std::vector<LjParameters> sets;
  for (const LjForm form : {LjForm::lennard_jones, LjForm::morse}) {
    LjParameters p = test::published_parameters(form);
    sets.push_back(p);
    p.cutoff = 2.5;  // cut hard within the window
    sets.push_back(p);
    p.cutoff = 1.9;  // and before it
    sets.push_back(p);
    p.cutoff = 3.5;  // beyond it: nothing more
    sets.push_back(p);
    p.switch_begin = 1.5;
    p.switch_end = p.cutoff = 2.4;
    sets.push_back(p);
    p.switch_begin = p.switch_end = p.cutoff = 2.0;  // no window
    sets.push_back(p);
  }
  return sets;
}

class LjSumTest : public testing::TestWithParam<const LjKernel*> {
 protected:
  LjSum make(const LjParameters& parameters, LjSumOptions options = {}) {
    options.instructions = GetParam()->name;
    return LjSum(parameters, options);
  }
};

TEST_P(LjSumTest, IsTheSumOverAllPairs) {
  for (const LjSystem& system : systems())
    for (const LjForm form : {LjForm::lennard_jones, LjForm::morse}) {
      const LjParameters parameters = test::published_parameters(form);
      LjSum sum = make(parameters);
      find_pairs(sum, system);
      ASSERT_TRUE(place(sum, system));
      expect_same(evaluate(sum, system), plain_sum(system, parameters), system.name);
    }
}

TEST_P(LjSumTest, EndsWhereTheArgumentsSay) {
  const LjSystem system = test::random_system(110, orthogonal_cell({12.0, 11.0, 13.0}), 0.5, 3);
  for (const LjParameters& parameters : parameter_sets()) {
    LjSum sum = make(parameters);
    find_pairs(sum, system);
    ASSERT_TRUE(place(sum, system));
    expect_same(evaluate(sum, system), plain_sum(system, parameters),
                "cut at " + std::to_string(parameters.cutoff));
  }
}

TEST_P(LjSumTest, PairsAtEveryDistanceFollowTheFormulas) {
  for (const LjParameters& parameters : parameter_sets())
    for (const auto& [a, b] :
         {std::pair(Element::carbon, Element::carbon), std::pair(Element::hydrogen, Element::carbon),
          std::pair(Element::hydrogen, Element::hydrogen)}) {
      const double sigma = parameters.pairs[LjParameters::index(a, b)].sigma;
      LjSystem pair = {"a pair", {Vec3(0.3, 0.2, 0.1), Vec3::Zero()}, {a, b}, {}, {}};
      for (double r = 0.4; r < 3.7; r += 0.01) {
        pair.positions[1] = pair.positions[0] + r * sigma * Vec3(2.0, -1.0, 2.0) / 3.0;
        LjSum sum = make(parameters);
        find_pairs(sum, pair);
        ASSERT_TRUE(place(sum, pair));
        const PlainSum plain = plain_sum(pair, parameters);
        const Evaluated fast = evaluate(sum, pair);
        EXPECT_NEAR(fast.sum.energy, plain.energy, 1e-14 * std::abs(plain.energy) + 5e-17) << r;
        // Near the minimum attraction and repulsion, some 1e-3 eV/Angstrom each, cancel: no more digits are there.
        EXPECT_LT((fast.forces[0] - plain.forces[0]).norm(), 3e-14 * plain.forces[0].norm() + 5e-17) << r;
      }
    }
}

TEST_P(LjSumTest, ForcesAreTheSlopeOfTheEnergy) {
  for (const LjForm form : {LjForm::lennard_jones, LjForm::morse}) {
    LjSystem system = test::random_system(30, orthogonal_cell({8.0, 7.0, 9.0}), 0.5, 21);
    LjSum sum = make(test::published_parameters(form));
    find_pairs(sum, system);
    ASSERT_TRUE(place(sum, system));
    const std::vector<Vec3> forces = evaluate(sum, system).forces;
    const double step = 1e-3;
    for (std::size_t i = 0; i < system.size(); i += 7)
      for (int d = 0; d < 3; ++d) {
        const double x = system.positions[i][d];
        const auto energy_at = [&](double by) {
          system.positions[i][d] = x + by;
          EXPECT_TRUE(place(sum, system));
          return evaluate(sum, system).sum.energy;
        };
        const double slope =
            (8.0 * (energy_at(step) - energy_at(-step)) - (energy_at(2.0 * step) - energy_at(-2.0 * step))) /
            (12.0 * step);
        system.positions[i][d] = x;
        EXPECT_NEAR(forces[i][d], -slope, 1e-6 + 1e-7 * std::abs(slope));
      }
  }
}

// Of carbon alone, of both elements, and of hydrogen alone, which have loops of their own.
TEST_P(LjSumTest, ForcesAndVirialDoNotNeedTheEnergy) {
  for (const double hydrogens : {0.0, 0.5, 1.0}) {
    const LjSystem system = test::random_system(80, orthogonal_cell({10.0, 11.0, 9.0}), hydrogens, 4);
    for (const LjParameters& parameters : parameter_sets()) {
      LjSum sum = make(parameters);
      find_pairs(sum, system);
      ASSERT_TRUE(place(sum, system));
      const Evaluated full = evaluate(sum, system);
      ASSERT_TRUE(place(sum, system));
      const Evaluated less = evaluate(sum, system, {.energy = false, .virial = true});
      EXPECT_EQ(less.sum.energy, 0.0);
      EXPECT_LT((less.sum.virial - full.sum.virial).norm(), 1e-12 * full.sum.virial.norm());
      for (std::size_t i = 0; i < system.size(); ++i)
        EXPECT_LT((less.forces[i] - full.forces[i]).norm(), 1e-12 * full.forces[i].norm() + 1e-12);
    }
  }
}

// A row has from one pair of atoms up to many, and in the last of its groups any number.
TEST_P(LjSumTest, RowsOfEveryLengthAreSummed) {
  const LjParameters parameters = test::published_parameters(LjForm::lennard_jones);
  for (std::size_t atoms = 2; atoms < 48; ++atoms) {
    const LjSystem system = test::random_system(atoms, std::nullopt, atoms % 2 == 0 ? 0.0 : 0.3, 100);
    LjSum sum = make(parameters);
    find_pairs(sum, system);
    ASSERT_TRUE(place(sum, system));
    const Evaluated full = evaluate(sum, system);
    expect_same(full, plain_sum(system, parameters), system.name);
    ASSERT_TRUE(place(sum, system));
    const Evaluated less = evaluate(sum, system, {.energy = false, .virial = false});
    for (std::size_t i = 0; i < system.size(); ++i)
      EXPECT_LT((less.forces[i] - full.forces[i]).norm(), 1e-12 * full.forces[i].norm() + 1e-12);
  }
}

TEST_P(LjSumTest, KeepsItsListsWhileAtomsMoveByLessThanHalfTheMargins) {
  const LjParameters parameters = test::published_parameters(LjForm::lennard_jones);
  for (const auto& cell : {std::optional<Cell>(), std::optional(orthogonal_cell({12.0, 13.0, 11.0}))}) {
    const LjSystem start = test::random_system(130, cell, 0.4, 5);
    LjSumOptions options;
    options.inner_margin = 0.6;
    options.own_lists.margin = 1.4;
    LjSum sum = make(parameters, options);
    find_pairs(sum, start);
    ASSERT_TRUE(place(sum, start));
    const std::size_t first = sum.searches();
    for (unsigned step = 0; step < 5; ++step) {
      const LjSystem moved = test::shaken(start, 0.2999, step);
      ASSERT_TRUE(place(sum, moved));
      EXPECT_EQ(sum.searches(), first);
      expect_same(evaluate(sum, moved), plain_sum(moved, parameters), "within the inner margin");
    }
    LjSystem moved = test::shaken(start, 0.6999, 77);
    ASSERT_TRUE(place(sum, moved));
    EXPECT_GT(sum.searches(), first);
    expect_same(evaluate(sum, moved), plain_sum(moved, parameters), "within the outer margin");
    EXPECT_FALSE(place(sum, test::shaken(start, 0.7001, 78)));
    moved = start;
    for (Vec3& p : moved.positions) p += Vec3(3.0, 2.0, 1.0);
    EXPECT_FALSE(place(sum, moved));
    find_pairs(sum, moved);
    ASSERT_TRUE(place(sum, moved));
    expect_same(evaluate(sum, moved), plain_sum(moved, parameters), "anew");
  }
}

TEST_P(LjSumTest, FollowsTheCell) {
  const LjParameters parameters = test::published_parameters(LjForm::lennard_jones);
  LjSystem system = test::random_system(100, orthogonal_cell({10.0, 12.0, 11.0}), 0.4, 6);
  LjSum sum = make(parameters);
  find_pairs(sum, system);
  ASSERT_TRUE(place(sum, system));
  Mat3 strain = Mat3::Identity();
  strain(0, 1) = 0.01;
  strain(2, 2) = 1.005;
  system.cell->vectors = strain * system.cell->vectors;
  for (Vec3& p : system.positions) p = strain * p;
  ASSERT_TRUE(place(sum, system));
  expect_same(evaluate(sum, system), plain_sum(system, parameters), "strained");
  system.cell->vectors *= 1.5;
  EXPECT_FALSE(place(sum, system));
}

TEST_P(LjSumTest, AtomsShareTheirPairsEqually) {
  for (const LjParameters& parameters : parameter_sets()) {
    const LjSystem system = test::random_system(70, orthogonal_cell({9.0, 9.0, 11.0}), 0.5, 16);
    LjSum sum = make(parameters);
    find_pairs(sum, system);
    ASSERT_TRUE(place(sum, system));
    std::vector<double> energies(system.size(), 0.0);
    std::vector<Mat3> virials(system.size(), Mat3::Zero());
    sum.add_shares(energies, virials);
    const PlainSum plain = plain_sum(system, parameters);
    for (std::size_t i = 0; i < system.size(); ++i) {
      EXPECT_NEAR(energies[i], plain.atom_energies[i], 1e-13 * plain.sum_of_magnitudes);
      EXPECT_LT((virials[i] - plain.atom_virials[i]).norm(), 1e-12 * plain.largest_pair_force);
    }
  }
}

TEST_P(LjSumTest, BytesDoNotDependOnWhoDoesTheWork) {
  const LjParameters parameters = test::published_parameters(LjForm::lennard_jones);
  const LjSystem system = test::random_system(400, orthogonal_cell({16.0, 17.0, 18.0}), 0.4, 17);
  LjSumOptions options;
  options.own_lists.chunk_clusters = 16;
  LjSum alone = make(parameters, options);
  options.parallel = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::vector<std::thread> threads;
    for (std::size_t index = count; index-- > 0;) threads.emplace_back(task, index);
    for (std::thread& thread : threads) thread.join();
  };
  LjSum many = make(parameters, options);
  for (LjSum* sum : {&alone, &many}) {
    find_pairs(*sum, system);
    EXPECT_GT(sum->lists().chunks.size(), 3u);
    ASSERT_TRUE(place(*sum, system));
  }
  const Evaluated a = evaluate(alone, system), b = evaluate(many, system);
  EXPECT_EQ(a.sum.energy, b.sum.energy);
  EXPECT_EQ(a.sum.virial, b.sum.virial);
  for (std::size_t i = 0; i < system.size(); ++i) EXPECT_EQ(a.forces[i], b.forces[i]);
  expect_same(a, plain_sum(system, parameters), "in chunks");
}

//! A half list as a program of many processes has it: own atoms and ghosts, half of their pairs.
struct HalfListSystem {
  std::vector<Vec3> positions;
  std::vector<Element> elements;
  std::vector<std::uint32_t> of;
  std::size_t own = 0;
  std::vector<int> atoms, counts;
  std::vector<std::vector<int>> rows;
  std::vector<const int*> neighbours;
  std::vector<std::array<std::uint32_t, 2>> exclusions;

  HalfListSystem(const LjSystem& system, double skin, unsigned seed) : own(system.size()) {
    const NeighbourList near = neighbours_within(system.positions, system.cell_or_none(), 10.2 + skin);
    std::map<Neighbour, int> ghosts;
    for (std::uint32_t i = 0; i < own; ++i) {
      positions.push_back(system.positions[i]);
      elements.push_back(system.elements[i]);
      of.push_back(i);
    }
    const auto number = [&](const Neighbour& n) {
      if (n.image == std::array<std::int32_t, 3>{0, 0, 0}) return static_cast<int>(n.atom);
      const auto [at, is_new] = ghosts.try_emplace(n, static_cast<int>(positions.size()));
      if (is_new) {
        positions.push_back(system.positions[n.atom] + image_shift(*system.cell, n.image));
        elements.push_back(system.elements[n.atom]);
        of.push_back(n.atom);
      }
      return at->second;
    };
    // Which end has a pair is up to the other program: here, a coin.
    const auto mine = [&](std::uint32_t i, const Neighbour& n) {
      const auto back = std::array<std::int32_t, 3>{-n.image[0], -n.image[1], -n.image[2]};
      const bool first = std::pair(i, n.image) < std::pair(n.atom, back);
      std::seed_seq seeds = {seed, std::min(i, n.atom), std::max(i, n.atom),
                             static_cast<unsigned>(std::abs(n.image[0]) + 10 * std::abs(n.image[1]) +
                                                   100 * std::abs(n.image[2]))};
      return (std::mt19937(seeds)() % 2 == 0) == first;
    };
    rows.resize(own);
    for (std::uint32_t i = 0; i < own; ++i) {
      for (const Neighbour& n : near.of(i))
        if (mine(i, n)) rows[i].push_back(number(n) | 1 << 30);
      atoms.push_back(static_cast<int>(own - 1 - i));
      counts.push_back(static_cast<int>(rows[i].size()));
      for (const Neighbour& n : system.exclusions.of(i))
        exclusions.push_back({i, static_cast<std::uint32_t>(number(n))});
    }
    for (const auto& row : rows) neighbours.push_back(row.data());
  }

  LjHalfList list() const {
    return {atoms.size(), atoms.data(), neighbours.data(), counts.data(), 0x1fffffff};
  }

  void follow(const LjSystem& from, const LjSystem& to) {
    for (std::size_t a = 0; a < positions.size(); ++a)
      positions[a] += to.positions[of[a]] - from.positions[of[a]];
  }
};

TEST_P(LjSumTest, TakesHalfListsWithGhosts) {
  for (const LjForm form : {LjForm::lennard_jones, LjForm::morse})
    for (const LjSystem& system : systems()) {
      const LjParameters parameters = test::published_parameters(form);
      HalfListSystem half(system, 1.0, 3);
      LjSum sum = make(parameters);
      sum.use_half_list(half.list(), half.positions.front().data(), half.elements, half.exclusions);
      for (const double distance : {0.0, 0.1, 0.4999}) {
        const LjSystem moved = test::shaken(system, distance, 3);
        HalfListSystem placed = half;
        placed.follow(system, moved);
        ASSERT_TRUE(sum.place(placed.positions.front().data()));
        std::vector<Vec3> forces(placed.positions.size(), Vec3::Zero());
        Evaluated e;
        e.sum = sum.evaluate(forces.front().data());
        e.forces.assign(system.size(), Vec3::Zero());
        for (std::size_t a = 0; a < forces.size(); ++a) e.forces[half.of[a]] += forces[a];
        expect_same(e, plain_sum(moved, parameters), system.name);
      }
    }
}

TEST_P(LjSumTest, NothingComesOfNothing) {
  LjSum sum = make(test::published_parameters(LjForm::lennard_jones));
  EXPECT_TRUE(sum.place(nullptr));
  EXPECT_EQ(sum.evaluate(nullptr).energy, 0.0);
  const Cell cell = orthogonal_cell({5.0, 5.0, 5.0});
  for (const Cell* c : {static_cast<const Cell*>(nullptr), &cell}) {
    sum.find_pairs({}, {}, c, {});
    EXPECT_TRUE(sum.place(nullptr, c));
    EXPECT_EQ(sum.evaluate(nullptr).energy, 0.0);
  }
  sum.use_half_list({}, nullptr, {}, {});
  EXPECT_TRUE(sum.place(nullptr));
  EXPECT_EQ(sum.evaluate(nullptr).energy, 0.0);
}

TEST_P(LjSumTest, ExcludedAtomsAtOnePlaceDoNoHarm) {
  for (const LjForm form : {LjForm::lennard_jones, LjForm::morse}) {
    const LjParameters parameters = test::published_parameters(form);
    LjSystem system = test::random_system(20, std::nullopt, 0.5, 18);
    system.positions[1] = system.positions[0];
    system.exclusions.offsets.assign(system.size() + 1, 1);
    system.exclusions.offsets[0] = 0;
    system.exclusions.neighbours = {{1, {0, 0, 0}}};
    for (const std::size_t i : {2, 3}) system.positions[i] += Vec3(40.0 * static_cast<double>(i), 0.0, 0.0);
    LjSum sum = make(parameters);
    find_pairs(sum, system);
    ASSERT_TRUE(place(sum, system));
    const Evaluated e = evaluate(sum, system);
    EXPECT_TRUE(std::isfinite(e.sum.energy));
    expect_same(e, plain_sum(system, parameters), "two in one place");
  }
}

TEST_P(LjSumTest, ShowsPositionsThatAreNotNumbers) {
  const LjSystem system = test::random_system(20, std::nullopt, 0.5, 19);
  HalfListSystem half(system, 1.0, 3);
  for (const LjForm form : {LjForm::lennard_jones, LjForm::morse}) {
    LjSum sum = make(test::published_parameters(form));
    sum.use_half_list(half.list(), half.positions.front().data(), half.elements, half.exclusions);
    ASSERT_TRUE(sum.place(half.positions.front().data()));
    std::vector<Vec3> broken = half.positions;
    broken[7].y() = NAN;
    sum.place(broken.front().data());
    std::vector<Vec3> forces(broken.size(), Vec3::Zero());
    EXPECT_TRUE(std::isnan(sum.evaluate(forces.front().data()).energy));
  }
}

INSTANTIATE_TEST_SUITE_P(Kernel, LjSumTest, testing::ValuesIn(usable_lj_kernels()),
                         [](const auto& kernel) { return std::string(kernel.param->name); });

TEST(LjSum, RefusesInstructionsThatAreNotThere) {
  LjSumOptions options;
  options.instructions = "mmx";
  EXPECT_THROW(LjSum(test::published_parameters(LjForm::morse), options), UserError);
}

}  // namespace
}  // namespace nanocarbon::airebo

// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/parameter_file.h"

#include <gmock/gmock.h>

#include <fstream>

#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace nanocarbon::airebo {
namespace {

using test::refusal;
using testing::HasSubstr;

void expect_same(const LongRangeParameters& a, const LongRangeParameters& b) {
  EXPECT_EQ(a.length_switch_begin, b.length_switch_begin);
  EXPECT_EQ(a.length_switch_end, b.length_switch_end);
  EXPECT_EQ(a.order_switch_begin, b.order_switch_begin);
  EXPECT_EQ(a.order_switch_end, b.order_switch_end);
  EXPECT_EQ(a.potential.epsilon, b.potential.epsilon);
  EXPECT_EQ(a.potential.sigma, b.potential.sigma);
  EXPECT_EQ(a.potential.morse_epsilon, b.potential.morse_epsilon);
  EXPECT_EQ(a.potential.morse_decay, b.potential.morse_decay);
  EXPECT_EQ(a.potential.morse_equilibrium, b.potential.morse_equilibrium);
}

void expect_same(const rebo2::Rebo2Parameters& a, const rebo2::Rebo2Parameters& b) {
  for (int p = 0; p < 3; ++p) {
    EXPECT_EQ(a.pairs[p].cutoff_begin, b.pairs[p].cutoff_begin);
    EXPECT_EQ(a.pairs[p].cutoff_end, b.pairs[p].cutoff_end);
    EXPECT_EQ(a.pairs[p].dihedral_cutoff_end, b.pairs[p].dihedral_cutoff_end);
    EXPECT_EQ(a.pairs[p].screening, b.pairs[p].screening);
    EXPECT_EQ(a.pairs[p].repulsion, b.pairs[p].repulsion);
    EXPECT_EQ(a.pairs[p].repulsion_decay, b.pairs[p].repulsion_decay);
    EXPECT_EQ(a.pairs[p].attraction, b.pairs[p].attraction);
    EXPECT_EQ(a.pairs[p].attraction_decay, b.pairs[p].attraction_decay);
    EXPECT_EQ(a.pairs[p].equilibrium, b.pairs[p].equilibrium);
  }
  EXPECT_EQ(a.conjugation_begin, b.conjugation_begin);
  EXPECT_EQ(a.conjugation_end, b.conjugation_end);
  EXPECT_EQ(a.carbon.knots, b.carbon.knots);
  EXPECT_EQ(a.carbon.many, b.carbon.many);
  EXPECT_EQ(a.carbon.few, b.carbon.few);
  EXPECT_EQ(a.carbon.few_end, b.carbon.few_end);
  EXPECT_EQ(a.carbon.many_begin, b.carbon.many_begin);
  EXPECT_EQ(a.hydrogen.knots, b.hydrogen.knots);
  EXPECT_EQ(a.hydrogen.pieces, b.hydrogen.pieces);
}

struct Case {
  const char* file;
  LjForm form;
  const AireboParameters* built_in;
};
const std::vector<Case>& cases() {
  static const std::vector<Case> both = {{"CH.airebo", LjForm::lennard_jones, &airebo_parameters()},
                                         {"CH.airebo-m", LjForm::morse, &airebo_m_parameters()}};
  return both;
}

TEST(AireboParameters, AreThoseOfLammpsToTheLastDigit) {
  for (const Case& c : cases()) {
    const std::string path = std::string(NANOCARBON_LAMMPS_POTENTIALS) + "/" + c.file;
    if (!std::ifstream(path)) GTEST_SKIP() << "LAMMPS's " << c.file << " is not here";
    SCOPED_TRACE(path);
    const AireboParameters read = read_airebo_parameters(path, c.form);
    EXPECT_EQ(read.form, c.built_in->form);
    expect_same(read.rebo, c.built_in->rebo);
    for (int p = 0; p < 3; ++p) expect_same(read.long_range[p], c.built_in->long_range[p]);
    EXPECT_EQ(read.torsion.barriers, c.built_in->torsion.barriers);
  }
}

TEST(AireboParameters, HaveTheirOwnPOfCarbon) {
  const auto& own = airebo_parameters().rebo.tables;
  EXPECT_DOUBLE_EQ(own.p_cc.evaluate(2.0, 0.0).value, -0.0276030);
  EXPECT_DOUBLE_EQ(own.p_cc.evaluate(1.0, 1.0).value, -0.010960);
  EXPECT_DOUBLE_EQ(own.p_cc.evaluate(0.0, 2.0).value, -0.00050);
  EXPECT_EQ(rebo2::rebo2_parameters().tables.p_cc.evaluate(2.0, 0.0).value, 0.0);
  EXPECT_EQ(own.p_ch.evaluate(1.0, 1.0).value, rebo2::rebo2_tables().p_ch.evaluate(1.0, 1.0).value);
}

//! The numbers of a file in LAMMPS's format, in the order of the parameters.
std::string labelled_lines(int count) {
  std::string lines;
  for (int n = 0; n < count; ++n) lines += std::to_string(n + 1) + ".5 some_label\n";
  return lines;
}
std::string splines() {
  std::string text = "# gC\n5\n-1 -0.5 0 0.5 1\n";
  for (int n = 0; n < 48; ++n) text += "0.25\n";
  text += "4\n-1 -0.5 0.5 1\n";
  for (int n = 0; n < 18; ++n) text += "0.75\n";
  return text;
}

class AireboFiles : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) { return folder_.file("test.airebo", text); }
  test::TemporaryFolder folder_;
};

TEST_F(AireboFiles, GiveTheirNumbersInOrder) {
  const AireboParameters lj = read_airebo_parameters(
      write("# 1\n# AIREBO of nobody\n" + labelled_lines(65) + splines()), LjForm::lennard_jones);
  EXPECT_EQ(lj.long_range[0].length_switch_begin, 45.5);
  EXPECT_EQ(lj.long_range[2].potential.sigma, 62.5);
  EXPECT_EQ(lj.torsion.barriers[2], 65.5);
  EXPECT_EQ(lj.rebo.hydrogen.pieces[2][5], 0.75);
  const AireboParameters morse = read_airebo_parameters(
      write("# 1\n# AIREBO-M of nobody\n" + labelled_lines(74) + splines()), LjForm::morse);
  EXPECT_EQ(morse.long_range[0].potential.morse_epsilon, 66.5);
  EXPECT_EQ(morse.long_range[2].potential.morse_equilibrium, 74.5);
  EXPECT_EQ(morse.rebo.carbon.few[0][0], 0.25);
}

TEST_F(AireboFiles, OfTheOtherFormAreRefused) {
  const auto lj = write("# 1\n# AIREBO of nobody\n" + labelled_lines(65) + splines());
  EXPECT_THAT(refusal(Failure::malformed, [&] { read_airebo_parameters(lj, LjForm::morse); }),
              HasSubstr("line 2: this is a file of AIREBO, not of AIREBO-M"));
  const auto morse = write("# 1\n# AIREBO-M of nobody\n" + labelled_lines(74) + splines());
  EXPECT_THAT(refusal(Failure::malformed, [&] { read_airebo_parameters(morse, LjForm::lennard_jones); }),
              HasSubstr("line 2: this is a file of AIREBO-M, not of AIREBO,"));
}

TEST_F(AireboFiles, ThatEndEarlyAreRefused) {
  const auto path = write("# 1\n# AIREBO-M of nobody\n" + labelled_lines(70));
  EXPECT_THAT(refusal(Failure::malformed, [&] { read_airebo_parameters(path, LjForm::morse); }),
              HasSubstr("where alphaM was expected"));
  EXPECT_THAT(refusal(Failure::unreadable, [&] { read_airebo_parameters("nowhere.airebo", LjForm::morse); }),
              HasSubstr("nowhere.airebo"));
}

}  // namespace
}  // namespace nanocarbon::airebo

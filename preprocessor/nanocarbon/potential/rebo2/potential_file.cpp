// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/potential_file.h"

#include <cmath>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"

namespace nanocarbon::rebo2 {

namespace {

template <std::size_t knots>
void read_knots(PotentialFile& file, std::array<double, knots>& to, const char* name) {
  if (file.plain(name) != knots)
    file.fail(std::string(name) + ": expected " + std::to_string(knots) + " knots, found " + file.word());
  for (double& knot : to) knot = file.plain(name);
}

template <std::size_t pieces>
void read_pieces(PotentialFile& file, std::array<Quintic, pieces>& to, const char* name) {
  for (Quintic& piece : to)
    for (double& coefficient : piece) coefficient = file.plain(name);
}

}  // namespace

PotentialFile::PotentialFile(const std::filesystem::path& path) : path_(path), file_(path) {
  if (!file_) throw UserError(Failure::unreadable, "cannot open the potential file " + path.string());
}

void PotentialFile::require_header(const std::string& model, const char* example) {
  std::string first, second;
  std::getline(file_, first);
  std::getline(file_, second);
  line_ = 2;
  if (second.find("# " + model + " ") != std::string::npos) return;
  for (const char* other : {"REBO2", "AIREBO", "AIREBO-M"})
    if (second.find(std::string("# ") + other + " ") != std::string::npos)
      fail(std::string("this is a file of ") + other + ", not of " + model + ", whose second line has '# " +
           model + "', as that of LAMMPS's " + example);
  fail("expected '# " + model + "' in the second line, as LAMMPS's " + example + " has it");
}

double PotentialFile::labelled(const char* name) {
  next_line(name);
  const double value = number(name);
  words_.str("");
  return value;
}

double PotentialFile::plain(const char* name) {
  if ((words_ >> std::ws).eof()) next_line(name);
  return number(name);
}

void PotentialFile::fail(const std::string& what) const {
  throw UserError(Failure::malformed, path_.string() + ", line " + std::to_string(line_) + ": " + what);
}

void PotentialFile::next_line(const char* name) {
  std::string line;
  while (std::getline(file_, line)) {
    ++line_;
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    words_.clear();
    words_.str(line);
    return;
  }
  fail(std::string("the file ends where ") + name + " was expected");
}

double PotentialFile::number(const char* name) {
  word_.clear();
  words_ >> word_;
  double value = 0.0;
  // inf and nan are numbers to read_real.
  if (read_real(word_, value) != NumberToken::number || !std::isfinite(value))
    fail("expected a number (" + std::string(name) + "), found '" + word_ + "'");
  return value;
}

void read_bond_parameters(PotentialFile& file, Rebo2Parameters& parameters) {
  const auto for_pairs = [&](const char* name, double PairParameters::*member) {
    for (PairParameters& pair : parameters.pairs) pair.*member = file.labelled(name);
  };
  const auto for_pairs_and_terms = [&](const char* name, std::array<double, 3> PairParameters::*member) {
    for (PairParameters& pair : parameters.pairs)
      for (double& term : pair.*member) term = file.labelled(name);
  };
  for_pairs("rcmin", &PairParameters::cutoff_begin);
  for_pairs("rcmax", &PairParameters::cutoff_end);
  for_pairs("rcmaxp", &PairParameters::dihedral_cutoff_end);
  file.labelled("smin");
  parameters.conjugation_begin = file.labelled("Nmin");
  parameters.conjugation_end = file.labelled("Nmax");
  parameters.carbon.few_end = file.labelled("NCmin");
  parameters.carbon.many_begin = file.labelled("NCmax");
  for_pairs("Q", &PairParameters::screening);
  for_pairs("alpha", &PairParameters::repulsion_decay);
  for_pairs("A", &PairParameters::repulsion);
  for_pairs_and_terms("BIJc", &PairParameters::attraction);
  for_pairs_and_terms("Beta", &PairParameters::attraction_decay);
  for_pairs("rho", &PairParameters::equilibrium);
}

void read_angular_splines(PotentialFile& file, Rebo2Parameters& parameters) {
  read_knots(file, parameters.carbon.knots, "gC");
  read_pieces(file, parameters.carbon.few, "gC1");
  read_pieces(file, parameters.carbon.many, "gC2");
  read_knots(file, parameters.hydrogen.knots, "gH");
  read_pieces(file, parameters.hydrogen.pieces, "gH");
}

}  // namespace nanocarbon::rebo2

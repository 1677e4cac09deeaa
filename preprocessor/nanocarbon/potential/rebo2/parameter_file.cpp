// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/parameter_file.h"

#include <charconv>
#include <fstream>
#include <sstream>
#include <string>

#include "nanocarbon/core/error.h"

namespace nanocarbon::rebo2 {

namespace {

//! Hands out the numbers of the file in order, and knows where it is.
class NumberReader {
 public:
  explicit NumberReader(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) throw UserError(Failure::unreadable, "cannot open the potential file " + path.string());
  }

  void require_header() {
    std::string first, second;
    std::getline(file_, first);
    std::getline(file_, second);
    line_ = 2;
    if (second.find("# REBO2 ") == std::string::npos)
      fail("expected '# REBO2' in the second line, as LAMMPS's CH.rebo has it");
  }

  //! The first number of the next line that has one; the rest of the line names it.
  double labelled(const char* name) {
    next_line(name);
    const double value = number(name);
    words_.str("");
    return value;
  }

  //! The next number, be it on this line or a later one.
  double plain(const char* name) {
    if ((words_ >> std::ws).eof()) next_line(name);
    return number(name);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw UserError(Failure::malformed, path_.string() + ", line " + std::to_string(line_) + ": " + what);
  }

  void next_line(const char* name) {
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

  double number(const char* name) {
    std::string word;
    words_ >> word;
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      fail("expected a number (" + std::string(name) + "), found '" + word + "'");
    return value;
  }

  std::filesystem::path path_;
  std::ifstream file_;
  std::istringstream words_;
  std::size_t line_ = 0;
};

template <std::size_t knots>
void read_knots(NumberReader& reader, std::array<double, knots>& to, const char* name) {
  const double count = reader.plain(name);
  if (count != knots)
    throw UserError(Failure::malformed, std::string(name) + ": expected " + std::to_string(knots) +
                                            " knots, found " + std::to_string(static_cast<long>(count)));
  for (double& knot : to) knot = reader.plain(name);
}

template <std::size_t pieces>
void read_components(NumberReader& reader, std::array<Quintic, pieces>& to, const char* name) {
  for (Quintic& piece : to)
    for (double& coefficient : piece) coefficient = reader.plain(name);
}

}  // namespace

Rebo2Parameters read_rebo2_parameters(const std::filesystem::path& path) {
  NumberReader reader(path);
  reader.require_header();
  Rebo2Parameters parameters = rebo2_parameters();
  const auto for_pairs = [&](const char* name, double PairParameters::*member) {
    for (PairParameters& pair : parameters.pairs) pair.*member = reader.labelled(name);
  };
  const auto for_pairs_and_terms = [&](const char* name, std::array<double, 3> PairParameters::*member) {
    for (PairParameters& pair : parameters.pairs)
      for (double& term : pair.*member) term = reader.labelled(name);
  };
  for_pairs("rcmin", &PairParameters::cutoff_begin);
  for_pairs("rcmax", &PairParameters::cutoff_end);
  for_pairs("rcmaxp", &PairParameters::dihedral_cutoff_end);
  reader.labelled("smin");
  parameters.conjugation_begin = reader.labelled("Nmin");
  parameters.conjugation_end = reader.labelled("Nmax");
  parameters.carbon.few_end = reader.labelled("NCmin");
  parameters.carbon.many_begin = reader.labelled("NCmax");
  for_pairs("Q", &PairParameters::screening);
  for_pairs("alpha", &PairParameters::repulsion_decay);
  for_pairs("A", &PairParameters::repulsion);
  for_pairs_and_terms("BIJc", &PairParameters::attraction);
  for_pairs_and_terms("Beta", &PairParameters::attraction_decay);
  for_pairs("rho", &PairParameters::equilibrium);
  for (const char* unused : {"rcLJmin", "rcLJmax", "bLJmin", "bLJmax", "epsilon", "sigma", "epsilonT"})
    for (int pair = 0; pair < 3; ++pair) reader.labelled(unused);
  read_knots(reader, parameters.carbon.knots, "gC");
  read_components(reader, parameters.carbon.few, "gC1");
  read_components(reader, parameters.carbon.many, "gC2");
  read_knots(reader, parameters.hydrogen.knots, "gH");
  read_components(reader, parameters.hydrogen.pieces, "gH");
  return parameters;
}

}  // namespace nanocarbon::rebo2

// SPDX-License-Identifier: GPL-2.0-or-later
#include "molecule_input.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "nanocarbon/core/error.h"
#include "nanocarbon/core/text_numbers.h"

namespace nanocarbon::cli {

namespace {

// --types takes words up to the next option, FILE too where it stands behind them.
void find_file(MoleculeInput& input) {
  if (input.file.empty() && input.types.size() > 1) {
    input.file = input.types.back();
    input.types.pop_back();
  }
  if (input.file.empty()) throw CLI::RequiredError("FILE");
}

Cell cell_of(const std::string& text) {
  std::string separated = text;
  std::replace(separated.begin(), separated.end(), ',', ' ');
  std::istringstream words(separated);
  std::vector<double> numbers;
  bool all_numbers = true;
  for (std::string word; words >> word;)
    all_numbers &= read_real(word, numbers.emplace_back()) == NumberToken::number;
  Cell cell;
  if (numbers.size() == 3)
    cell.vectors.diagonal() << numbers[0], numbers[1], numbers[2];
  else if (numbers.size() == 9)
    for (int k = 0; k < 9; ++k) cell.vectors(k % 3, k / 3) = numbers[static_cast<std::size_t>(k)];
  if (!all_numbers || (numbers.size() != 3 && numbers.size() != 9) ||
      !(std::abs(cell.vectors.determinant()) > 1))
    throw UserError(Failure::usage,
                    "--cell takes three lengths or three vectors that span a volume, nine numbers, "
                    "in Angstrom, such as '30 30 18.5', not '" +
                        text + "'");
  return cell;
}

}  // namespace

void add_molecule_input(CLI::App& subcommand, MoleculeInput& input) {
  subcommand
      .add_option("FILE", input.file,
                  "LAMMPS data file or text dump, XYZ, extended XYZ, CIF or POSCAR, also compressed with "
                  "gzip; - for standard input")
      ->option_text("TEXT REQUIRED");
  add_read_options(subcommand, input);
  subcommand.parse_complete_callback([&input] { find_file(input); });
}

void add_read_options(CLI::App& subcommand, MoleculeInput& input) {
  subcommand
      .add_option("--types", input.types,
                  "Elements of the file's atom types, if it does not give them: of types 1, 2, ... ('C H'), "
                  "or by number or name ('1=C CA=C')")
      ->type_name("ELEMENTS");
  subcommand
      .add_option("--atom-style", input.atom_style,
                  "LAMMPS atom style of a data file that does not name it (atomic, full, sphere, ...)")
      ->type_name("NAME");
  subcommand.add_option("--boundary", input.boundary,
                        "Which directions are periodic, such as 'p p f'; overrides what the file says");
  subcommand
      .add_option(
          "--cell", input.cell,
          "Cell of an XYZ file that gives none, Angstrom: three lengths ('30 30 18.5') or three vectors, "
          "nine numbers")
      ->type_name("NUMBERS");
}

void add_frame_option(CLI::App& subcommand, MoleculeInput& input) {
  subcommand
      .add_option("--frame", input.frame,
                  "Frame to read from a file with several: 1 is the first (default), -1 the last")
      ->type_name("N");
}

molecule::MoleculeReadOptions read_options(const MoleculeInput& input) {
  molecule::MoleculeReadOptions options{input.types, input.atom_style, std::nullopt, std::nullopt};
  if (!input.cell.empty()) options.cell = cell_of(input.cell);
  if (input.boundary.empty()) return options;
  std::string letters = input.boundary;
  std::erase(letters, ' ');
  if (letters.size() != 3 || letters.find_first_not_of("pfsm") != std::string::npos)
    throw UserError(Failure::usage, "--boundary takes three letters as in LAMMPS, such as 'p p f', not '" +
                                        input.boundary + "'");
  options.periodic.emplace();
  for (std::size_t d = 0; d < 3; ++d) (*options.periodic)[d] = letters[d] == 'p';
  return options;
}

void print_warnings(const MoleculeInput& input, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    fmt::print(stderr, "nanocarbon: warning: {}: {}\n", input.file == "-" ? "standard input" : input.file,
               warning);
}

molecule::MoleculeFrame read_molecule(const MoleculeInput& input) {
  molecule::MoleculeFrame frame = molecule::read_molecule(input.file, read_options(input), input.frame);
  print_warnings(input, frame.warnings);
  return frame;
}

}  // namespace nanocarbon::cli

// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/molecule_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/text_input.h"

namespace nanocarbon::molecule {
namespace {

using Words = std::vector<std::string_view>;
using Lines = std::vector<std::string_view>;

// The first lines, whatever ends them, without blanks at their ends.
Lines first_lines(std::string_view head, std::size_t most) {
  Lines lines;
  if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
  while (!head.empty() && lines.size() < most) {
    const std::size_t end = std::min(head.find_first_of("\r\n"), head.size());
    lines.push_back(trimmed(head.substr(0, end)));
    head.remove_prefix(end);
    if (head.starts_with("\r\n"))
      head.remove_prefix(2);
    else if (!head.empty())
      head.remove_prefix(1);
  }
  return lines;
}

Words words_of(std::string_view line) {
  Words words;
  split_words(line.substr(0, line.find('#')), words);
  return words;
}

bool is_integer(std::string_view word) {
  std::int64_t ignored = 0;
  return parse_integer(word, ignored);
}

bool are_numbers(const Words& words, std::size_t first, std::size_t count) {
  double ignored = 0.0;
  return words.size() >= first + count &&
         std::all_of(words.begin() + static_cast<long>(first),
                     words.begin() + static_cast<long>(first + count),
                     [&](std::string_view word) { return parse_real(word, ignored); });
}

bool are_integers(const Words& words) {
  return !words.empty() && std::all_of(words.begin(), words.end(), is_integer);
}

// Line 2 is the scale, lines 3 to 5 are the vectors, line 6 or 7 has the numbers of atoms. DL_POLY's files begin
// alike, and so do XYZ files whose comment is an energy and whose atoms are atomic numbers.
bool is_poscar(const Lines& lines) {
  if (lines.size() < 7) return false;
  const Words scale = words_of(lines[1]);
  if ((scale.size() != 1 && scale.size() != 3) || !are_numbers(scale, 0, scale.size())) return false;
  if (!std::all_of(lines.begin() + 2, lines.begin() + 5,
                   [](std::string_view line) { return are_numbers(words_of(line), 0, 3); }))
    return false;
  if (are_integers(words_of(lines[0])) && words_of(lines[2]).size() > 3) return false;
  const Words names = words_of(lines[5].substr(0, lines[5].find('!'))),
              counts = words_of(lines[6].substr(0, lines[6].find('!')));
  if (are_integers(names)) return true;
  const bool is_site = names.size() > 1 && is_integer(names[1]) && names.size() != counts.size();
  return are_integers(counts) && !is_site;
}

// CONFIG and REVCON of DL_POLY: two or more whole numbers, then three vectors, a name and its number, a position.
bool is_dl_poly(const Lines& lines) {
  if (lines.size() < 7) return false;
  const Words kinds = words_of(lines[1]);
  if (kinds.size() < 2 || !is_integer(kinds[0]) || !is_integer(kinds[1])) return false;
  for (const std::size_t first : {std::size_t{2}, std::size_t{5}}) {  // without and with vectors
    if (first + 1 >= lines.size()) return false;
    const Words name = words_of(lines[first]), position = words_of(lines[first + 1]);
    if (name.size() >= 2 && !are_numbers(name, 0, 1) && is_integer(name[1]) && are_numbers(position, 0, 3))
      return true;
  }
  return false;
}

// A number of atoms, a comment, and an atom: its name and three numbers, in columns that Properties may move.
bool is_xyz(const Lines& lines, std::size_t first) {
  if (first >= lines.size()) return false;
  const Words count = words_of(lines[first]);
  if (count.size() != 1 || !is_integer(count[0])) return false;
  if (first + 1 < lines.size() && lower_case(lines[first + 1]).find("properties=") != std::string::npos)
    return true;
  if (first + 2 >= lines.size()) return count[0] == "0";
  return are_numbers(words_of(lines[first + 2]), 1, 3);
}

bool is_data(const Lines& lines) {
  bool atoms = false, box = false;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const Words words = words_of(lines[k]);
    if (words.size() == 2 && words[1] == "atoms" && is_integer(words[0])) atoms = true;
    if (words.size() >= 4 && (words[3] == "xhi" || words[3] == "avec")) box = true;
    if (!words.empty() && words[0] == "Atoms") return atoms || box;
  }
  return atoms && box;
}

bool is_cif(const Lines& lines) {
  const auto first = std::find_if(lines.begin(), lines.end(),
                                  [](std::string_view line) { return !line.empty() && line[0] != '#'; });
  if (first == lines.end() || !lower_case(*first).starts_with("data_")) return false;
  return std::any_of(lines.begin(), lines.end(), [](std::string_view line) { return line.starts_with("_"); });
}

// Thermodynamic output may be YAML, too, without atoms.
bool is_yaml_dump(const Lines& lines, std::size_t first) {
  if (first >= lines.size() || lines[first] != "---") return false;
  return std::any_of(lines.begin(), lines.end(),
                     [](std::string_view line) { return line.starts_with("natoms:"); });
}

[[noreturn]] void refuse(const std::string& file, std::string_view what) {
  throw UserError(
      Failure::malformed,
      fmt::format(
          "{}: {}. The formats that are read are LAMMPS data files and text dumps, XYZ, CIF and POSCAR; ASE "
          "makes XYZ of many others, as in: python3 -m ase convert FILE new.xyz, with a Python that has ASE",
          file, what));
}

void refuse_by_kind(std::string_view head, const Lines& lines, const std::string& file) {
  if (head.empty()) refuse(file, "the file is empty");
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff"))
    refuse(file, "the text is UTF-16; save it as UTF-8 or ASCII (iconv -f UTF-16 -t UTF-8)");
  if (head.starts_with("\x28\xb5\x2f\xfd"))
    refuse(file, "it is compressed with zstd; decompress it first, or use gzip");
  if (head.starts_with("BZh")) refuse(file, "it is compressed with bzip2; decompress it first, or use gzip");
  if (head.starts_with("\xfd"
                       "7zXZ"))
    refuse(file, "it is compressed with xz; decompress it first, or use gzip");
  if (head.starts_with("PK\x03\x04")) refuse(file, "it is a zip archive; unpack it first");
  if (head.starts_with("LammpS RestartT"))
    refuse(file,
           "it is a restart file of LAMMPS; write a data file from it (write_data, or lmp -restart2data)");
  if (head.starts_with("- of Ulm")) refuse(file, "it is a trajectory of ASE");
  if (head.starts_with("SQLite format 3")) refuse(file, "it is a database (SQLite), perhaps of ASE");
  if (head.starts_with("CDF") || head.starts_with("\x89HDF")) refuse(file, "it is a NetCDF or HDF5 file");
  const std::string_view beginning = head.substr(0, 64);
  if (beginning.find("DUMPCUSTOM") != std::string_view::npos ||
      beginning.find("DUMPATOM") != std::string_view::npos)
    refuse(file, "it is a binary dump of LAMMPS; turn it into text by LAMMPS's tool binary2txt");
  if (head.size() > 8 && head.substr(4, 4) == "CORD")
    refuse(file, "it is a DCD trajectory, which has no elements; write an XYZ file or a dump instead");
  if (head.find('\0') != std::string_view::npos) refuse(file, "it is a binary file");
  if (head.starts_with("version https://git-lfs"))
    refuse(file, "it is a pointer of Git LFS in place of the file; fetch the file with git lfs pull");
  if (!lines.empty() &&
      (lower_case(lines[0]).starts_with("<!doctype html") || lower_case(lines[0]).starts_with("<html")))
    refuse(file, "it is a web page in place of the file; download the file itself");
  if (is_dl_poly(lines)) refuse(file, "it is a configuration of DL_POLY");
  bool template_atoms = false;
  for (const std::string_view line : lines) {
    if (line.starts_with("!BIOSYM")) refuse(file, "it is a CAR or MDF file of Materials Studio");
    if (line.ends_with("V2000") || line.ends_with("V3000")) refuse(file, "it is a MOL or SDF file");
    if (lower_case(line).starts_with("&force_eval")) refuse(file, "it is input of CP2K");
    if (line.starts_with("vasp.")) refuse(file, "it is an OUTCAR of VASP");
    if (line.starts_with("Number of particles =")) refuse(file, "it is a CFG file of AtomEye");
    if (line == "PRIMVEC" || line == "PRIMCOORD" || line.starts_with("ANIMSTEPS"))
      refuse(file, "it is an XSF file");
    if (line.starts_with("ATOMIC_POSITIONS") || lower_case(line).starts_with("&control"))
      refuse(file, "it is a file of Quantum ESPRESSO");
    if (lower_case(line).starts_with("%block")) refuse(file, "it is input of CASTEP or Siesta");
    template_atoms = template_atoms || line.ends_with(" atoms");
    if (template_atoms && line == "Coords")
      refuse(file, "it is a molecule file of LAMMPS, which has no box; write a data file (write_data)");
    if (line.starts_with("ATOM  ") || line.starts_with("HETATM") || line.starts_with("CRYST1"))
      refuse(file, "it is a PDB file; convert it to XYZ, for example with ASE or OVITO");
    if (line.starts_with("@<TRIPOS>"))
      refuse(file, "it is a mol2 file; convert it to XYZ, for example with Open Babel");
    if (line.starts_with("pair_style ") || line.starts_with("read_data "))
      refuse(file, "it is a LAMMPS script; give the data file that it reads");
  }
  if (!lines.empty() && lines[0].starts_with("<?xml"))
    refuse(file, "it is XML, perhaps of VASP, Materials Studio or CML");
  if (!lines.empty() && lines[0].starts_with("{")) refuse(file, "it is JSON, perhaps of ASE");
  if (!lines.empty() && (lines[0] == "OFF" || lines[0] == "ply" || lines[0].starts_with("solid ")))
    refuse(file, "it is a mesh; make a molecule from it with nanocarbon build");
}

std::optional<MoleculeFormat> format_of_name(std::string file) {
  file = lower_case(file);
  if (file.ends_with(".gz")) file.resize(file.size() - 3);
  const std::size_t slash = file.rfind('/');
  const std::string base = slash == std::string::npos ? file : file.substr(slash + 1);
  const auto ends = [&](std::initializer_list<std::string_view> endings) {
    return std::any_of(endings.begin(), endings.end(), [&](std::string_view e) { return base.ends_with(e); });
  };
  if (ends({".data", ".lmp", ".lammps", ".lmpdat"}) || base.starts_with("data."))
    return MoleculeFormat::lammps_data;
  if (ends({".dump", ".lammpstrj"}) || base.starts_with("dump.")) return MoleculeFormat::lammps_dump;
  if (ends({".yaml", ".yml"})) return MoleculeFormat::lammps_yaml;
  if (ends({".xyz", ".extxyz"})) return MoleculeFormat::xyz;
  if (ends({".cif"})) return MoleculeFormat::cif;
  if (ends({".poscar", ".vasp"}) || base == "poscar" || base == "contcar" || base == "xdatcar")
    return MoleculeFormat::poscar;
  return std::nullopt;
}

}  // namespace

std::string_view name(MoleculeFormat format) {
  constexpr std::string_view names[] = {"LAMMPS data", "LAMMPS dump", "LAMMPS YAML dump",
                                        "XYZ",         "CIF",         "POSCAR"};
  return names[static_cast<std::size_t>(format)];
}

MoleculeFormat recognise_molecule(std::string_view head, const std::string& file) {
  const Lines lines = first_lines(head, 200);
  std::size_t first = 0;
  while (first < lines.size() && lines[first].empty()) ++first;
  if (first < lines.size() && lines[first].starts_with("ITEM:")) return MoleculeFormat::lammps_dump;
  if (is_yaml_dump(lines, first)) return MoleculeFormat::lammps_yaml;
  if (is_poscar(lines)) return MoleculeFormat::poscar;
  if (is_xyz(lines, first)) return MoleculeFormat::xyz;
  if (is_data(lines)) return MoleculeFormat::lammps_data;
  if (is_cif(lines)) return MoleculeFormat::cif;
  refuse_by_kind(head, lines, file);
  if (const auto format = format_of_name(file)) return *format;
  if (first < lines.size() && words_of(lines[first]).size() == 1 && is_integer(words_of(lines[first])[0]))
    return MoleculeFormat::xyz;
  refuse(file, fmt::format("neither its contents nor its name tells the format (it begins with \"{}\")",
                           first < lines.size() ? shown(lines[first]) : ""));
}

}  // namespace nanocarbon::molecule

// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/read_molecule.h"

#include <fmt/format.h>

#include <deque>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/cif_reader.h"
#include "nanocarbon/molecule/formats/distance_warnings.h"
#include "nanocarbon/molecule/formats/lammps_data_reader.h"
#include "nanocarbon/molecule/formats/lammps_dump_reader.h"
#include "nanocarbon/molecule/formats/poscar_reader.h"
#include "nanocarbon/molecule/formats/read_settings.h"
#include "nanocarbon/molecule/formats/text_input.h"
#include "nanocarbon/molecule/formats/xyz_reader.h"

namespace nanocarbon::molecule {

struct MoleculeFile::Reader {
  Reader(ByteSource source, const std::string& name, const MoleculeReadOptions& options)
      : settings{TypeNames(options.types), options.atom_style, options.periodic, options.cell},
        input(std::move(source), name),
        format(recognise_molecule(input.head(), name)) {
    if (!settings.atom_style.empty() && format != MoleculeFormat::lammps_data)
      throw UserError(Failure::usage, fmt::format("--atom-style is for LAMMPS data files; {} is {}", name,
                                                  molecule::name(format)));
    if (settings.cell && format != MoleculeFormat::xyz)
      throw UserError(
          Failure::usage,
          fmt::format("--cell is for XYZ files, which may lack a cell; {} is {}, which gives its own", name,
                      molecule::name(format)));
  }

  std::optional<MoleculeFrame> next() {
    switch (format) {
      case MoleculeFormat::lammps_dump:
        return read_lammps_dump_frame(input, settings);
      case MoleculeFormat::lammps_yaml:
        return read_lammps_yaml_frame(input, settings);
      case MoleculeFormat::xyz:
        return read_xyz_frame(input, settings);
      default:
        break;
    }
    if (!whole_file_read) {
      whole_file_read = true;
      if (format == MoleculeFormat::lammps_data)
        frames.push_back(read_lammps_data(input, settings));
      else
        for (MoleculeFrame& frame :
             format == MoleculeFormat::cif ? read_cif(input, settings) : read_poscar(input, settings))
          frames.push_back(std::move(frame));
    }
    if (frames.empty()) return std::nullopt;
    MoleculeFrame frame = std::move(frames.front());
    frames.pop_front();
    return frame;
  }

  bool more() {
    if (format == MoleculeFormat::lammps_dump || format == MoleculeFormat::lammps_yaml ||
        format == MoleculeFormat::xyz) {
      if (!input.next_line_with_text()) return false;
      input.give_back_line();
      return true;
    }
    return !frames.empty() || !whole_file_read;
  }

  ReadSettings settings;
  TextInput input;
  MoleculeFormat format;
  bool whole_file_read = false;  // of formats that are read so
  std::deque<MoleculeFrame> frames;
};

MoleculeFile::MoleculeFile(const std::filesystem::path& path, const MoleculeReadOptions& options)
    : reader_(std::make_unique<Reader>(open_bytes(path), shown_name(path), options)) {}
MoleculeFile::MoleculeFile(std::string_view contents, const std::string& name,
                           const MoleculeReadOptions& options)
    : reader_(std::make_unique<Reader>(bytes_of(contents), name, options)) {}
MoleculeFile::MoleculeFile(MoleculeFile&&) noexcept = default;
MoleculeFile& MoleculeFile::operator=(MoleculeFile&&) noexcept = default;
MoleculeFile::~MoleculeFile() = default;

MoleculeFormat MoleculeFile::format() const { return reader_->format; }
std::optional<MoleculeFrame> MoleculeFile::next() { return reader_->next(); }
bool MoleculeFile::more() { return reader_->more(); }

std::optional<std::string> MoleculeFile::unused_types() const {
  const TypeNames& types = reader_->settings.types;
  const std::vector<std::string> unused = types.unused();
  if (types.in_order() ? unused.size() < *types.in_order() || unused.empty() : unused.empty())
    return std::nullopt;
  if (types.in_order()) return "--types was not needed: the atoms have names, not numbers";
  return fmt::format("--types names {}, but no atom has that name", fmt::join(unused, ", "));
}

namespace {

[[noreturn]] void too_few_frames(const std::string& name, std::int64_t frame, std::size_t there_are) {
  throw UserError(Failure::unsuitable, fmt::format("{}: there is no frame {}: there {} {}", name, frame,
                                                   there_are == 1 ? "is" : "are", there_are));
}

MoleculeFrame frame_from_start(MoleculeFile& file, const std::string& name, std::int64_t wanted) {
  for (std::int64_t k = 1;; ++k) {
    std::optional<MoleculeFrame> frame = file.next();
    if (!frame) too_few_frames(name, wanted, static_cast<std::size_t>(k - 1));
    if (k == wanted) return std::move(*frame);
  }
}

MoleculeFrame frame_from_end(MoleculeFile& file, const std::string& name, std::int64_t wanted) {
  std::deque<MoleculeFrame> last;
  std::size_t count = 0;
  while (std::optional<MoleculeFrame> frame = file.next()) {
    last.push_back(std::move(*frame));
    if (last.size() > static_cast<std::size_t>(-wanted)) last.pop_front();
    ++count;
  }
  if (count < static_cast<std::size_t>(-wanted)) too_few_frames(name, wanted, count);
  return std::move(last.front());
}

}  // namespace

MoleculeFrame read_molecule(MoleculeFile& file, const std::string& name, std::optional<std::int64_t> frame) {
  const std::int64_t wanted = frame.value_or(1);
  if (wanted == 0)
    throw UserError(Failure::usage, "--frame counts from 1, or from the end with -1 as the last");
  MoleculeFrame result =
      wanted > 0 ? frame_from_start(file, name, wanted) : frame_from_end(file, name, wanted);
  if (result.molecule.size() == 0) throw UserError(Failure::unsuitable, name + ": there are no atoms in it");
  if (!frame && file.more())
    result.warnings.push_back(
        "there are more frames in the file; this is the first (--frame N reads another, -1 the last)");
  if (const auto unused = file.unused_types()) result.warnings.push_back(*unused);
  for (std::string& warning : distance_warnings(result, name)) result.warnings.push_back(std::move(warning));
  return result;
}

MoleculeFrame read_molecule(const std::filesystem::path& path, const MoleculeReadOptions& options,
                            std::optional<std::int64_t> frame) {
  MoleculeFile file(path, options);
  return read_molecule(file, shown_name(path), frame);
}

}  // namespace nanocarbon::molecule

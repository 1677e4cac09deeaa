// SPDX-License-Identifier: GPL-2.0-or-later
// The way in for molecules from files of any format: read_molecule for one, MoleculeFile for all of a trajectory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "nanocarbon/molecule/formats/molecule_format.h"
#include "nanocarbon/molecule/formats/molecule_frame.h"

namespace nanocarbon::molecule {

//! \brief A file of molecules, read frame by frame; only one is in memory at a time.
//!
//!     MoleculeFile file("run.lammpstrj.gz", {.types = {"C", "H"}});
//!     while (const auto frame = file.next()) look_at(frame->molecule, frame->step);
//!
//! \details What is read: LAMMPS data files and text dumps, XYZ and extended XYZ, CIF, POSCAR, also packed by gzip,
//! and from standard input (`-`). The contents tell the format, the name only where they do not. Elements come
//! from the file (masses, labels, names) or the options, never from a guess.
class MoleculeFile {
 public:
  //! \throw UserError (unreadable; malformed for kinds that are not read; usage for options that cannot be)
  explicit MoleculeFile(const std::filesystem::path& path, const MoleculeReadOptions& options = {});
  //! From memory, which must stay as long as the object. The name is for messages.
  MoleculeFile(std::string_view contents, const std::string& name, const MoleculeReadOptions& options = {});
  MoleculeFile(MoleculeFile&&) noexcept;
  MoleculeFile& operator=(MoleculeFile&&) noexcept;
  ~MoleculeFile();

  MoleculeFormat format() const;
  //! \brief The next frame; nothing after the last.
  //! \throw UserError (malformed, naming the file, the line and what stands there; unsuitable for other elements and
  //! for types that nothing tells the element of)
  std::optional<MoleculeFrame> next();
  //! Whether anything follows the frames that have been read.
  bool more();
  //! What the options say but no frame so far has: a warning, or nothing.
  std::optional<std::string> unused_types() const;

 private:
  struct Reader;
  std::unique_ptr<Reader> reader_;
};

//! \brief One frame of a file, with what to know about it before trusting numbers in its warnings: other frames that
//! there are, names in the options that no atom has, and distances that no such structure has (distance_warnings).
//! \param frame from 1; negative from the end, -1 being the last; nothing for the first
//! \throw UserError as MoleculeFile; unsuitable where there are fewer frames or no atoms, and for atoms that are
//! all in the same place; usage for frame 0
MoleculeFrame read_molecule(const std::filesystem::path& path, const MoleculeReadOptions& options = {},
                            std::optional<std::int64_t> frame = {});
//! The same from an open file whose frames have not been read yet.
MoleculeFrame read_molecule(MoleculeFile& file, const std::string& name,
                            std::optional<std::int64_t> frame = {});

}  // namespace nanocarbon::molecule

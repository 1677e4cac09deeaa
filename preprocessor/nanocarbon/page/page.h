// SPDX-License-Identifier: GPL-2.0-or-later
// One HTML file that shows a molecule: no network, nothing beside it.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::page {

//! A value of each atom, to colour by and to read.
struct PageColumn {
  std::string name;
  std::string unit;
  //! How whole numbers are shown: ring (its size), element (0 carbon, 1 hydrogen), bonds, state (0, 1, 2) or defect
  //! (0, 1); empty for a scale.
  std::string category;
  std::vector<float> values;  //!< not-a-number where not defined; of categories 0 to 255
};

//! One structure. All frames have the same columns.
struct PageFrame {
  std::string label;
  Molecule molecule;  //!< with bonds, and rings where they are to be shown
  std::vector<PageColumn> columns;
};

struct PagePlot {
  std::string title, label;   //!< what it shows, and what its horizontal axis is
  bool bars = true;           //!< else a line
  bool ring_colours = false;  //!< x are sizes of rings
  double width = 1.0;         //!< of bars, which begin at x
  std::vector<double> x, y;
};

//! Atoms of the last frame to be found by a click.
struct PagePlace {
  std::string kind;
  std::vector<AtomIndex> atoms;
};

enum class Mood { good, doubt, bad };

struct PageContents {
  std::string title, command, verdict;
  Mood mood = Mood::good;  //!< of the verdict
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<PagePlot> plots;
  std::vector<PageFrame> frames;  //!< at least one
  std::vector<std::int64_t> ids;  //!< of the last frame's atoms; empty: 1, 2, ...
  std::vector<PagePlace> defects;
  std::optional<TriangleMesh> mesh;  //!< the surface, where the molecule is
  std::size_t colour_column = 0;     //!< coloured by at first
};

//! \brief Writes a page.
//! \details Positions of a single frame are floats; of several they are quantised to a 65,535th of the frame's size, as
//! are columns that are scales to their range. A mesh of more than 300,000 triangles is left out, which a fact says.
//! \throw UserError (unsuitable) where the program was built without three.js
void write_page(std::ostream& out, const PageContents& contents);

//! \throw UserError as write_page, to be called before work is done
void require_pages();

}  // namespace nanocarbon::page

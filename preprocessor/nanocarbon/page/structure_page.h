// SPDX-License-Identifier: GPL-2.0-or-later
// Pages of what an analysis has found.
#pragma once

#include "nanocarbon/analysis/analysis_report.h"
#include "nanocarbon/page/page.h"

namespace nanocarbon::page {

//! \brief A frame with all columns of an analysis; rings are those that it found.
//! \param distances of the atoms to a surface, Angstrom, to be shown as well; empty: none
PageFrame structure_frame(const Molecule& molecule, const analysis::Analysis& analysis,
                          std::span<const analysis::AtomFate> fates, const std::string& label,
                          std::span<const double> distances = {});

//! Facts, defects and plots of an analysis of the last frame.
void add_analysis(PageContents& contents, const Molecule& molecule, std::span<const std::int64_t> ids,
                  const analysis::Analysis& analysis, std::span<const double> distances = {});

//! Plots of how a trajectory went on, and its verdict.
void add_trajectory(PageContents& contents, std::span<const analysis::FrameSummary> frames);

//! \brief Which frames of a trajectory a page shows: as many as 1,000,000 atoms in all allow, at most 100, evenly.
//! \details Frames are offered one by one, and how many will come is not known; every second of those kept is dropped
//! whenever they become too many. The last one offered is always there.
class PageFrames {
 public:
  void offer(PageFrame frame);
  std::size_t offered() const { return offered_; }
  std::vector<PageFrame> take();

 private:
  std::vector<PageFrame> kept_;
  std::vector<PageFrame> last_;  // one, where it is not among those kept
  std::size_t offered_ = 0, stride_ = 1;
};

}  // namespace nanocarbon::page

// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/page/structure_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace nanocarbon::page {
namespace {

template <typename Value>
PageColumn column(const char* name, const char* unit, const char* category, std::size_t count,
                  const Value& value) {
  PageColumn result{name, unit, category, std::vector<float>(count)};
  for (AtomIndex a = 0; a < count; ++a) result.values[a] = static_cast<float>(value(a));
  return result;
}

void add_bars(PageContents& contents, const char* title, const char* label, const analysis::Distribution& d) {
  if (d.histogram.counts.empty()) return;
  PagePlot plot{title, label, true, false, d.histogram.width, {}, {}};
  for (std::size_t k = 0; k < d.histogram.counts.size(); ++k) {
    plot.x.push_back(d.histogram.from + static_cast<double>(k) * d.histogram.width);
    plot.y.push_back(static_cast<double>(d.histogram.counts[k]));
  }
  contents.plots.push_back(std::move(plot));
}

std::string topology_text(const analysis::MoleculeComponents& components) {
  if (!components.all_surfaces() || components.surface.problem) {
    const auto fault =
        std::find_if(components.list.begin(), components.list.end(),
                     [](const analysis::MoleculeComponent& component) { return !component.is_surface(); });
    return "no surface: " + fault->not_a_surface;
  }
  return fmt::format("{}, genus {}, Euler characteristic {}, boundary loops {}",
                     components.surface.orientable ? "orientable" : "one-sided", components.surface.genus,
                     components.surface.euler_characteristic, components.surface.boundary_loops);
}

}  // namespace

PageFrame structure_frame(const Molecule& molecule, const analysis::Analysis& analysis,
                          std::span<const analysis::AtomFate> fates, const std::string& label,
                          std::span<const double> distances) {
  PageFrame frame{label, molecule, {}};
  frame.molecule.rings = analysis.components.rings;
  const std::size_t n = molecule.size();
  std::vector<std::uint8_t> in_defect(n, 0);
  for (const analysis::Defect& defect : analysis.defects)
    for (const AtomIndex a : defect.atoms) in_defect[a] = 1;
  // The ring farthest from a hexagon says most.
  const auto ring = [&](AtomIndex a) {
    std::size_t size = 0;
    for (const std::uint32_t r : analysis.rings_of_atoms.of(a)) {
      const std::size_t s = analysis.components.rings[r].size();
      const auto off = [](std::size_t x) { return x > 6 ? x - 6 : 6 - x; };
      if (size == 0 || off(s) > off(size)) size = s;
    }
    return size;
  };
  auto& c = frame.columns;
  c.push_back(column("ring", "", "ring", n, ring));
  c.push_back(column("element", "", "element", n,
                     [&](AtomIndex a) { return molecule.elements[a] == Element::carbon ? 0 : 1; }));
  c.push_back(column("bonds", "", "bonds", n, [&](AtomIndex a) { return analysis.rows.degree(a); }));
  c.push_back(column("state", "", "state", n,
                     [&](AtomIndex a) { return a < fates.size() ? static_cast<int>(fates[a]) : 0; }));
  c.push_back(column("defect", "", "defect", n, [&](AtomIndex a) { return in_defect[a]; }));
  const analysis::AtomGeometry& g = analysis.geometry;
  c.push_back(column("pyramidalisation", "°", "", n, [&](AtomIndex a) { return g.pyramidalisation[a]; }));
  c.push_back(column("mean curvature", "1/Å", "", n, [&](AtomIndex a) { return g.mean_curvature[a]; }));
  c.push_back(
      column("Gaussian curvature", "1/Å²", "", n, [&](AtomIndex a) { return g.gaussian_curvature[a]; }));
  if (!analysis.atom_energies.empty())
    c.push_back(column("energy", "eV", "", n, [&](AtomIndex a) { return analysis.atom_energies[a]; }));
  if (!distances.empty())
    c.push_back(column("distance to surface", "Å", "", n, [&](AtomIndex a) { return distances[a]; }));
  return frame;
}

void add_analysis(PageContents& contents, const Molecule& molecule, std::span<const std::int64_t> ids,
                  const analysis::Analysis& analysis, std::span<const double> distances) {
  constexpr std::size_t most_defects = 400;  // buttons in a page
  const analysis::BondDistributions& b = analysis.bonds;
  const auto fact = [&](const char* name, const std::string& value) {
    contents.facts.emplace_back(name, value);
  };
  fact("atoms", fmt::format("{} carbon, {} hydrogen", b.carbons, b.hydrogens));
  fact("bonds", std::to_string(molecule.bonds.size()));
  if (b.carbon_carbon.spread.count > 0)
    fact("C–C, Å", fmt::format("{:.3f} to {:.3f}, mean {:.4f}", b.carbon_carbon.spread.min,
                               b.carbon_carbon.spread.max, b.carbon_carbon.spread.mean));
  fact("sp, sp², sp³", fmt::format("{:.1f}%, {:.1f}%, {:.1f}%", 100 * b.share_with(2), 100 * b.share_with(3),
                                   100 * b.share_with(4)));
  fact("pieces", std::to_string(analysis.components.list.size()));
  fact("surface", topology_text(analysis.components));
  if (analysis.energy)
    fact("energy", fmt::format("{:.5f} eV an atom ({})",
                               *analysis.energy / static_cast<double>(molecule.size()), analysis.potential));
  fact("defects", std::to_string(analysis.defects.size()));
  if (analysis.defects.size() > most_defects)
    fact("listed", fmt::format("the first {} of them", most_defects));
  for (std::size_t k = 0; k < std::min(analysis.defects.size(), most_defects); ++k)
    contents.defects.push_back({analysis.defects[k].kind, analysis.defects[k].atoms});
  contents.ids.assign(ids.begin(), ids.end());

  PagePlot rings{"Rings", "atoms in a ring", true, true, 1.0, {}, {}};
  for (std::size_t size = 0; size < analysis.components.ring_counts.size(); ++size)
    if (analysis.components.ring_counts[size] > 0 || (!rings.x.empty() && size <= 8)) {
      rings.x.push_back(static_cast<double>(size));
      rings.y.push_back(static_cast<double>(analysis.components.ring_counts[size]));
    }
  if (!rings.x.empty()) contents.plots.push_back(std::move(rings));
  add_bars(contents, "Carbon-carbon bonds", "Å", b.carbon_carbon);
  add_bars(contents, "Angles", "degrees", b.angles);
  add_bars(contents, "Mean curvature", "1/Å", analysis.mean_curvature);
  if (!analysis.atom_energies.empty())
    add_bars(contents, "Energy of the atoms", "eV", analysis::distribution(analysis.atom_energies, 0.02));
  if (!distances.empty())
    add_bars(contents, "Distance of the atoms to the surface", "Å", analysis::distribution(distances, 0.1));
}

void add_trajectory(PageContents& contents, std::span<const analysis::FrameSummary> frames) {
  if (frames.size() < 2) return;
  const analysis::FrameChange& change = frames.back().change;
  contents.verdict = std::string(topology::name(change.verdict));
  if (change.verdict == topology::Verdict::homeomorphic) contents.mood = Mood::doubt;
  if (change.verdict == topology::Verdict::broken || change.verdict == topology::Verdict::not_a_surface)
    contents.mood = Mood::bad;
  if (!change.reason.empty()) contents.facts.emplace_back("verdict", change.reason);
  contents.facts.emplace_back("since the start",
                              fmt::format("{} bonds broken, {} formed, {} atoms repelled, {} lost",
                                          change.changes.broken.size(), change.changes.formed.size(),
                                          change.repelled.size() - change.lost.size(), change.lost.size()));
  const bool steps =
      std::all_of(frames.begin(), frames.end(), [](const auto& f) { return f.step.has_value(); });
  const auto line = [&](const char* title, const auto& value) {
    PagePlot plot{title, steps ? "time step" : "frame", false, false, 1.0, {}, {}};
    for (std::size_t k = 0; k < frames.size(); ++k) {
      plot.x.push_back(steps ? static_cast<double>(*frames[k].step) : static_cast<double>(k + 1));
      plot.y.push_back(value(frames[k]));
    }
    contents.plots.push_back(std::move(plot));
  };
  using Summary = analysis::FrameSummary;
  if (std::all_of(frames.begin(), frames.end(), [](const Summary& f) { return f.energy.has_value(); }))
    line("Energy on the way, eV an atom",
         [](const Summary& f) { return *f.energy / static_cast<double>(f.atoms); });
  line("Bonds broken or formed on the way", [](const Summary& f) {
    return static_cast<double>(f.change.changes.broken.size() + f.change.changes.formed.size());
  });
  line("Mean bond on the way, Å", [](const Summary& f) { return f.bond_mean; });
}

void PageFrames::offer(PageFrame frame) {
  constexpr std::size_t most_atoms = 1000000, most_frames = 100;
  const std::size_t room =
      std::clamp<std::size_t>(most_atoms / std::max<std::size_t>(1, frame.molecule.size()), 2, most_frames);
  const bool wanted = offered_++ % stride_ == 0;
  last_.clear();
  if (!wanted) {
    last_.push_back(std::move(frame));
    return;
  }
  kept_.push_back(std::move(frame));
  if (kept_.size() <= room) return;
  last_.push_back(kept_.back());
  std::vector<PageFrame> every_second;
  for (std::size_t k = 0; k < kept_.size(); k += 2) every_second.push_back(std::move(kept_[k]));
  if (kept_.size() % 2 == 1) last_.clear();
  kept_ = std::move(every_second);
  stride_ *= 2;
}

std::vector<PageFrame> PageFrames::take() {
  for (PageFrame& frame : last_) kept_.push_back(std::move(frame));
  return std::move(kept_);
}

}  // namespace nanocarbon::page

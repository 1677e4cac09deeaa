// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/lj/lj_own_list.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "nanocarbon/potential/airebo/lj/box_tree.h"
#include "nanocarbon/potential/airebo/lj/compact_order.h"

namespace nanocarbon::airebo {

namespace {

using Image = std::array<std::int32_t, 3>;
constexpr Image home = {0, 0, 0};

Image operator+(Image a, const Image& b) {
  for (int d = 0; d < 3; ++d) a[d] += b[d];
  return a;
}

Image operator-(const Image& a) { return {-a[0], -a[1], -a[2]}; }

//! An image of an atom.
struct Site {
  std::uint32_t atom;
  Image image;  // to be added to the position as given
};

//! The images that bring atoms into the cell.
std::vector<Image> home_images(std::span<const Vec3> positions, const Cell* cell) {
  std::vector<Image> images(positions.size(), home);
  if (!cell) return images;
  const Mat3 to_fractional = cell->vectors.inverse();
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Vec3 f = to_fractional * (positions[i] - cell->origin);
    for (int d = 0; d < 3; ++d)
      if (cell->periodic[d]) images[i][d] = -static_cast<std::int32_t>(std::floor(f[d]));
  }
  return images;
}

//! Images in half of all directions that may be within reach of an atom in the cell.
std::vector<Site> border_sites(std::span<const Vec3> positions, const Cell& cell,
                               const std::vector<Image>& homes, double reach) {
  const Vec3 heights = face_distances(cell);
  const Mat3 to_fractional = cell.vectors.inverse();
  std::vector<Vec3> fractional(positions.size());
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    fractional[i] = to_fractional * (positions[i] + image_shift(cell, homes[i]) - cell.origin);
    low = low.cwiseMin(fractional[i]);
    high = high.cwiseMax(fractional[i]);
  }
  Image most = home;
  Vec3 room;
  for (int d = 0; d < 3; ++d) {
    room[d] = reach / heights[d] * (1.0 + 1e-12);
    if (cell.periodic[d]) most[d] = static_cast<std::int32_t>(std::ceil(room[d] + high[d] - low[d]));
  }
  std::vector<Site> sites;
  Image n;
  for (n[0] = 0; n[0] <= most[0]; ++n[0])
    for (n[1] = -most[1]; n[1] <= most[1]; ++n[1])
      for (n[2] = -most[2]; n[2] <= most[2]; ++n[2]) {
        if (n <= home) continue;
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
          bool near = true;
          for (int d = 0; d < 3; ++d) {
            const double f = fractional[i][d] + n[d];
            near = near && f >= low[d] - room[d] && f <= high[d] + room[d];
          }
          if (near) sites.push_back({i, homes[i] + n});
        }
      }
  return sites;
}

//! Gives sites their order and clusters.
class Arrangement {
 public:
  Arrangement(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
              LjLists& lists)
      : positions_(positions), elements_(elements), cell_(cell), lists_(lists) {
    number(home);
  }

  void add(const std::vector<Site>& group) {
    std::vector<Vec3> points(group.size());
    for (std::size_t s = 0; s < group.size(); ++s) points[s] = place(group[s]);
    std::vector<std::uint32_t> atoms, images;
    for (const std::uint32_t s : compact_order(points, lj_lanes)) {
      atoms.push_back(group[s].atom);
      images.push_back(number(group[s].image));
    }
    sites_.add(atoms, images, elements_);
  }

  const LjSites& sites() const { return sites_; }

  //! Boxes around clusters [begin, end).
  std::vector<Box> boxes(std::uint32_t begin, std::uint32_t end) const {
    std::vector<Box> result;
    for (std::uint32_t c = begin; c < end; ++c) {
      Box box = {Vec3::Constant(INFINITY), Vec3::Constant(-INFINITY)};
      for (std::size_t s = lj_lanes * std::size_t{c}; s < lj_lanes * (std::size_t{c} + 1); ++s) {
        const Vec3 p = place({sites_.atoms[s], lists_.images[sites_.images[s]]});
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
      }
      result.push_back(box);
    }
    return result;
  }

 private:
  Vec3 place(const Site& site) const {
    return cell_ ? Vec3(positions_[site.atom] + image_shift(*cell_, site.image)) : positions_[site.atom];
  }

  std::uint32_t number(const Image& image) {
    const auto [at, is_new] = numbers_.try_emplace(image, static_cast<std::uint32_t>(numbers_.size()));
    if (is_new) lists_.images.push_back(image);
    return at->second;
  }

  std::span<const Vec3> positions_;
  std::span<const Element> elements_;
  const Cell* cell_;
  LjLists& lists_;
  LjSites sites_;
  std::map<Image, std::uint32_t> numbers_;
};

//! Pairs of sites for pairs of atoms and images; those out of reach are not there.
LjExcluded find_excluded(const NeighbourList& exclusions, const std::vector<Image>& homes,
                         const LjSites& sites, const std::vector<Image>& images) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  if (!exclusions.neighbours.empty()) {
    std::vector<std::uint32_t> offsets(homes.size() + 1, 0);
    const auto for_all_sites = [&](const auto& action) {
      for (std::uint32_t s = 0; s < sites.atoms.size(); ++s)
        if (sites.real[s / lj_lanes] >> s % lj_lanes & 1) action(sites.atoms[s], s);
    };
    for_all_sites([&](std::uint32_t atom, std::uint32_t) { ++offsets[atom + 1]; });
    for (std::size_t a = 0; a < homes.size(); ++a) offsets[a + 1] += offsets[a];
    std::vector<std::uint32_t> sites_of(offsets.back()), next(offsets.begin(), offsets.end() - 1);
    for_all_sites([&](std::uint32_t atom, std::uint32_t s) { sites_of[next[atom]++] = s; });
    const auto find = [&](std::uint32_t atom, const Image& image, auto action) {
      for (std::uint32_t k = offsets[atom]; k < offsets[atom + 1]; ++k)
        if (images[sites.images[sites_of[k]]] == image) action(sites_of[k]);
    };
    for (std::uint32_t i = 0; i < exclusions.atoms(); ++i)
      for (const Neighbour& n : exclusions.of(i)) {
        // With the atoms in the cell; the end from which the other lies ahead is at home.
        const Image step = homes[i] + n.image + -homes[n.atom];
        const bool ahead = step >= home;
        const std::uint32_t a = ahead ? i : n.atom, b = ahead ? n.atom : i;
        find(a, homes[a], [&](std::uint32_t from) {
          find(b, homes[b] + (ahead ? step : -step), [&](std::uint32_t to) { pairs.push_back({from, to}); });
        });
      }
  }
  return LjExcluded(std::move(pairs), sites.atoms.size());
}

void add_rows(LjListBuilder& builder, const Arrangement& arrangement, std::uint32_t own_clusters,
              double reach) {
  const LjSites& sites = arrangement.sites();
  const BoxTree own(arrangement.boxes(0, own_clusters));
  const BoxTree border(arrangement.boxes(own_clusters, sites.clusters()));
  std::vector<std::uint32_t> found;
  std::vector<LjListBuilder::Partner> partners;
  for (std::uint32_t c = 0; c < own_clusters; ++c) {
    found.clear();
    own.find(own[c], reach, c, found);
    const std::size_t own_found = found.size();
    border.find(own[c], reach, 0, found);
    for (std::size_t k = own_found; k < found.size(); ++k) found[k] += own_clusters;
    for (std::uint32_t lane = 0; lane < lj_lanes; ++lane) {
      if (!(sites.real[c] >> lane & 1)) continue;
      partners.clear();
      for (const std::uint32_t other : found) {
        const std::uint32_t real = sites.real[other];
        const std::uint32_t mask = other == c ? real & ~((2u << lane) - 1u) : real;
        if (mask != 0) partners.push_back({other, mask});
      }
      builder.add_row(lj_lanes * c + lane, partners);
    }
  }
}

}  // namespace

LjLists find_lists(std::span<const Vec3> positions, std::span<const Element> elements, const Cell* cell,
                   const NeighbourList& exclusions, const LjParameters& parameters, const LjKernel& kernel,
                   const LjOwnListOptions& options) {
  double reach = 0.0;
  for (std::size_t pair = 0; pair < 3; ++pair)
    reach = std::max(reach, lj_reach(parameters, pair) + options.margin);
  const std::vector<Image> homes = home_images(positions, cell);
  std::vector<Site> own(positions.size());
  for (std::uint32_t i = 0; i < own.size(); ++i) own[i] = {i, homes[i]};

  LjLists arranged;
  Arrangement arrangement(positions, elements, cell, arranged);
  arrangement.add(own);
  const std::uint32_t own_clusters = arrangement.sites().clusters();
  if (cell && !positions.empty()) arrangement.add(border_sites(positions, *cell, homes, reach));
  const LjExcluded excluded = find_excluded(exclusions, homes, arrangement.sites(), arranged.images);

  const std::vector<Vec3> moves = translations(arranged, cell);
  LjRowBuffer buffer;
  const auto take_rows = [&](LjChunk& chunk, std::span<const LjRow> rows, std::span<const LjEntry> entries) {
    place_atoms(chunk, positions.front().data(), moves);
    list_rows(chunk, rows, entries, kernel, parameters, options.margin, buffer);
  };
  LjListBuilder builder(arrangement.sites(), excluded, own.size(), options.chunk_clusters, take_rows);
  add_rows(builder, arrangement, own_clusters, reach);
  LjLists lists = builder.finish(positions.size());
  lists.images = std::move(arranged.images);
  lists.margin = options.margin;
  return lists;
}

std::vector<Vec3> translations(const LjLists& lists, const Cell* cell) {
  std::vector<Vec3> result;
  for (const Image& image : lists.images)
    result.push_back(image == home ? Vec3(Vec3::Zero()) : image_shift(*cell, image));
  return result;
}

}  // namespace nanocarbon::airebo

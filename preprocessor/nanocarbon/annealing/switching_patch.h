// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/annealing/network_edit.h"

namespace nanocarbon::annealing {

//! An intermediate molecule: bond graph, positions and the planes it is tethered to, entry by entry.
struct SwitchingState {
  TrivalentNetwork network;
  std::vector<Vec3> positions;
  std::vector<TangentPlane> planes;
  std::vector<TangentPlane> edges = {};  //!< at the boundary (boundary_curve.h); empty where there is none
  double reach = -open_atom_depth;  //!< of open atoms beyond these; as of the last relaxation of the whole
  Space space = {};                 //!< of the positions
  double tether = 0.05;             //!< eV/Angstrom^2
  bool free_mean = true;            //!< of the heights above the surface, see add_tether()
  double mean_height = 0;   //!< Angstrom, where the tether is at rest; as of the last relaxation of the whole
  StericContacts contacts;  //!< as of the last relaxation of the whole
  Running running = {};     //!< of relaxations of the whole
};

//! \brief The surroundings of a bond switch, copied so that trials can run side by side on one state.
//! \details Atoms within `radius` bonds of the switch are free, three more shells are held and complete the
//! energy of every bond that free atoms can change.
class SwitchingPatch {
 public:
  //! Copies the surroundings of an edit.
  void gather(const SwitchingState& state, const NetworkEdit& edit, unsigned radius);

  //! Takes over positions from a smaller patch of the same edit, after both have applied it.
  void take_positions(const SwitchingPatch& smaller);

  void apply(const NetworkEdit& edit);  //!< makes the edit on the copy, with first positions for its atoms
  double energy();                      //!< eV, of the bonds and free atoms of the patch
  std::size_t energy_atoms() const;     //!< whose bonds that energy is of
  double energy_and_gradient(std::span<const Vec3> free, std::span<Vec3> gradient);
  void relax_springs(int iterations);
  minimisation::LbfgsResult relax(const minimisation::LbfgsOptions& options);

  //! Whether every free atom still faces outward, as the surface's normal does there.
  bool unfolded(double least_cosine) const;

  std::size_t free_count() const { return free_; }
  AtomIndex atom(std::size_t local) const {
    return global_[local];
  }  //!< added_atoms for those that the edit adds
  std::size_t size() const { return global_.size(); }
  // Of the image that the state has.
  Vec3 position(std::size_t local) const { return positions_[local] - shifts_[local]; }
  TangentPlane plane(std::size_t local) const { return back(planes_[local], local); }
  TangentPlane edge(std::size_t local) const { return back(edges_[local], local); }

 private:
  struct Contact {
    std::uint32_t local;
    Vec3 other;                 // where the other atom is held, or what leads to its image from
    std::uint32_t other_local;  // its own entry, if that is below free_
  };
  std::vector<AtomIndex> global_;
  std::vector<std::uint32_t> distance_;  // bonds from the switch
  std::vector<AtomIndex> local_of_;      // by global atom, no_atom outside; restored after each gather
  std::vector<TrivalentAtom> atoms_;
  // In a cell the image beside the atoms nearer to the switch, so that bonds hardly ever lead to another image. Each
  // lies this far from where the state has it.
  std::vector<Vec3> positions_, shifts_;
  std::vector<Vec3> gradient_;
  std::vector<TangentPlane> planes_, edges_;
  std::vector<Contact> contacts_;
  Space space_;           // of the state
  FixedBondGraph graph_;  // in free space where no bond leads to another image
  FixedBondRebo2 rebo2_;
  std::size_t free_ = 0;  // the last of these are the atoms that the edit adds
  std::size_t added_ = 0;
  unsigned radius_ = 0;
  double tether_ = 0;
  double mean_height_ = 0, reach_ = 0;

  void list_bonds();
  void list_contacts(const SwitchingState& state);
  void place_flipped(AtomIndex i, AtomIndex j);
  void place_added(AtomIndex u, AtomIndex w);
  void place_outside(std::uint32_t polygon);
  AtomIndex local(AtomIndex global) const;
  bool has_bonds_to_images() const;
  TangentPlane back(const TangentPlane& plane, std::size_t local) const {
    return {plane.point - shifts_[local], plane.normal};
  }
};

}  // namespace nanocarbon::annealing

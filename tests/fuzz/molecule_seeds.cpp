// SPDX-License-Identifier: GPL-2.0-or-later
#include "fuzz/seeds.h"

namespace nanocarbon::test {
namespace {

// LAMMPS data files: each kind of box, sections before and after the atoms, elements by mass, label and comment.
void add_data(std::vector<Seed>& seeds) {
  seeds.push_back(
      {"a.data",
       "benzene's half\n\n3 atoms\n2 atom types\n0 5 xlo xhi\n0 5.5 ylo yhi\n-1 6e0 zlo zhi\n\nMasses\n\n"
       "1 12.011 # C\n2 1.008 # H\n\nAtoms # atomic\n\n1 1 0 0 0 0 0 0\n2 1 1.4 0.1 0 1 0 -1\n3 2 2.4 1 0 0 "
       "0 0\n\nVelocities\n\n1 0 0 0\n2 0 0 0\n3 0.1 0 0\n"});
  seeds.push_back(
      {"b.data",
       "# made by hand\n2 atoms\n1 bonds\n2 atom types\n1 bond types\n0 angles\n2 extra bond per atom\n0.0 4 "
       "xlo xhi\n0.0 4 ylo yhi\n0 4 zlo zhi\n0.5 -0.25 1 xy xz yz\n\nAtom Type Labels\n\n1 C\n2 hc\n\n"
       "Masses\n\nC 12\nhc 1.0\n\nPair Coeffs # lj/cut\n\n1 1 1\n2 1 1\n\nAtoms # full\n\n"
       "10 1 C -0.1 0 0 0\n7 1 hc 0.1 1.1 0 0\n\nBonds\n\n1 1 10 7\n\n"});
  seeds.push_back(
      {"c.data",
       "general cell\n\n1 atoms\n1 atom types\n3 0 0 avec\n0 3 0 bvec\n0.5 0 3 cvec\n0 0 0 abc origin\n\n"
       "Masses\n\n1 12.0107\n\nAtoms # charge\n\n1 1 0.5 1 2 2.5\n"});
  seeds.push_back(
      {"d.data",
       "# boundary p p f\r\n\r\n1 atoms\r\n2 atom types\r\n0 3 xlo xhi\r\n0 3 ylo yhi\r\n0 3 zlo zhi\r\n\r\n"
       "Masses\r\n\r\n1 12\r\n2 1\r\n\r\nAtoms # hybrid sphere\r\n\r\n1 1 0.5 1.5 1 2 2.5\t\r\n"});
}

// Text dumps: boxes and columns of each kind, and several frames.
void add_dumps(std::vector<Seed>& seeds) {
  seeds.push_back(
      {"a.dump",
       "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 5\n0 5e+00\n-1 6\n"
       "ITEM: ATOMS id type element x y z ix iy iz\n1 1 C 0 0 0 0 0 0\n2 2 H 1.1 0 0 1 -1 0\n"
       "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 5\n0 5\n-1 6\n"
       "ITEM: ATOMS id type element x y z ix iy iz\n2 2 H 1.2 0 0 1 -1 0\n1 1 C 0 0 0.1 0 0 0\n"});
  seeds.push_back({"b.dump",
                   "ITEM: UNITS\nmetal\nITEM: TIME\n0.5\nITEM: TIMESTEP\n500\nITEM: NUMBER OF ATOMS\n2\n"
                   "ITEM: BOX BOUNDS xy xz yz pp pp pp\n-0.5 5.5 0.5\n0 5 -0.25\n0 6 1\n"
                   "ITEM: ATOMS type mass xs ys zs vx\n1 12.011 0.1 0.2 0.3 0\n2 1.008 0.9 0.99 1 1\n"});
  seeds.push_back(
      {"c.dump",
       "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp ss mm\n4 0 0 0\n0 4 0 0\n"
       "1 0 4 0\nITEM: ATOMS id typelabel xu yu zu\n1 C 0 0 9\n"});
}

// Dumps in YAML: two frames, a tilted box, thermodynamic output among it, columns in quotes.
void add_yaml(std::vector<Seed>& seeds) {
  seeds.push_back(
      {"a.yaml",
       "---\ncreator: LAMMPS\ntimestep: 0\nunits: metal\ntime: 0\nnatoms: 2\nboundary: [ p, p, p, p, f, f, "
       "]\n"
       "thermo:\n  - keywords: [ Step, Temp, ]\n  - data: [ 0, 300, ]\nbox:\n  - [ -0.5, 5.5 ]\n  - [ 0, 5 "
       "]\n"
       "  - [ 0, 6 ]\n  - [ 0.5, 0, -0.25 ]\nkeywords: [ id, type, mass, x, y, z, 'c_pe[1]',  ]\ndata:\n"
       "  - [ 1 , 1 , 12.011 , 0 , 0 , 0 , -7.4 , ]\n  - [ 2 , 2 , 1.008 , 1.1 , 0 , 0 , -3 , ]\n...\n"
       "---\ntimestep: 5\nnatoms: 1\nbox:\n  - [ 0, 5 ]\n  - [ 0, 5 ]\n  - [ 0, 6 ]\n"
       "keywords: [ id, element, xs, ys, zs, ]\ndata:\n  - [ 1 , C , 0 , 0 , 0.5 , ]\n...\n"});
}

void add_xyz(std::vector<Seed>& seeds) {
  seeds.push_back(
      {"a.xyz", "3\n\nC 0 0 0\nc2 1.4 0 0\nH 2.4D+00 0.1 -1e-1\n2\nsecond\nC 0 0 0\nC 1.4 0 0 9 9\n"});
  seeds.push_back(
      {"b.xyz",
       "2\nLattice=\"4 0 0 0 4 0 1 0 4\" Origin=\"0 0 1\" pbc=\"T T F\" Time=0.5 generator=\"by "
       "\\\"hand\\\"\" "
       "Properties=species:S:1:pos:R:3:id:I:1:Z:I:1:bonded:I:2\nC 0 0 0 5 6 2 0\nH 1.1 0 0 6 1 1 0\n"});
  seeds.push_back(
      {"c.xyz", "1\nLattice={4 0 0 0 4 0 0 0 4} Properties=pos:R:3:species:S:1 energy=-7.4\n0 0 0 C\n"});
}

// CIF: a space group by each of its names, listed operations, quotes, text fields, uncertainties.
void add_cif(std::vector<Seed>& seeds) {
  const std::string cubic =
      "_cell_length_a 3.567(2)\n_cell_length_b 3.567\n_cell_length_c 3.567\n_cell_angle_alpha "
      "90\n_cell_angle_beta "
      "90\n_cell_angle_gamma 90.0\n";
  const std::string atoms =
      "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n_atom_site_"
      "occupancy\n";
  seeds.push_back({"a.cif", "data_diamond\n# by name\n" + cubic +
                                "_space_group_name_H-M_alt 'F d -3 m :1'\n" + atoms + "C1 0 0 0 1.0\n"});
  seeds.push_back({"b.cif", "data_diamond\n" + cubic + "_symmetry_space_group_name_Hall \"F 4d 2 3 -1d\"\n" +
                                atoms + "C1 0.0(1) 0 0 .\n"});
  seeds.push_back(
      {"c.cif",
       "data_graphite\n_cell_length_a 2.464\n_cell_length_b 2.464\n_cell_length_c 6.711\n_cell_angle_alpha "
       "90\n_cell_angle_beta 90\n_cell_angle_gamma 120\nloop_\n_space_group_symop_operation_xyz\n'x, y, z'\n"
       "'-y, x-y, z'\n'-x+y, -x, z'\n'-x, -y, z+1/2'\n'y, -x+y, z+1/2'\n'x-y, x, z+1/2'\nloop_\n"
       "_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n"
       "_atom_site_fract_z\n_atom_site_calc_flag\nC1 C 0 0 0.25 d\nC2 C 0.3333 0.6667 0.25 d\nDu C 0 0 0 "
       "dum\n_publ_section_comment\n;\ntext over\nlines\n;\n"});
  seeds.push_back({"d.cif", "data_one\n_space_group_IT_number 1\n" + cubic +
                                "_atom_site_type_symbol H\n_atom_site_Cartn_x 0\n_atom_site_Cartn_y 0.5\n"
                                "_atom_site_Cartn_z 0.25\ndata_two\nsave_frame\n_a b\nsave_\n" +
                                cubic + atoms + "H1 0 0 0 1\n"});
}

void add_poscar(std::vector<Seed>& seeds) {
  seeds.push_back(
      {"POSCAR",
       "graphene\n1.0\n2.46 0 0\n-1.23 2.13 0\n0 0 10\nC H\n2 1\nSelective dynamics\nDirect\n0 0 0 T T F\n"
       "0.3333 0.6667 0 T T T\n0 0 0.1 F F F\n\n0 0 0\n"});
  seeds.push_back({"CONTCAR", "C\n-64.0\n1 0 0\n0 1 0\n0 0 1\n2\nCartesian\n0 0 0 C\n0.3 0.3 0.3 C\n"});
}

}  // namespace

std::vector<Seed> molecule_seeds() {
  std::vector<Seed> seeds;
  add_data(seeds);
  add_dumps(seeds);
  add_yaml(seeds);
  add_xyz(seeds);
  add_cif(seeds);
  add_poscar(seeds);
  return seeds;
}

}  // namespace nanocarbon::test

// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief lmp-nanocarbon: the installed LAMMPS, with a `plugin` command where it has none. Takes what lmp
//! takes.

#include <mpi.h>

#include <cstdlib>
#include <exception>
#include <memory>
#include <string_view>
#include <typeinfo>

#include "host/plugin_command.h"
#include "input.h"
#include "lammps.h"
#include "library.h"

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  try {
    const auto lmp = std::make_unique<LAMMPS_NS::LAMMPS>(argc, argv, MPI_COMM_WORLD);
    nanocarbon::add_plugin_command(*lmp);
    lmp->input->file();
  } catch (const std::exception& failure) {
    // LAMMPS has printed the message. Its exceptions are in no installed header: one class is thrown on all
    // ranks, the other on one rank alone, where the others would be waited for in vain.
    lammps_kokkos_finalize();
    lammps_python_finalize();
    if (std::string_view(typeid(failure).name()).find("LAMMPSException") == std::string_view::npos)
      MPI_Abort(MPI_COMM_WORLD, 1);
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Finalize();
    return EXIT_FAILURE;
  }
  lammps_kokkos_finalize();
  lammps_python_finalize();
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Finalize();
}

// SPDX-License-Identifier: GPL-2.0-or-later
//! \file
//! \brief What fix bond/topology costs: steps of 10,000 atoms of graphene at 300 K with pair_style rebo,
//! without and with the fix (N = 10), by turns in one run. Prints medians of CPU time. Not a test.

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "lammps/lammps_run.h"
#include "nanocarbon/structures/graphene.h"

namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(int turns, int steps, const std::string& every) {
  nanocarbon::test::LammpsRun run;
  run.read(nanocarbon::structures::graphene(50, 50));
  run.commands({"velocity all create 600 4711", "fix move all nve", "run 200 post no"});
  std::vector<double> without;
  std::vector<double> with;
  const std::string some_steps = "run " + std::to_string(steps) + " pre no post no";
  for (int turn = 0; turn < turns; ++turn) {
    double start = cpu_seconds();
    run.command(some_steps);
    without.push_back((cpu_seconds() - start) / steps);
    run.commands({"fix watch all bond/topology " + every, "run 0 post no"});
    start = cpu_seconds();
    run.command(some_steps);
    with.push_back((cpu_seconds() - start) / steps);
    run.commands({"unfix watch", "run 0 post no"});
  }
  if (nanocarbon::test::is_root())
    std::printf("step without: %.3f ms, with fix bond/topology: %.3f ms, %+.2f%%\n", 1e3 * median(without),
                1e3 * median(with), 100 * (median(with) / median(without) - 1));
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  measure(argc > 1 ? std::atoi(argv[1]) : 9, argc > 2 ? std::atoi(argv[2]) : 100, argc > 3 ? argv[3] : "10");
  MPI_Finalize();
}

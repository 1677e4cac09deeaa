# SPDX-License-Identifier: GPL-2.0-or-later
# The tests of pair_style rebo/opt.
set(comparison ${PROJECT_SOURCE_DIR}/tests/potential/rebo2/comparison_structures.cpp)
nanocarbon_lammps_test(rebo_opt RANKS 1 2 4 SOURCES ${comparison} LINKS nanocarbon::rebo2)
nanocarbon_lammps_test(rebo_opt_comparison RANKS 1 LINKS nanocarbon::rebo2 nanocarbon::building nanocarbon::mesh_formats
                       SOURCES ${comparison} ${PROJECT_SOURCE_DIR}/tests/support/lammps_reference.cpp)
foreach(test rebo_opt rebo_opt_comparison)
  target_compile_definitions(test_lammps_${test} PRIVATE
    NANOCARBON_CH_REBO="${NANOCARBON_CH_REBO}" NANOCARBON_PLUGIN_FILE="$<TARGET_FILE:nanocarbonplugin>")
endforeach()

target_compile_definitions(test_lammps_rebo_opt_comparison PRIVATE NANOCARBON_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")

# What rebo/opt must refuse, and what it has to say. LAMMPS ends the program at an error.
function(rebo_opt_refuses name command message)
  add_test(NAME lammps.rebo_opt.refuses.${name}
           COMMAND lmp-nanocarbon -log none -in ${CMAKE_CURRENT_SOURCE_DIR}/rebo_opt_refusal.in
                   -var plugin $<TARGET_FILE:nanocarbonplugin> -var potential ${NANOCARBON_CH_REBO}
                   -var command ${command} ${ARGN})
  set_tests_properties(lammps.rebo_opt.refuses.${name} PROPERTIES LABELS lammps TIMEOUT 60
    PASS_REGULAR_EXPRESSION "${message}" ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
endfunction()
rebo_opt_refuses(group_group "compute g all group/group all" "ERROR: Pair style does not support compute group/group")
rebo_opt_refuses(arguments "pair_style rebo/opt 3.0" "ERROR: Illegal pair_style command: rebo/opt takes no arguments")
rebo_opt_refuses(types "pair_coeff * * ${NANOCARBON_CH_REBO} C" "an element .C, H or NULL. for each atom type")
rebo_opt_refuses(element "pair_coeff * * ${NANOCARBON_CH_REBO} C Si" "rebo/opt knows C, H and NULL, not 'Si'")
rebo_opt_refuses(null "pair_coeff * * ${NANOCARBON_CH_REBO} NULL NULL" "every type is NULL")
rebo_opt_refuses(file "pair_coeff * * ${CMAKE_CURRENT_SOURCE_DIR}/rebo_opt_refusal.in C H" "line 2: expected '# REBO2'")
rebo_opt_refuses(missing "pair_coeff * * nowhere.rebo C H" "cannot open the potential file nowhere.rebo")
rebo_opt_refuses(newton "run 0" "ERROR: Pair style rebo/opt requires newton pair on" -var newton off)
rebo_opt_refuses(units "run 0" "ERROR: Pair style rebo/opt requires metal units, not real" -var units real)
nanocarbon_lammps_test(rebo_opt_conservation RANKS 1 LABEL lammps-slow)

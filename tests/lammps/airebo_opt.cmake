# SPDX-License-Identifier: GPL-2.0-or-later
# The tests of pair_style airebo/opt and airebo/morse/opt.
set(airebo_tests ${PROJECT_SOURCE_DIR}/tests/potential/airebo)
nanocarbon_lammps_test(airebo_opt_comparison RANKS 1 LABEL lammps-slow TIMEOUT 900
  LINKS nanocarbon::airebo nanocarbon::structures nlohmann_json::nlohmann_json
  SOURCES ${comparison} ${PROJECT_SOURCE_DIR}/tests/support/lammps_reference.cpp ${airebo_tests}/reference.cpp
          ${airebo_tests}/airebo_structures.cpp)
nanocarbon_lammps_test(airebo_opt RANKS 1 2 4 SOURCES ${comparison} ${airebo_tests}/reference.cpp
                       LINKS nanocarbon::airebo nanocarbon::structures nlohmann_json::nlohmann_json)
nanocarbon_lammps_test(airebo_opt_conservation RANKS 1 LABEL lammps-slow TIMEOUT 900)
nanocarbon_lammps_test(airebo_cohesion RANKS 1 LABEL lammps-slow TIMEOUT 900
  SOURCES ${PROJECT_SOURCE_DIR}/tests/support/lammps_reference.cpp
  LINKS nanocarbon::airebo nanocarbon::minimisation nanocarbon::structures)
foreach(test airebo_opt airebo_opt_comparison airebo_opt_conservation airebo_cohesion)
  target_compile_definitions(test_lammps_${test} PRIVATE
    NANOCARBON_CH_REBO="${NANOCARBON_CH_REBO}" NANOCARBON_PLUGIN_FILE="$<TARGET_FILE:nanocarbonplugin>"
    NANOCARBON_AIREBO_REFERENCE="${airebo_tests}/reference.json")
endforeach()

# What airebo/opt must refuse, and what it has to say. LAMMPS ends the program at an error.
get_filename_component(potentials ${NANOCARBON_CH_REBO} DIRECTORY)
function(airebo_opt_refuses name command message)
  add_test(NAME lammps.airebo_opt.refuses.${name}
           COMMAND lmp-nanocarbon -log none -in ${CMAKE_CURRENT_SOURCE_DIR}/airebo_opt_refusal.in
                   -var plugin $<TARGET_FILE:nanocarbonplugin> -var potential ${potentials}/CH.airebo
                   -var command ${command} ${ARGN})
  set_tests_properties(lammps.airebo_opt.refuses.${name} PROPERTIES LABELS lammps TIMEOUT 60
    PASS_REGULAR_EXPRESSION "${message}" ENVIRONMENT "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
endfunction()
airebo_opt_refuses(group_group "compute g all group/group all" "ERROR: Pair style does not support compute group/group")
airebo_opt_refuses(no_arguments "pair_style airebo/opt" "airebo/opt takes cutoff .LJ_flag TORSION_flag .cutoff_min")
airebo_opt_refuses(two_arguments "pair_style airebo/opt 3.0 1" "airebo/opt takes cutoff .LJ_flag TORSION_flag .cutoff_min")
airebo_opt_refuses(cutoff "pair_style airebo/opt 0.0" "airebo/opt needs a cutoff above 0")
airebo_opt_refuses(cutoff_min "pair_style airebo/opt 3.0 1 1 3.5" "needs a cutoff_min between 0 and the cutoff")
airebo_opt_refuses(types "pair_coeff * * ${potentials}/CH.airebo C" "an element .C, H or NULL. for each atom type")
airebo_opt_refuses(element "pair_coeff * * ${potentials}/CH.airebo C Si" "airebo/opt knows C, H and NULL, not 'Si'")
airebo_opt_refuses(null "pair_coeff * * ${potentials}/CH.airebo NULL NULL" "every type is NULL")
airebo_opt_refuses(rebo_file "pair_coeff * * ${potentials}/CH.rebo C H" "line 2: this is a file of REBO2, not of AIREBO,")
airebo_opt_refuses(morse_file "pair_coeff * * ${potentials}/CH.airebo-m C H" "line 2: this is a file of AIREBO-M, not of AIREBO,")
airebo_opt_refuses(missing "pair_coeff * * nowhere.airebo C H" "cannot open the potential file nowhere.airebo")
airebo_opt_refuses(newton "run 0" "ERROR: Pair style airebo/opt requires newton pair on" -var newton off)
airebo_opt_refuses(units "run 0" "ERROR: Pair style airebo/opt requires metal units, not real" -var units real)

# Does a build for another machine make the same tables, with tools built for this one?
# cmake -DSOURCE=folder -DWORK=folder -DTABLES=folder -DGENERATOR=name -DCXX=compiler -P cross_test.cmake
#
# The other machine is this one under another name: no compiler for it is needed. Only the tables are
# made, first with tools from a build of their own, then with those of VANDPLAN_TOOLS.
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/other_machine.cmake
     "set(CMAKE_SYSTEM_NAME ${CMAKE_HOST_SYSTEM_NAME})\nset(CMAKE_CXX_COMPILER ${CXX})\n")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(make_tables build)
  set(options --toolchain ${WORK}/other_machine.cmake -DVANDPLAN_HOST_CXX=${CXX})
  foreach(part SIMD THREADS APP EVALUATION IO DRAW TESTS)
    list(APPEND options -DVANDPLAN_${part}=OFF)
  endforeach()
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G ${GENERATOR} ${options} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build} --target vandplan_embedded_tables)
  foreach(table hlut_1 hlut_2 hlut_3 hlut_4 bound_entries)
    run(${CMAKE_COMMAND} -E compare_files ${TABLES}/${table}.h ${build}/src/embedded/${table}.h)
  endforeach()
endfunction()

make_tables(${WORK}/first)
if(NOT EXISTS ${WORK}/first/tools_of_the_host/src/make_bound_table)
  message(FATAL_ERROR "no tools of the host were built")
endif()
make_tables(${WORK}/second -DVANDPLAN_TOOLS=${WORK}/first/tools_of_the_host/src)
if(EXISTS ${WORK}/second/tools_of_the_host)
  message(FATAL_ERROR "tools were built though they were there")
endif()

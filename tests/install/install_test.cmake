# Can a stranger's CMake project find and link us?
# cmake -DBUILD=folder -DSOURCE=folder -DWORK=folder -DARGUMENTS=list -P install_test.cmake
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/foreign -B ${WORK}/build
    -DCMAKE_PREFIX_PATH=${prefix} -DEXAMPLES=${SOURCE}/examples ${ARGUMENTS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
file(GLOB examples ${SOURCE}/examples/*.cpp)
foreach(example IN LISTS examples)
  get_filename_component(name ${example} NAME_WE)
  if(NOT EXISTS ${WORK}/build/${name}) # of a component that is not there
    if(NOT name MATCHES ompl OR EXISTS ${prefix}/include/vandplan/ompl.h)
      message(FATAL_ERROR "${name} was not built")
    endif()
    continue()
  endif()
  message(STATUS ${name})
  execute_process(COMMAND ${WORK}/build/${name} WORKING_DIRECTORY ${WORK} OUTPUT_QUIET
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
run(${WORK}/build/draw_file ${SOURCE}/scenarios/thesis/3-h-shape.yaml ${WORK}/picture.png)
run(${WORK}/build/load_plugin ${WORK}/build/libplugin.so)
if(NOT EXISTS ${WORK}/picture.png)
  message(FATAL_ERROR "no picture")
endif()

# Can a stranger's CMake project find and link us?
# cmake -DBUILD=folder -DSOURCE=folder -DWORK=folder -DARGUMENTS=list -P install_test.cmake
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/foreign -B ${WORK}/build
    -DCMAKE_PREFIX_PATH=${prefix} -DEXAMPLE=${SOURCE}/examples/plan_one.cpp ${ARGUMENTS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/plan_one)
run(${WORK}/build/draw_file ${SOURCE}/scenarios/thesis/3-h-shape.yaml ${WORK}/picture.png)
run(${WORK}/build/load_plugin ${WORK}/build/libplugin.so)
if(NOT EXISTS ${WORK}/picture.png)
  message(FATAL_ERROR "no picture")
endif()

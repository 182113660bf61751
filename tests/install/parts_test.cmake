# Does each part ask for its own libraries only? Configures, builds nothing.
# cmake -DSOURCE=folder -DWORK=folder -DGENERATOR=name -DCXX=compiler -P parts_test.cmake
file(REMOVE_RECURSE ${WORK})
set(libraries_of_core hwy Threads)
set(libraries_of_files_and_pictures fmt nlohmann_json PNG pugixml yaml-cpp ZLIB PkgConfig)
set(libraries_of_program CLI11 SQLite3)

# configure(name libraries...): with these libraries out of sight, and the options in `parts`.
function(configure name)
  set(hidden ${ARGN})
  list(TRANSFORM hidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/${name} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
            -DVANDPLAN_TESTS=OFF ${parts} ${hidden}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(status ${status} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_success)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

set(parts -DVANDPLAN_APP=OFF)
configure(components ${libraries_of_program})
expect_success()

set(parts -DVANDPLAN_SIMD=OFF -DVANDPLAN_THREADS=OFF -DVANDPLAN_APP=OFF -DVANDPLAN_IO=OFF -DVANDPLAN_DRAW=OFF
    -DVANDPLAN_OMPL=OFF)
configure(core ${libraries_of_core} ${libraries_of_files_and_pictures} ${libraries_of_program})
expect_success()

set(parts -DVANDPLAN_IO=OFF)
configure(contradiction)
if(status EQUAL 0 OR NOT output MATCHES "VANDPLAN_EVALUATION=ON needs VANDPLAN_IO=ON")
  message(FATAL_ERROR "the program without files was let through, or refused without a word: ${output}")
endif()

# As a part of somebody else's build: the core alone, and nothing to install.
file(WRITE ${WORK}/parent/CMakeLists.txt
     "cmake_minimum_required(VERSION 3.25)\nproject(parent LANGUAGES CXX)\n"
     "add_subdirectory(${SOURCE} vandplan)\nadd_executable(first_plan ${SOURCE}/examples/01_first_plan.cpp)\n"
     "target_link_libraries(first_plan PRIVATE vandplan::vandplan)\n"
     "foreach(part io draw ompl evaluation)\nif(TARGET vandplan::\${part})\nmessage(FATAL_ERROR \${part})\n"
     "endif()\nendforeach()\n")
set(SOURCE ${WORK}/parent)
set(parts "")
configure(sub_project ${libraries_of_files_and_pictures} ${libraries_of_program})
expect_success()

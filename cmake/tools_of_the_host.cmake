# Where are the tools that run while we build, when this build cannot make them?
#
# In the folder VANDPLAN_TOOLS. Else a second build of this project makes them, and nothing else, for
# the machine that builds; its compiler is VANDPLAN_HOST_CXX, or what CMake finds there by itself.
# Defines the targets that `table_tools` names.
set(VANDPLAN_HOST_CXX "" CACHE FILEPATH "Compiler for the machine that builds")
set(tools_folder ${VANDPLAN_TOOLS})

if(NOT VANDPLAN_TOOLS)
  set(host_build ${PROJECT_BINARY_DIR}/tools_of_the_host)
  set(tools_folder ${host_build}/src)
  set(host_options -DCMAKE_BUILD_TYPE=Release -DCMAKE_MAKE_PROGRAM=${CMAKE_MAKE_PROGRAM})
  foreach(part SIMD THREADS APP EVALUATION IO DRAW TESTS BENCH INSTALL)
    list(APPEND host_options -DVANDPLAN_${part}=OFF)
  endforeach()
  if(VANDPLAN_HOST_CXX)
    list(APPEND host_options -DCMAKE_CXX_COMPILER=${VANDPLAN_HOST_CXX})
  endif()
  # What the environment says about compilers is meant for the other machine.
  set(host_cmake ${CMAKE_COMMAND} -E env --unset=CMAKE_TOOLCHAIN_FILE --unset=CXX --unset=CXXFLAGS
                 --unset=CPPFLAGS --unset=LDFLAGS ${CMAKE_COMMAND})
  list(TRANSFORM table_tools PREPEND ${tools_folder}/ OUTPUT_VARIABLE tool_files)
  include(ExternalProject)
  ExternalProject_Add(
    vandplan_tools_of_the_host
    SOURCE_DIR ${PROJECT_SOURCE_DIR}
    BINARY_DIR ${host_build}
    CONFIGURE_COMMAND ${host_cmake} -S <SOURCE_DIR> -B <BINARY_DIR> -G ${CMAKE_GENERATOR}
                      ${host_options}
    BUILD_COMMAND ${host_cmake} --build <BINARY_DIR> --target ${table_tools}
    BUILD_ALWAYS ON # it knows what is up to date
    BUILD_BYPRODUCTS ${tool_files}
    INSTALL_COMMAND "")
endif()

foreach(tool IN LISTS table_tools)
  add_executable(${tool} IMPORTED GLOBAL)
  set_target_properties(${tool} PROPERTIES IMPORTED_LOCATION ${tools_folder}/${tool})
  if(TARGET vandplan_tools_of_the_host)
    add_dependencies(${tool} vandplan_tools_of_the_host)
  endif()
endforeach()

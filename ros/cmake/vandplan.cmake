# Vändplan and the adapter as parts of a package: colcon builds it from this repository alone, and nothing
# has to be installed before.
get_filename_component(vandplan_folder ${CMAKE_CURRENT_LIST_DIR}/../.. REALPATH)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
find_package(hwy QUIET)
set(VANDPLAN_SIMD ${hwy_FOUND} CACHE BOOL "Vector kernels by Highway: several times faster (Ubuntu: libhwy-dev)")
set(VANDPLAN_ROS ON)
add_subdirectory(${vandplan_folder} ${CMAKE_CURRENT_BINARY_DIR}/vandplan EXCLUDE_FROM_ALL)

# vandplan_plugin(NAME source.cpp): a shared library that shows others nothing of what it is made of.
function(vandplan_plugin name)
  add_library(${name} SHARED ${ARGN})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                            $<INSTALL_INTERFACE:include/${name}>)
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:vandplan_ros>)
  target_link_options(${name} PRIVATE -Wl,--exclude-libs,ALL)
endfunction()

# How do builds without CMake find us? A file for pkg-config of each component; that of OMPL has none,
# since OMPL's own asks for more than what it needs.

# pkg_config_file(component, archives with their options, packages of others)
function(vandplan_pkg_config_file component archives packages)
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  set(name vandplan-${component})
  if(component STREQUAL "core")
    set(name vandplan)
  endif()
  file(RELATIVE_PATH up /${folder} /)
  string(REGEX REPLACE "/$" "" up ${up})
  file(CONFIGURE OUTPUT ${name}.pc CONTENT [[
prefix=${pcfiledir}/@up@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@

Name: @name@
Description: Plans paths for trucks and buses (@component@)
Version: @PROJECT_VERSION@
Requires: @packages@
Libs: -L${libdir} @archives@
Cflags: -I${includedir} -I${includedir}/vandplan-old -std=c++20
]] @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${folder})
endfunction()

set(core_archive "-lvandplan")
set(core_packages "")
if(VANDPLAN_THREADS)
  string(APPEND core_archive " -pthread")
endif()
if(VANDPLAN_SIMD)
  set(core_packages "libhwy")
endif()
vandplan_pkg_config_file(core "${core_archive}" "${core_packages}")
if(TARGET vandplan_io)
  set(geography "")
  get_source_file_property(definitions ${PROJECT_SOURCE_DIR}/src/io/local_plane.cpp DIRECTORY src/io COMPILE_DEFINITIONS)
  if(definitions MATCHES VANDPLAN_GEOGRAPHICLIB)
    set(geography " -lGeographicLib")
  endif()
  vandplan_pkg_config_file(io "-lvandplan_io${geography}" "vandplan fmt pugixml yaml-cpp libpng zlib")
endif()
if(TARGET vandplan_draw)
  vandplan_pkg_config_file(draw "-lvandplan_draw" "vandplan cairo cairo-svg cairo-pdf cairo-png")
endif()
if(TARGET vandplan_evaluation)
  vandplan_pkg_config_file(evaluation "-lvandplan_evaluation" "vandplan-io vandplan-draw fmt sqlite3")
endif()

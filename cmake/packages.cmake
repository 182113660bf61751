# What does `cpack` make of what is installed? Packages for Debian; scripts/package calls it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vandplan)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "the Vändplan authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
# Copyright, changelog and compressed manual pages: what Debian wants and other installs do not.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/packages/finish.cmake)

set(VANDPLAN_MAINTAINER "The Vändplan authors <vandplan@packages.invalid>"
    CACHE STRING "Who packs: a name and an address")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${VANDPLAN_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
if(CMAKE_CROSSCOMPILING AND CMAKE_SYSTEM_PROCESSOR STREQUAL aarch64)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
endif()

# package(COMPONENT name section "one line" "more lines"): a package that holds one component.
macro(vandplan_package component name section summary description)
  string(TOLOWER ${component} lower)
  list(APPEND CPACK_COMPONENTS_ALL ${lower})
  set(CPACK_DEBIAN_${component}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${component}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${component}_DESCRIPTION "${summary}\n${description}")
endmacro()

set(about "Vändplan plans paths for trucks, buses and cars among obstacles:
drivable, exact at start and goal, and checked by an independent judge.")

if(TARGET vandplan_cli)
  vandplan_package(PROGRAM vandplan science "plans paths for trucks and buses (program)" "${about}
.
This package holds the command vandplan with its manual pages: it plans,
checks, draws, smooths and simulates, and compares planners.")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox) # figures of studies
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS bash-completion)
endif()

vandplan_package(DEVELOPMENT libvandplan-dev libdevel "plans paths for trucks and buses (C++ library)" "${about}
.
This package holds the C++20 library: headers, archives, and files for
CMake and pkg-config. What only some of its components need is
recommended, or suggested for OMPL.")
if(VANDPLAN_SIMD)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libhwy-dev)
endif()
set(needed_by_components libcairo2-dev libfmt-dev libgeographiclib-dev libpng-dev libpugixml-dev libsqlite3-dev libyaml-cpp-dev
                         pkg-config zlib1g-dev)
list(JOIN needed_by_components ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, libompl-dev")

if(TARGET vandplan_python)
  vandplan_package(PYTHON python3-vandplan python "plans paths for trucks and buses (Python module)" "${about}
.
This package holds the Python module vandplan: planning, lengths between
arrays of poses, the judge, planners written in Python, and pictures.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  string(REGEX MATCH "[0-9]+$" minor ${vandplan_python_version})
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${vandplan_python_version}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-pandas")
  set(scripts ${PROJECT_SOURCE_DIR}/cmake/packages)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${scripts}/postinst;${scripts}/prerm")
endif()

include(CPack)

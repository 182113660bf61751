# What pictures need.
find_dependency(PkgConfig)
pkg_check_modules(CAIRO QUIET IMPORTED_TARGET cairo cairo-svg cairo-pdf cairo-png)
include(${CMAKE_CURRENT_LIST_DIR}/vandplan-draw-targets.cmake)

# What comparing planners needs.
include(${CMAKE_CURRENT_LIST_DIR}/vandplan-io.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/vandplan-draw.cmake)
find_dependency(SQLite3)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/vandplan-evaluation-targets.cmake)

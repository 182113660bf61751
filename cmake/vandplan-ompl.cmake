# What OMPL's planners with our parts need.
include(${CMAKE_CURRENT_LIST_DIR}/vandplan-find-ompl.cmake)
if(TARGET vandplan::ompl_library)
  find_dependency(Threads)
  include(${CMAKE_CURRENT_LIST_DIR}/vandplan-ompl-targets.cmake)
endif()

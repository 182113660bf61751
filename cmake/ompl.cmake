# Where is OMPL, the library that tests and benchmarks compare with? Its own package file asks for
# more than its headers and library, so these are looked for directly.
if(NOT TARGET vandplan_ompl)
  add_library(vandplan_ompl INTERFACE)
  find_path(VANDPLAN_OMPL_INCLUDE ompl/base/spaces/ReedsSheppStateSpace.h
            PATH_SUFFIXES ompl-1.5 ompl-1.6 ompl)
  find_path(VANDPLAN_EIGEN_INCLUDE Eigen/Core PATH_SUFFIXES eigen3)
  find_library(VANDPLAN_OMPL_LIBRARY ompl)
  mark_as_advanced(VANDPLAN_OMPL_INCLUDE VANDPLAN_EIGEN_INCLUDE VANDPLAN_OMPL_LIBRARY)
  if(VANDPLAN_OMPL_INCLUDE AND VANDPLAN_EIGEN_INCLUDE AND VANDPLAN_OMPL_LIBRARY)
    target_include_directories(vandplan_ompl SYSTEM INTERFACE ${VANDPLAN_OMPL_INCLUDE}
                                                              ${VANDPLAN_EIGEN_INCLUDE})
    target_link_libraries(vandplan_ompl INTERFACE ${VANDPLAN_OMPL_LIBRARY})
  else()
    message(STATUS "OMPL not found: nothing is compared with it")
  endif()
endif()

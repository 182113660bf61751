# Where is OMPL? Its own package file asks for more than its headers and library, so these are looked
# for directly. The target vandplan::ompl_library exists if they are there.
if(NOT TARGET vandplan::ompl_library)
  find_path(VANDPLAN_OMPL_INCLUDE ompl/base/spaces/ReedsSheppStateSpace.h
            PATH_SUFFIXES ompl-1.5 ompl-1.6 ompl-1.7 ompl)
  find_path(VANDPLAN_EIGEN_INCLUDE Eigen/Core PATH_SUFFIXES eigen3)
  find_library(VANDPLAN_OMPL_LIBRARY ompl)
  mark_as_advanced(VANDPLAN_OMPL_INCLUDE VANDPLAN_EIGEN_INCLUDE VANDPLAN_OMPL_LIBRARY)
  if(VANDPLAN_OMPL_INCLUDE AND VANDPLAN_EIGEN_INCLUDE AND VANDPLAN_OMPL_LIBRARY)
    add_library(vandplan::ompl_library INTERFACE IMPORTED GLOBAL)
    target_include_directories(vandplan::ompl_library SYSTEM
                               INTERFACE ${VANDPLAN_OMPL_INCLUDE} ${VANDPLAN_EIGEN_INCLUDE})
    target_link_libraries(vandplan::ompl_library INTERFACE ${VANDPLAN_OMPL_LIBRARY})
  endif()
endif()

# Which header has what was in headers of version 0.2? Their names work for one version more: delete this
# file and what names "vandplan-old" or "old_headers" with the next.
set(old_headers
    files:heading_doubt,scenario_file,geojson,primitives_file
    geometry:occupancy_grid
    graphs:primitives,goal_estimate,roadmap
    judge:path_check,drive_check
    motion:speed,moving
    ompl:ompl_nearest,ompl_geometric
    ompl_spaces:ompl_world,ompl_planner
    path:goal_set
    plan_options:capability
    planner:path_source,smooth
    problem:outcome
    replanner:live_drive
    steering:dubins,reeds_shepp,continuous_steering,rig_steering
    tables:heuristic_table,bound_table,table_file,nearest
    vehicle:driving_limits,rig)

# Each is a file that includes the new one, in a folder of its own: include/vandplan holds the new ones alone.
set(old_folder ${CMAKE_CURRENT_BINARY_DIR}/old_headers)
foreach(row IN LISTS old_headers)
  string(REGEX REPLACE ":.*" "" new ${row})
  string(REGEX REPLACE ".*:|," ";" names ${row})
  foreach(name IN LISTS names)
    if(name)
      file(CONFIGURE OUTPUT ${old_folder}/vandplan/${name}.h CONTENT [[
#pragma once
#include "vandplan/@new@.h"  // deprecated: include this one
]] @ONLY)
      list(APPEND old_files ${old_folder}/vandplan/${name}.h)
    endif()
  endforeach()
endforeach()
target_sources(vandplan PUBLIC FILE_SET old_headers TYPE HEADERS BASE_DIRS ${old_folder} FILES ${old_files})

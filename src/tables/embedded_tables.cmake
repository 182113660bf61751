# Which tables are computed while we build, and become constant data of the library?

# The loops that run in vectors: part of the core. They alone know of Highway, so that no other file
# is compiled differently without vectors.
if(VANDPLAN_SIMD)
  add_library(vandplan_kernels OBJECT simd/kernels_highway_lengths.cpp simd/kernels_highway_tables.cpp)
  target_link_libraries(vandplan_kernels PRIVATE hwy::hwy vandplan_vector_targets)
else()
  add_library(vandplan_kernels OBJECT simd/kernels_plain.cpp)
endif()
# Highway 1.0 has no vectors of double for WebAssembly.
if(VANDPLAN_SIMD AND NOT EMSCRIPTEN)
  target_sources(vandplan_kernels PRIVATE simd/kernels_highway_circles.cpp
                                          simd/kernels_highway_pairs.cpp)
  # UndefinedBehaviorSanitizer's checks in them would take Clang minutes; their scalar twins are checked.
  set_source_files_properties(
    simd/kernels_highway_circles.cpp simd/kernels_highway_pairs.cpp
    PROPERTIES COMPILE_OPTIONS "$<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=undefined>")
else()
  target_sources(vandplan_kernels PRIVATE simd/circle_kernels_plain.cpp simd/pair_kernels_plain.cpp)
endif()
vandplan_core_target(vandplan_kernels)
# Counting the lines of each vector target would take minutes to compile, and no fuzz target is led by
# them.
vandplan_count_no_lines(vandplan_kernels)
target_include_directories(vandplan_kernels PRIVATE ${PROJECT_SOURCE_DIR}/include)

# Steering and tables: part of the core, and what its embedded tables are computed with.
add_library(
  vandplan_tables OBJECT
  base/decimal.cpp
  geometry/geometry.cpp
  tables/heuristic_table.cpp
  base/input_error.cpp
  steering/mean_frame.cpp
  path/clothoid.cpp
  path/path.cpp
  steering/reeds_shepp.cpp
  simd/bound_kernels_scalar.cpp
  simd/length_kernels_scalar.cpp
  simd/table_kernels_scalar.cpp
  tables/table_bytes.cpp
  tables/table_export.cpp
  tables/table_file.cpp
  base/trigonometry.cpp)
vandplan_core_target(vandplan_tables)
target_include_directories(vandplan_tables PRIVATE ${PROJECT_SOURCE_DIR}/include)

# What the library looks up, but never computes itself.
add_library(vandplan_bound_builder OBJECT EXCLUDE_FROM_ALL
            tables/bound_builder.cpp tables/excess.cpp tables/words_in_box.cpp)
vandplan_core_target(vandplan_bound_builder)
target_include_directories(vandplan_bound_builder PRIVATE ${PROJECT_SOURCE_DIR}/include)

# What the library also computes itself, for rigs that have no table.
add_library(vandplan_rig_table_builder OBJECT EXCLUDE_FROM_ALL
            base/exponential.cpp base/parallel.cpp steering/hitch_turn.cpp steering/rig_search.cpp
            steering/rig_steering.cpp steering/rig_word.cpp tables/rig_table.cpp)
vandplan_core_target(vandplan_rig_table_builder)
target_include_directories(vandplan_rig_table_builder PRIVATE ${PROJECT_SOURCE_DIR}/include)

# The tools that compute them run on the machine that builds.
set(table_tools make_thesis_table make_bound_table make_rig_table)
if(VANDPLAN_TOOLS OR CMAKE_CROSSCOMPILING)
  include(${PROJECT_SOURCE_DIR}/cmake/tools_of_the_host.cmake)
else()
  foreach(tool IN LISTS table_tools)
    add_executable(${tool} ${PROJECT_SOURCE_DIR}/tools/${tool}.cpp)
    vandplan_core_target(${tool})
    target_include_directories(${tool} PRIVATE ${PROJECT_SOURCE_DIR}/include)
    target_sources(${tool} PRIVATE $<TARGET_OBJECTS:vandplan_kernels>
                                   $<TARGET_OBJECTS:vandplan_tables>)
    if(VANDPLAN_SIMD)
      target_link_libraries(${tool} PRIVATE $<LINK_ONLY:hwy::hwy>)
    endif()
  endforeach()
  target_sources(make_bound_table PRIVATE $<TARGET_OBJECTS:vandplan_bound_builder>)
  target_sources(make_rig_table PRIVATE $<TARGET_OBJECTS:vandplan_rig_table_builder>)
  if(VANDPLAN_THREADS)
    find_package(Threads REQUIRED)
    target_link_libraries(make_rig_table PRIVATE Threads::Threads)
  endif()
endif()

set(embedded_tables ${CMAKE_CURRENT_BINARY_DIR}/embedded)
file(MAKE_DIRECTORY ${embedded_tables})

# The four tables of the thesis (thesis_tables.cpp).
if(VANDPLAN_TABLES)
  set(thesis_tables 1 2 3 4)
endif()
foreach(number IN LISTS thesis_tables)
  add_custom_command(
    OUTPUT ${embedded_tables}/hlut_${number}.h
    COMMAND make_thesis_table ${number} ${embedded_tables}/hlut_${number}.h
    DEPENDS make_thesis_table
    VERBATIM)
  list(APPEND embedded_headers ${embedded_tables}/hlut_${number}.h)
endforeach()

# The table of bounds (bound_table.cpp), and that of a rig (embedded_rig_table.cpp).
foreach(kind bound rig)
  add_custom_command(
    OUTPUT ${embedded_tables}/${kind}_entries.h
    COMMAND make_${kind}_table ${embedded_tables}/${kind}_entries.h
    DEPENDS make_${kind}_table
    VERBATIM)
  list(APPEND embedded_headers ${embedded_tables}/${kind}_entries.h)
endforeach()

# To make them alone.
add_custom_target(vandplan_embedded_tables DEPENDS ${embedded_headers})

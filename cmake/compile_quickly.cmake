# What makes compiling quicker, and where is it used?

# Code that mostly includes large headers of others (JSON, CLI11), and tests: compiling it takes
# minutes at full optimisation, which nobody would notice when it runs. Releases compile it at -O1, or at
# the level named. Builds with sanitizers stay at the -O1 of their presets, as JSON takes minutes to
# run there at -O0; a level of DEBUG is for what runs little of it.
function(vandplan_compile_quickly target)
  cmake_parse_arguments(PARSE_ARGV 1 level "" "RELEASE;DEBUG" "")
  if(NOT level_RELEASE)
    set(level_RELEASE -O1)
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level_RELEASE}>
                                           $<$<CONFIG:Debug>:${level_DEBUG}>)
endfunction()

# With VANDPLAN_FUZZ, code counts which of its lines run, for fuzz targets. A target that none of them
# links need not.
function(vandplan_count_no_lines target)
  if(VANDPLAN_FUZZ)
    target_compile_options(${target} PRIVATE -fno-sanitize=fuzzer-no-link)
  endif()
endfunction()

# With VANDPLAN_FUZZ, code that reads files tells fuzz targets what it compares, which they then try.
# In all code that would take more than half of the time of the tests.
function(vandplan_tell_comparisons target)
  if(VANDPLAN_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize-coverage=trace-cmp)
  endif()
endfunction()

# With VANDPLAN_UNITY, the files of a target are compiled a dozen at a time, so that what they take
# from large headers of others is made once. It needs names that differ within the target, those of
# unnamed namespaces too.
function(vandplan_compile_together target)
  if(VANDPLAN_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    # g++ takes the sources for headers, in which classes should not hold types of unnamed namespaces.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# With VANDPLAN_UNITY, the files of each of these folders of the core are compiled together, unless only
# those around it are. Names in unnamed namespaces must differ within such a folder.
function(vandplan_compile_folders_together target)
  if(VANDPLAN_UNITY AND NOT VANDPLAN_UNITY STREQUAL AROUND_CORE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    get_target_property(sources ${target} SOURCES)
    foreach(folder IN LISTS ARGN)
      set(files ${sources})
      list(FILTER files INCLUDE REGEX "^${folder}/[a-z_]+[.]cpp$")
      set_source_files_properties(${files} PROPERTIES UNITY_GROUP ${folder})
    endforeach()
  endif()
endfunction()

# With VANDPLAN_PCH, these headers of the standard library are read once for all files of a target,
# and further ones that are named. A release goes without: at full optimisation g++ 12 warns of faults
# that are none in what it takes from precompiled headers.
function(vandplan_precompile_headers target)
  if(VANDPLAN_PCH AND CMAKE_BUILD_TYPE STREQUAL Debug)
    target_precompile_headers(
      ${target}
      PRIVATE
      <algorithm>
      <array>
      <cmath>
      <functional>
      <limits>
      <memory>
      <numbers>
      <optional>
      <span>
      <string>
      <vector>
      ${ARGN})
  endif()
endfunction()

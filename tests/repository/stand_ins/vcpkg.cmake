# vcpkg's functions, as a port sees them: it prints what it would tell CMake. FEATURES and PORT are given.
cmake_policy(VERSION 3.25)
set(CURRENT_PACKAGES_DIR /nowhere)

function(vcpkg_download_distfile variable)
  cmake_parse_arguments(PARSE_ARGV 1 of "" "URLS;FILENAME;SHA512" "")
  string(LENGTH "${of_SHA512}" length)
  if(NOT length EQUAL 128 OR NOT of_URLS OR NOT of_FILENAME)
    message(FATAL_ERROR "a download lacks something: ${ARGN}")
  endif()
  set(${variable} /${variable} PARENT_SCOPE)
endfunction()

function(vcpkg_extract_source_archive variable)
  set(${variable} /source PARENT_SCOPE)
endfunction()

function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 of "" OUT_FEATURE_OPTIONS FEATURES)
  while(of_FEATURES)
    list(POP_FRONT of_FEATURES feature option)
    if(feature IN_LIST FEATURES)
      list(APPEND options -D${option}=ON)
    else()
      list(APPEND options -D${option}=OFF)
    endif()
  endwhile()
  set(${of_OUT_FEATURE_OPTIONS} ${options} PARENT_SCOPE)
endfunction()

function(vcpkg_find_acquire_program variable)
  set(${variable} /pkgconf PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 of "" SOURCE_PATH OPTIONS)
  message("options: ${of_OPTIONS}")
endfunction()

foreach(rest check_linkage cmake_install cmake_config_fixup fixup_pkgconfig copy_tools install_copyright)
  cmake_language(EVAL CODE "function(vcpkg_${rest})\nendfunction()")
endforeach()

include(${PORT}/portfile.cmake)

# Untested: vcpkg was not at hand. Its functions were played by others (tests/repository/recipes_test).
# vcpkg install "vandplan[tool]" --overlay-ports=.
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_download_distfile(
  archive
  URLS "@ADDRESS@"
  FILENAME "vandplan-@VERSION@.tar.gz"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")

vcpkg_check_features(
  OUT_FEATURE_OPTIONS options
  FEATURES
    io VANDPLAN_IO
    draw VANDPLAN_DRAW
    evaluation VANDPLAN_EVALUATION
    tool VANDPLAN_APP
    ompl VANDPLAN_OMPL)
if("evaluation" IN_LIST FEATURES)
  vcpkg_download_distfile(
    d3
    URLS "@D3_ADDRESS@"
    FILENAME "d3-@D3_VERSION@.min.js"
    SHA512 @D3_SHA512@)
  list(APPEND options "-DVANDPLAN_D3=${d3}")
endif()
if("draw" IN_LIST FEATURES)
  vcpkg_find_acquire_program(PKGCONFIG)
  list(APPEND options "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}")
endif()

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DVANDPLAN_TESTS=OFF ${options})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/vandplan)
vcpkg_fixup_pkgconfig()
if("tool" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES vandplan AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")

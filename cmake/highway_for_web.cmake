# Highway for WebAssembly: its headers alone, as there is one target and so nothing to choose at run
# time. They come from the package of this machine; of its other headers none must be seen.
find_path(VANDPLAN_HIGHWAY hwy/highway.h PATHS /usr/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
set(highway ${CMAKE_BINARY_DIR}/highway)
file(MAKE_DIRECTORY ${highway})
file(CREATE_LINK ${VANDPLAN_HIGHWAY}/hwy ${highway}/hwy SYMBOLIC)
add_library(hwy::hwy INTERFACE IMPORTED GLOBAL)
target_include_directories(hwy::hwy SYSTEM INTERFACE ${highway})

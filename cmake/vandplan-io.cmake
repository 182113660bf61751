# What reading and writing files needs.
find_dependency(fmt)
find_dependency(yaml-cpp)
find_dependency(PNG)
find_dependency(pugixml)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/vandplan-io-targets.cmake)

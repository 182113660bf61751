# The scenarios that a study draws become constant data of the program: no path to look for.
set(scenario_entries "")
foreach(name 3-h-shape 7-cage-to-cage)
  set(file ${PROJECT_SOURCE_DIR}/scenarios/thesis/${name}.yaml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  string(APPEND scenario_entries "    {\"${name}\", R\"yaml(${text})yaml\"},\n")
endforeach()
configure_file(embedded_scenarios.h.in ${CMAKE_CURRENT_BINARY_DIR}/embedded_scenarios.h @ONLY)

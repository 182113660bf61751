# What is built for a wheel of Python (pyproject.toml)? The module and the command line.
set(VANDPLAN_PYTHON ON CACHE STRING "")
set(VANDPLAN_UNITY ON CACHE BOOL "") # half the work in a build from nothing
foreach(part OMPL TESTS INSTALL)
  set(VANDPLAN_${part} OFF CACHE BOOL "")
endforeach()

set(VANDPLAN_BUILT "" CACHE PATH "A build whose module and command line are taken, if they are not to be compiled")
if(VANDPLAN_BUILT)
  file(GLOB module ${VANDPLAN_BUILT}/python/vandplan/_core.*)
  install(FILES ${module} DESTINATION vandplan)
  install(PROGRAMS ${VANDPLAN_BUILT}/app/vandplan DESTINATION vandplan/bin)
  install(CODE [[execute_process(COMMAND strip ${CMAKE_INSTALL_PREFIX}/vandplan/bin/vandplan COMMAND_ERROR_IS_FATAL ANY)]])
endif()

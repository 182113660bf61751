# How do others find us after install?
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/vandplan)
# Packages are made of components: development, program, python (packages.cmake).
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

# One export per component, so that nobody needs the dependencies of what he does not use.
install(TARGETS vandplan EXPORT vandplan-targets FILE_SET HEADERS
        FILE_SET old_headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vandplan-old)
install(EXPORT vandplan-targets NAMESPACE vandplan:: DESTINATION ${package_folder})
foreach(component io draw ompl evaluation)
  if(TARGET vandplan_${component})
    set_target_properties(vandplan_${component} PROPERTIES EXPORT_NAME ${component})
    install(TARGETS vandplan_${component} EXPORT vandplan-${component}-targets FILE_SET HEADERS)
    install(EXPORT vandplan-${component}-targets NAMESPACE vandplan:: DESTINATION ${package_folder})
    install(FILES cmake/vandplan-${component}.cmake DESTINATION ${package_folder})
  endif()
endforeach()

if(TARGET vandplan_ompl)
  install(FILES cmake/ompl.cmake DESTINATION ${package_folder} RENAME vandplan-find-ompl.cmake)
endif()

configure_package_config_file(cmake/vandplan-config.cmake.in vandplan-config.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(vandplan-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vandplan-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/vandplan-config-version.cmake
        DESTINATION ${package_folder})
include(cmake/pkg_config.cmake)
if(TARGET vandplan_cli)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
  install(TARGETS vandplan_cli)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/app/help/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
  install(FILES ${PROJECT_BINARY_DIR}/app/help/vandplan
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()

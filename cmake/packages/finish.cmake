# What a package for Debian has beside what is installed. cpack runs this on each folder to be packed.
# SOURCE_DATE_EPOCH in the environment is the time of every file, also for cpack.
set(source ${CMAKE_CURRENT_LIST_DIR}/../..)
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

# The text of a file as a field of a copyright file has it: a space before each line, "." for none.
function(as_field file result)
  file(READ ${file} text)
  string(REGEX REPLACE "\n+$" "" text "${text}")
  string(REPLACE "\n\n" "\n.\n" text "${text}")
  string(REPLACE "\n" "\n " text "${text}")
  set(${result} " ${text}\n" PARENT_SCOPE)
endfunction()
as_field(${source}/LICENSE licence)
as_field(${source}/evaluation/page/d3-licence.txt d3_licence)

function(compress)
  execute_process(COMMAND gzip -9 -n -f ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB examples_of_program ${source}/scenarios/thesis/*.yaml)
file(GLOB examples_of_development ${source}/examples/*.cpp)
file(GLOB examples_of_python ${source}/examples/python/*)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
  string(TOUPPER ${component} upper)
  set(documents ${root}${CPACK_PACKAGING_INSTALL_PREFIX}/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright ${documents}/copyright @ONLY)
  configure_file(${source}/CHANGELOG.md ${documents}/changelog COPYONLY)
  file(WRITE ${documents}/changelog.Debian
       "vandplan (${version}) unstable; urgency=medium\n\n  * The packages of version ${CPACK_PACKAGE_VERSION}.\n\n"
       " -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
  compress(${documents}/changelog ${documents}/changelog.Debian)
  file(COPY ${examples_of_${component}} DESTINATION ${documents}/examples)
  file(GLOB pages ${root}${CPACK_PACKAGING_INSTALL_PREFIX}/share/man/man1/*.1)
  if(pages)
    compress(${pages})
  endif()
endforeach()

# Which commit is built? Writes a header that says so; leaves it alone when it says so already.
# cmake -DSOURCE=folder -DHEADER=file -P commit.cmake
#
# In a checkout git says it, with "+changes" if there are some. In a tarball commit.txt does, which
# git filled in when the tarball was packed. Else nobody knows, and the header says nothing.
cmake_minimum_required(VERSION 3.25)
set(commit "")
if(EXISTS ${SOURCE}/.git)
  execute_process(
    COMMAND git --no-optional-locks -C ${SOURCE} describe --always --dirty=+changes --abbrev=10 "--exclude=*"
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
elseif(EXISTS ${SOURCE}/cmake/commit.txt)
  file(STRINGS ${SOURCE}/cmake/commit.txt commit LIMIT_COUNT 1)
  string(SUBSTRING "${commit}" 0 10 commit)
endif()
if(NOT commit MATCHES "^[0-9a-f]+([+]changes)?$")
  set(commit "")
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "// Made by cmake/commit.cmake.\n#define VANDPLAN_COMMIT \"@commit@\"\n" @ONLY)

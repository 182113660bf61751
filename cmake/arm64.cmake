# Builds for 64-bit ARM on another machine, with Debian's g++-aarch64-linux-gnu:
# cmake --toolchain cmake/arm64.cmake [-DVANDPLAN_ARM64_ROOT=FOLDER]
# FOLDER holds a Debian for arm64 with the libraries that are linked; without one they are looked for
# on this machine (packages of the architecture arm64).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)

list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES VANDPLAN_ARM64_ROOT)
set(libraries ${VANDPLAN_ARM64_ROOT}/usr/lib/aarch64-linux-gnu)
if(VANDPLAN_ARM64_ROOT)
  set(CMAKE_SYSROOT ${VANDPLAN_ARM64_ROOT})
  set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
  foreach(kind INCLUDE LIBRARY PACKAGE)
    set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
  endforeach()
  set(ENV{PKG_CONFIG_SYSROOT_DIR} ${VANDPLAN_ARM64_ROOT})
endif()
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/pkgconfig:${VANDPLAN_ARM64_ROOT}/usr/share/pkgconfig)

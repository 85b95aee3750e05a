# Debian's cross compiler, with libraries that scripts/arm64.sh has unpacked.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PROSKILL_SYSROOT)

# Headers and libraries come from there; programs that run during the build come from this system.
set(CMAKE_FIND_ROOT_PATH "${PROSKILL_SYSROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(arm64_libraries "${PROSKILL_SYSROOT}/usr/lib/aarch64-linux-gnu")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -L${arm64_libraries} -Wl,-rpath-link,${arm64_libraries} -Wl,-rpath-link,${PROSKILL_SYSROOT}/lib/aarch64-linux-gnu")
string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${PROSKILL_SYSROOT}/usr/include -isystem ${PROSKILL_SYSROOT}/usr/include/aarch64-linux-gnu")

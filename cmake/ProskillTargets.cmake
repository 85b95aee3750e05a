# One target per folder, the same flags for all of them.

find_program(PROSKILL_CCACHE ccache)
if(PROSKILL_CCACHE)
  # Without this, ccache does not cache objects compiled with a precompiled header.
  set(launcher env CCACHE_SLOPPINESS=pch_defines,time_macros ${PROSKILL_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()

add_library(proskill_flags INTERFACE)
target_compile_options(proskill_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow=local -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wno-missing-field-initializers -Werror)
target_include_directories(proskill_flags INTERFACE ${CMAKE_SOURCE_DIR})
if(PROSKILL_SANITIZE)
  target_compile_options(proskill_flags INTERFACE
    -fsanitize=${PROSKILL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(proskill_flags INTERFACE -fsanitize=${PROSKILL_SANITIZE})
endif()
if(PROSKILL_FUZZ)
  # It counts edges of other code, and is not instrumented itself.
  add_library(proskill_fuzz_coverage STATIC ${CMAKE_SOURCE_DIR}/fuzz/coverage.cpp)
  target_compile_options(proskill_flags INTERFACE -fsanitize-coverage=trace-pc,trace-cmp)
  target_link_libraries(proskill_flags INTERFACE proskill_fuzz_coverage)
  target_link_options(proskill_flags INTERFACE LINKER:--wrap=__sanitizer_cov_trace_pc)
endif()

# proskill_precompiled(NAME [PIC] HEADERS <header>… DEPENDS target… [OPTIONS flag…]): headers that cost each file that reads
# them up to two seconds, read once for all targets that `proskill_use_precompiled(TARGET NAME)`. The files still
# include what they use: the preset `debug` builds without.
function(proskill_precompiled name)
  cmake_parse_arguments(ARG "PIC" "" "HEADERS;DEPENDS;OPTIONS" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/precompiled_${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// A library has a source.\n")
  add_library(proskill_precompiled_${name} STATIC ${source})
  target_link_libraries(proskill_precompiled_${name} PRIVATE ${ARG_DEPENDS} proskill_flags)
  target_compile_options(proskill_precompiled_${name} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(proskill_precompiled_${name} PRIVATE ${ARG_HEADERS})
  if(ARG_PIC)
    proskill_position_independent(proskill_precompiled_${name})
  endif()
endfunction()

# proskill_position_independent(TARGET): its objects fit into shared libraries. Functions are inlined as in programs.
function(proskill_position_independent target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
endfunction()

function(proskill_use_precompiled target name)
  target_precompile_headers(${target} REUSE_FROM proskill_precompiled_${name})
  # GCC 12 reports false overruns of std::string in inlined code of precompiled headers (its bug 105651).
  target_compile_options(${target} PRIVATE
    -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
endfunction()

# proskill_alone(FILE…): excludes files from unity builds, because their short names would clash with those of other
# files in the folder.
function(proskill_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# proskill_uses_asio(FILE): the thread sanitizer does not support fences; mutexes order asio's memory without them.
function(proskill_uses_asio file)
  if(PROSKILL_SANITIZE STREQUAL "thread")
    set_source_files_properties(${file} PROPERTIES COMPILE_DEFINITIONS ASIO_DISABLE_FENCED_BLOCK)
  endif()
endfunction()

# proskill_optimise_less(TARGET): for code that runs once per command or answer, not for each state. It compiles in two
# thirds of the time.
function(proskill_optimise_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# proskill_library(NAME [PIC] [PRECOMPILED name] DEPENDS target…): every *.cpp of the current folder and those
# below it, as target proskill_NAME. PIC: it becomes part of libproskill.so, too (embed/).
function(proskill_library name)
  cmake_parse_arguments(ARG "PIC" "PRECOMPILED" "DEPENDS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    add_library(proskill_${name} INTERFACE)
    return()
  endif()
  add_library(proskill_${name} STATIC ${sources})
  target_link_libraries(proskill_${name} PUBLIC ${ARG_DEPENDS} PRIVATE proskill_flags)
  target_include_directories(proskill_${name} PUBLIC ${CMAKE_SOURCE_DIR})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED std)
  endif()
  if(ARG_PIC)
    proskill_position_independent(proskill_${name})
    string(APPEND ARG_PRECOMPILED _pic)
  endif()
  proskill_use_precompiled(proskill_${name} ${ARG_PRECOMPILED})
endfunction()

# proskill_exhaustive(NAME): a switch of the folder names every value of its enumeration, even where it has a `default`:
# a new kind of statement, property or node is then an error at each place that has to know it.
function(proskill_exhaustive name)
  target_compile_options(proskill_${name} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wswitch-enum>)
endfunction()

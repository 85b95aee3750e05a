# One target per folder, the same flags for all of them.

find_program(PROSKILL_CCACHE ccache)
if(PROSKILL_CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${PROSKILL_CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PROSKILL_CCACHE})
endif()

add_library(proskill_flags INTERFACE)
target_compile_options(proskill_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow=local -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wno-missing-field-initializers -Werror)
target_include_directories(proskill_flags INTERFACE ${CMAKE_SOURCE_DIR})
# All objects fit into programs and into libproskill.so, so that nothing is compiled twice.
# Functions are inlined as in programs.
target_compile_options(proskill_flags INTERFACE -fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
# The compiler collects its garbage less often: this saves a fourteenth of its time, and takes a seventh more memory.
target_compile_options(proskill_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>)
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

# proskill_apart(GROUP file…): these files are compiled as one, apart from the others of their folder, because their short names
# would clash with those, or because a linker has to find them without the others.
function(proskill_apart group)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
endfunction()

# proskill_embed_files(TARGET NAME HEADER h NAMESPACE n FILES file…): the bytes of these files as a source of the target (Embed.cmake). It is
# written when CMake runs, because the objects of all targets that link this one would wait for a command of the build.
function(proskill_embed_files target name)
  cmake_parse_arguments(ARG "" "HEADER;NAMESPACE" "FILES" ${ARGN})
  set(made ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set(script ${CMAKE_SOURCE_DIR}/cmake/Embed.cmake)
  foreach(file IN LISTS ARG_FILES ITEMS ${script})
    if(NOT EXISTS ${made} OR ${file} IS_NEWER_THAN ${made})
      set(old ON)
    endif()
  endforeach()
  if(old)
    execute_process(COMMAND ${CMAKE_COMMAND} -D OUT=${made} "-D FILES=${ARG_FILES}" -D HEADER=${ARG_HEADER}
                            -D NAMESPACE=${ARG_NAMESPACE} -P ${script} COMMAND_ERROR_IS_FATAL ANY)
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARG_FILES} ${script})
  target_sources(${target} PRIVATE ${made})
  set_source_files_properties(${made} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# proskill_group(TARGET): the other files in groups of about the same size, in the order of their names. Most of the time of a
# small file goes into templates that its neighbours need, too: a group of 200 kB takes a quarter less than two of 100 kB.
set(proskill_group_size 200000)
function(proskill_group target)
  get_target_property(sources ${target} SOURCES)
  set(total 0)
  set(rest "")
  foreach(source IN LISTS sources)
    get_source_file_property(group ${source} UNITY_GROUP)
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(NOT group AND NOT alone)
      list(APPEND rest ${source})
      get_source_file_property(path ${source} LOCATION)
      file(SIZE ${path} size)
      math(EXPR total "${total} + ${size}")
    endif()
  endforeach()
  math(EXPR groups "1 + ${total} / ${proskill_group_size}")
  set(before 0)
  foreach(source IN LISTS rest)
    get_source_file_property(path ${source} LOCATION)
    file(SIZE ${path} size)
    math(EXPR group "(${before} + ${size} / 2) * ${groups} / (${total} + 1)")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP part${group})
    math(EXPR before "${before} + ${size}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
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

# proskill_library(NAME [SOURCES file…] [EXCEPT file…] DEPENDS target…): these files, or every *.cpp of the current
# folder and those below it except some, as target proskill_NAME.
function(proskill_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;EXCEPT;DEPENDS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM ARG_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  list(TRANSFORM ARG_EXCEPT PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  if(ARG_SOURCES)
    set(sources ${ARG_SOURCES})
  elseif(ARG_EXCEPT)
    list(REMOVE_ITEM sources ${ARG_EXCEPT})
  endif()
  if(NOT sources)
    add_library(proskill_${name} INTERFACE)
    return()
  endif()
  add_library(proskill_${name} STATIC ${sources})
  target_link_libraries(proskill_${name} PUBLIC ${ARG_DEPENDS} PRIVATE proskill_flags)
  target_include_directories(proskill_${name} PUBLIC ${CMAKE_SOURCE_DIR})
  cmake_language(EVAL CODE "cmake_language(DEFER CALL proskill_group proskill_${name})")
endfunction()

# proskill_exhaustive(NAME): a switch of the folder names every value of its enumeration, even where it has a `default`:
# a new kind of statement, property or node is then an error at each place that has to know it.
function(proskill_exhaustive name)
  target_compile_options(proskill_${name} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wswitch-enum>)
endfunction()

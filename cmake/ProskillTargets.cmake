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
if(PROSKILL_SANITIZE)
  target_compile_options(proskill_flags INTERFACE
    -fsanitize=${PROSKILL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(proskill_flags INTERFACE -fsanitize=${PROSKILL_SANITIZE})
endif()
if(PROSKILL_FUZZ)
  target_compile_options(proskill_flags INTERFACE -fsanitize-coverage=trace-pc,trace-cmp)
endif()

# proskill_library(NAME DEPENDS target…): every *.cpp of the current folder, as target proskill_NAME.
function(proskill_library name)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    add_library(proskill_${name} INTERFACE)
    return()
  endif()
  add_library(proskill_${name} STATIC ${sources})
  target_link_libraries(proskill_${name} PUBLIC ${ARG_DEPENDS} PRIVATE proskill_flags)
  target_include_directories(proskill_${name} PUBLIC ${CMAKE_SOURCE_DIR})
endfunction()

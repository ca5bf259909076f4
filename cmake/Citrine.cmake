# One set of language, warning and floating-point rules for every target of the project.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
find_program(CCACHE ccache)
if(CCACHE)
  # Without these it would not keep what is compiled with precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_DEPEND=1
    CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

add_library(citrine_rules INTERFACE)
target_include_directories(citrine_rules INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(citrine_rules INTERFACE
  -march=x86-64-v3 -ffp-contract=off
  -Wall -Wextra -Wpedantic -Wshadow -Wno-sign-conversion -Werror
  -fpch-preprocess  # ccache asks for it
  # GCC 12 sees these in "literal" + std::string, where there are none (GCC bug 105651)
  -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
if(CITRINE_SANITIZE)
  target_compile_options(citrine_rules INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1
    -Wno-maybe-uninitialized)  # GCC: sanitizers make false alarms of it
  target_link_options(citrine_rules INTERFACE -fsanitize=address,undefined)
endif()

# What nearly every file includes is parsed once for all libraries and once for all tests: a third of the time of a build.
option(CITRINE_PRECOMPILE "Precompile Eigen, the standard headers and GoogleTest" ON)
set(CITRINE_COMMON_HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <cstdint> <functional> <map> <memory>
  <optional> <string> <vector>)

# citrine_precompile(<target> <first> <header>...): with the headers that target <first>, made before all others, precompiles
function(citrine_precompile name first)
  if(NOT CITRINE_PRECOMPILE)
    return()
  elseif(name STREQUAL first)
    target_precompile_headers(${name} PRIVATE ${ARGN})
  else()
    target_precompile_headers(${name} REUSE_FROM ${first})
  endif()
endfunction()

# citrine_library(<name> SOURCES a.cpp... [LINKS public targets...] [PRIVATE_LINKS targets...])
function(citrine_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC citrine_rules ${arg_LINKS} PRIVATE ${arg_PRIVATE_LINKS})
  citrine_precompile(${name} citrine_core ${CITRINE_COMMON_HEADERS})
endfunction()

# citrine_module(<name> SOURCES x_module.cpp... LINKS targets...): library <name>_module and executable <name> from main.cpp
function(citrine_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS" ${ARGN})
  citrine_library(${name}_module SOURCES ${arg_SOURCES} LINKS ${arg_LINKS} citrine_runtime)
  add_executable(${name} main.cpp)
  target_link_libraries(${name} PRIVATE ${name}_module)
  citrine_precompile(${name} citrine_core)
endfunction()

# citrine_test(<name> LABEL unit SOURCES x_test.cpp... LINKS targets...): one GoogleTest program, each of its tests a CTest
include(GoogleTest)
add_custom_target(unit_and_module_tests)  # those that are also run with sanitizers
function(citrine_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE citrine_rules ${arg_LINKS} citrine_test_main)
  citrine_precompile(${name} citrine_test_main)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  target_compile_definitions(${name} PRIVATE CITRINE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CITRINE_BIN_DIR="${PROJECT_BINARY_DIR}/bin")
  if(arg_LABEL MATCHES "^(unit|module)$")
    add_dependencies(unit_and_module_tests ${name})
  endif()
  set(alone FALSE)
  if(arg_LABEL STREQUAL processes)  # at the pace of the wall
    set(alone TRUE)
  endif()
  gtest_discover_tests(${name} PROPERTIES LABELS ${arg_LABEL} TIMEOUT 600 RUN_SERIAL ${alone} DISCOVERY_TIMEOUT 60)
endfunction()

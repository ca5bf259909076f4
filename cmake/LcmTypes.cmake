# add_lcm_types(<target> PACKAGE <pkg> <file.lcm>...): C++ headers from LCM types, as an INTERFACE target, and <pkg>/fields.hpp,
# which names the fields of each.
set(LCM_FIELDS ${CMAKE_CURRENT_LIST_DIR}/LcmFields.cmake)
find_program(LCM_GEN lcm-gen REQUIRED)
function(add_lcm_types target)
  cmake_parse_arguments(arg "" "PACKAGE" "" ${ARGN})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/include)
  foreach(src ${arg_UNPARSED_ARGUMENTS})
    get_filename_component(name ${src} NAME_WE)
    set(hpp ${out}/${arg_PACKAGE}/${name}.hpp)
    add_custom_command(OUTPUT ${hpp}
      COMMAND ${LCM_GEN} --cpp --cpp-std c++11 --cpp-hpath ${out} ${CMAKE_CURRENT_SOURCE_DIR}/${src}
      DEPENDS ${src} VERBATIM)
    list(APPEND headers ${hpp})
  endforeach()
  set(fields ${out}/${arg_PACKAGE}/fields.hpp)
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
  add_custom_command(OUTPUT ${fields}
    COMMAND ${CMAKE_COMMAND} -D OUT=${fields} -D PACKAGE=${arg_PACKAGE} -P ${LCM_FIELDS} -- ${sources}
    DEPENDS ${arg_UNPARSED_ARGUMENTS} ${LCM_FIELDS} VERBATIM)
  add_custom_target(${target}_gen DEPENDS ${headers} ${fields})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_gen)
  target_include_directories(${target} SYSTEM INTERFACE ${out})
  target_link_libraries(${target} INTERFACE LCM::lcm)
endfunction()

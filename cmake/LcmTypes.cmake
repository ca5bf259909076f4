# add_lcm_types(<target> PACKAGE <pkg> <file.lcm>...): C++ headers from LCM types, as an INTERFACE target.
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
  add_custom_target(${target}_gen DEPENDS ${headers})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_gen)
  target_include_directories(${target} SYSTEM INTERFACE ${out})
  target_link_libraries(${target} INTERFACE LCM::lcm)
endfunction()

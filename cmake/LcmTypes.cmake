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
  list(TRANSFORM arg_UNPARSED_ARGUMENTS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  set_target_properties(${target} PROPERTIES LCM_PACKAGE ${arg_PACKAGE} LCM_FILES "${files}")
endfunction()

# lcm_type_sources(<out.cpp> <target>): the body of TypeSources() (modules/reflection/type_sources.h): every type's fingerprint
# and .lcm file, so that tools can show messages of any type.
function(lcm_type_sources out target)
  get_target_property(package ${target} LCM_PACKAGE)
  get_target_property(files ${target} LCM_FILES)
  foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND includes "#include <${package}/${name}.hpp>\n")
    string(APPEND rows "      {${package}::${name}::getHash(), R\"lcm(${text})lcm\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  file(CONFIGURE OUTPUT ${out} CONTENT "// Made of lcmtypes/ by the build.
#include \"modules/reflection/type_sources.h\"

${includes}
namespace citrine {

std::vector<TypeSource> TypeSources() {
  return {
${rows}  };
}

}  // namespace citrine
" @ONLY)
endfunction()

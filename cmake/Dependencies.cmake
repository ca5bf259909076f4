# Every third-party library, found once. The comment names the one place that may include it.
find_package(Eigen3 REQUIRED)                      # everywhere
find_package(GTest REQUIRED)                       # tests
find_package(CLI11 REQUIRED)                       # modules
find_package(NLopt REQUIRED)                       # planner/trajectory
find_package(octomap REQUIRED)                     # tests
find_package(embree 3 REQUIRED)                    # sim/lidar
find_package(sdformat12 REQUIRED)                  # sim/world
find_package(assimp REQUIRED)                      # sim/world
find_package(nlohmann_json REQUIRED)               # logs, modules
find_package(nanoflann REQUIRED)                   # logs
find_package(Boost REQUIRED)                       # logs/statistics
find_package(Protobuf REQUIRED)                   # modules/mcap_export
find_package(ZLIB REQUIRED)                       # logs/mcap
find_package(Threads REQUIRED)

# citrine_find(<target> <header> <library>...): an imported target where a package ships no CMake file
function(citrine_find target header)
  string(REPLACE "::" "_" variable ${target})
  find_path(${variable}_INCLUDE_DIR ${header} PATH_SUFFIXES ${header} opencv4 REQUIRED)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${${variable}_INCLUDE_DIR})
  foreach(library ${ARGN})
    find_library(${variable}_${library}_LIBRARY ${library} REQUIRED)
    target_link_libraries(${target} INTERFACE ${${variable}_${library}_LIBRARY})
  endforeach()
endfunction()
citrine_find(LCM::lcm lcm/lcm-cpp.hpp lcm)         # modules/runtime
citrine_find(ODE::ode ode/ode.h ode)               # sim/dynamics
citrine_find(Zstd::zstd zstd.h zstd)               # modules/codec, logs/mcap
citrine_find(XXHash::xxhash xxhash.h xxhash)       # core/digest
citrine_find(Toml::toml toml++/toml.h)             # core/config
citrine_find(OpenCV::opencv opencv2/core.hpp opencv_core opencv_imgproc opencv_imgcodecs opencv_highgui opencv_videoio)  # viz
citrine_find(Xcb::xcb xcb/xcb.h xcb)               # viz/display

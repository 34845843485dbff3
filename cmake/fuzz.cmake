# fuzz/NAME_fuzz.cpp: a libFuzzer program, built and run by scripts/fuzz.sh only (clang).
find_package(catkin REQUIRED COMPONENTS roscpp_serialization rostime sensor_msgs)
include_directories(SYSTEM ${catkin_INCLUDE_DIRS})
add_library(fuzzed_conversion STATIC src/ros/cloud_conversion.cpp src/ros/no_returns.cpp)
target_link_libraries(fuzzed_conversion PUBLIC atom_map ${catkin_LIBRARIES})

file(GLOB fuzzers CONFIGURE_DEPENDS fuzz/*_fuzz.cpp)
foreach(source ${fuzzers})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_link_libraries(${name} fuzzed_conversion atom_map_io -fsanitize=fuzzer)
endforeach()
add_executable(make_corpus fuzz/make_corpus.cpp)
target_link_libraries(make_corpus atom_map_io)

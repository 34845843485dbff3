# The ROS library, and one program a file of src/apps.
find_package(yaml-cpp REQUIRED)
include_directories(SYSTEM ${catkin_INCLUDE_DIRS})

add_library(${PROJECT_NAME}_ros ${ros_sources})
target_link_libraries(${PROJECT_NAME}_ros ${ATOM_MAPPING_CORE_LIBRARIES} ${catkin_LIBRARIES} yaml-cpp)
add_dependencies(${PROJECT_NAME}_ros ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})

set(programs "")
foreach(source ${program_sources})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_link_libraries(${name} ${ATOM_MAPPING_LIBRARIES} ${catkin_LIBRARIES})
  add_dependencies(${name} ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
  list(APPEND programs ${name})
endforeach()

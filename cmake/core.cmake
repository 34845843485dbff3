# The libraries without ROS.

set(ATOM_MAPPING_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual)

if(ATOM_MAPPING_SANITIZE)
  # -UNDEBUG: what is searched for faults also runs its asserts.
  add_compile_options(-fsanitize=${ATOM_MAPPING_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -UNDEBUG)
  add_link_options(-fsanitize=${ATOM_MAPPING_SANITIZE})
endif()

# base, scan, map, query, planning
add_library(atom_map ${core_sources})
target_include_directories(atom_map PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
target_link_libraries(atom_map PUBLIC Eigen3::Eigen Threads::Threads)
target_compile_options(atom_map PRIVATE ${ATOM_MAPPING_WARNINGS})

# surface, io: meshes, files, pictures
if(io_sources)
  find_package(VTK REQUIRED QUIET)
  add_library(atom_map_io ${io_sources})
  target_include_directories(atom_map_io SYSTEM PRIVATE ${VTK_INCLUDE_DIRS})
  target_link_libraries(atom_map_io PUBLIC atom_map PRIVATE ${VTK_LIBRARIES})
  target_compile_options(atom_map_io PRIVATE ${ATOM_MAPPING_WARNINGS})
endif()

# sim: scenes with exact truth, simulated sensors
if(sim_sources)
  add_library(atom_map_sim ${sim_sources})
  target_link_libraries(atom_map_sim PUBLIC atom_map)
  target_compile_options(atom_map_sim PRIVATE ${ATOM_MAPPING_WARNINGS})
endif()

# baseline: OctoMap, for comparison
if(baseline_sources)
  find_package(octomap REQUIRED)
  add_library(atom_map_baseline ${baseline_sources})
  target_include_directories(atom_map_baseline SYSTEM PRIVATE ${OCTOMAP_INCLUDE_DIRS})
  target_link_libraries(atom_map_baseline PUBLIC atom_map ${OCTOMAP_LIBRARIES})
  target_compile_options(atom_map_baseline PRIVATE ${ATOM_MAPPING_WARNINGS})
endif()

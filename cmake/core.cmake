# The libraries without ROS.

set(ATOM_MAPPING_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual)

# A program loads only the libraries that it calls.
add_link_options(LINKER:--as-needed)

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

# surface, io: meshes, files
if(io_sources)
  include_directories(SYSTEM ${PCL_INCLUDE_DIRS})
  add_library(atom_map_io ${io_sources})
  target_link_libraries(atom_map_io PUBLIC atom_map)
  if(PCL_FOUND)
    # The files and not PCL's targets: those drag in all of VTK, MPI too.
      target_link_libraries(atom_map_io PUBLIC ${PCL_IO_LIBRARY} ${PCL_COMMON_LIBRARY})
  endif()
  target_compile_options(atom_map_io PRIVATE ${ATOM_MAPPING_WARNINGS})
endif()

# io/picture: a library of its own, since what draws must not weigh on the nodes
if(VTK_FOUND)
  add_library(atom_map_picture ${picture_sources})
  target_link_libraries(atom_map_picture PUBLIC atom_map PRIVATE ${VTK_LIBRARIES} EGL)
  target_compile_options(atom_map_picture PRIVATE ${ATOM_MAPPING_WARNINGS})
  vtk_module_autoinit(TARGETS atom_map_picture MODULES ${VTK_LIBRARIES})
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

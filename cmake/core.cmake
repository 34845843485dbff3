# The libraries without ROS.
find_package(PCL REQUIRED QUIET COMPONENTS common io)
find_package(octomap REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS CXX)
find_package(ZLIB REQUIRED)
include_directories(SYSTEM ${PCL_INCLUDE_DIRS} ${OCTOMAP_INCLUDE_DIRS} ${HDF5_INCLUDE_DIRS})

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual)
# Nobody reads errno after a square root, nor catches floating-point exceptions.
add_compile_options(-fno-math-errno -fno-trapping-math)
# A program loads only the libraries that it calls.
add_link_options(LINKER:--as-needed)
if(ATOM_MAPPING_SANITIZE)
  # -UNDEBUG: what is searched for faults also runs its asserts.
  # GCC 12 takes for uninitialized what a sanitizer only looks at.
  add_compile_options(-fsanitize=${ATOM_MAPPING_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -UNDEBUG -Wno-maybe-uninitialized)
  add_link_options(-fsanitize=${ATOM_MAPPING_SANITIZE})
endif()

# base, scan, map, query, planning
add_library(atom_map ${core_sources})
target_include_directories(atom_map PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
target_link_libraries(atom_map PUBLIC Eigen3::Eigen Threads::Threads)

# surface, io: meshes, files. PCL's files and not its targets: those drag in all of VTK, MPI too.
add_library(atom_map_io ${io_sources})
target_link_libraries(atom_map_io
  PUBLIC atom_map ${PCL_IO_LIBRARY} ${PCL_COMMON_LIBRARY} ${HDF5_CXX_LIBRARIES} ZLIB::ZLIB
  PRIVATE ${surface_vtk})

# io/picture: a library of its own, since what draws must not weigh on the nodes
if(TARGET VTK::RenderingOpenGL2)
  add_library(atom_map_picture ${picture_sources})
  set(vtk_modules
    VTK::CommonCore VTK::CommonDataModel VTK::IOImage VTK::ImagingCore VTK::RenderingCore VTK::RenderingOpenGL2)
  target_link_libraries(atom_map_picture PUBLIC atom_map PRIVATE ${vtk_modules} EGL)
  vtk_module_autoinit(TARGETS atom_map_picture MODULES ${vtk_modules})
endif()

# sim: scenes with exact truth, simulated sensors
add_library(atom_map_sim ${sim_sources})
target_link_libraries(atom_map_sim PUBLIC atom_map)

# baseline: OctoMap, for comparison
add_library(atom_map_baseline ${baseline_sources})
target_link_libraries(atom_map_baseline PUBLIC atom_map atom_map_io ${OCTOMAP_LIBRARIES})

# evaluation: maps side by side on the same scans, and how they are judged
add_library(atom_map_evaluation ${evaluation_sources})
target_link_libraries(atom_map_evaluation PUBLIC atom_map_baseline atom_map_io atom_map_sim)

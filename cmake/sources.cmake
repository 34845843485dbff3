# What is built, globbed layer by layer. test/structure/layering_test.py checks which folder may include which.
file(GLOB core_sources CONFIGURE_DEPENDS src/base/*.cpp src/scan/*.cpp src/map/*.cpp src/query/*.cpp src/planning/*.cpp)
file(GLOB io_sources CONFIGURE_DEPENDS src/surface/*.cpp src/io/*.cpp)
file(GLOB picture_sources CONFIGURE_DEPENDS src/io/picture/*.cpp)
file(GLOB sim_sources CONFIGURE_DEPENDS src/sim/*.cpp)
file(GLOB baseline_sources CONFIGURE_DEPENDS src/baseline/*.cpp)
file(GLOB evaluation_sources CONFIGURE_DEPENDS src/evaluation/*.cpp)
file(GLOB ros_sources CONFIGURE_DEPENDS src/ros/*.cpp)
file(GLOB program_sources CONFIGURE_DEPENDS src/apps/*.cpp)

set(ATOM_MAPPING_CORE_LIBRARIES atom_map_evaluation atom_map_baseline atom_map_io atom_map_sim atom_map)
set(ATOM_MAPPING_EXPORTED_LIBRARIES ${PROJECT_NAME}_ros ${ATOM_MAPPING_CORE_LIBRARIES})
# Pictures need VTK 9, which Ubuntu 20.04 lacks. Not exported: see src/io/picture/headless_gl.cpp.
find_package(VTK 9 QUIET COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersCore IOImage ImagingCore RenderingCore RenderingOpenGL2)
if(VTK_FOUND)
  set(surface_vtk VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel VTK::CommonMisc VTK::FiltersCore)
  list(APPEND ATOM_MAPPING_CORE_LIBRARIES atom_map_picture)
else()
  #catkin_lint: ignore_once shadowed_find
  find_package(VTK REQUIRED COMPONENTS vtkFiltersCore)
  include_directories(SYSTEM ${VTK_INCLUDE_DIRS})
  set(surface_vtk ${VTK_LIBRARIES})
  message(STATUS "SKIPPED: render_map, since pictures need VTK 9")
  list(FILTER program_sources EXCLUDE REGEX "/render_map\\.cpp$")
endif()
set(ATOM_MAPPING_LIBRARIES ${PROJECT_NAME}_ros ${ATOM_MAPPING_CORE_LIBRARIES})

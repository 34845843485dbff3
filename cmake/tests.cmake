# The tests. In the catkin build their results land in build/test_results; scripts/test.sh builds everything, runs them
# and counts. With ATOM_MAPPING_CORE_ONLY the core's tests run under ctest.
find_package(rapidcheck REQUIRED)
if(ATOM_MAPPING_CORE_ONLY)
  enable_testing()
  find_package(GTest REQUIRED)
else()
  find_package(rostest REQUIRED)
endif()
set(test_results ${CMAKE_BINARY_DIR}/test_results/${PROJECT_NAME})
set(expected_results "")

# test/core/NAME_test.cpp: a gtest of the libraries without ROS. Under the thread sanitizer only *_concurrency_test.cpp.
set(core_test_pattern test/core/*_test.cpp)
if(ATOM_MAPPING_SANITIZE STREQUAL "thread")
  set(core_test_pattern test/core/*_concurrency_test.cpp)
endif()
file(GLOB core_tests CONFIGURE_DEPENDS ${core_test_pattern})
if(ATOM_MAPPING_SANITIZE)  # they hold plans to a time, which sanitizers take tenfold
  list(FILTER core_tests EXCLUDE REGEX "_paths_test\\.cpp$")
endif()
foreach(source ${core_tests})
  get_filename_component(name ${source} NAME_WE)
  set(result ${test_results}/gtest-${name}.xml)
  if(ATOM_MAPPING_CORE_ONLY)
    add_executable(${name} ${source})
    add_test(NAME ${name} COMMAND ${name} --gtest_output=xml:${result})
  else()
    catkin_add_gtest(${name} ${source})
  endif()
  target_link_libraries(${name} ${ATOM_MAPPING_CORE_LIBRARIES} rapidcheck rapidcheck_gtest gtest gtest_main)
  string(APPEND expected_results "${result}\n")
endforeach()

if(NOT ATOM_MAPPING_CORE_ONLY)
  # test/ros/NAME.test: a rostest. Where test/ros/NAME_test.cpp lies beside it, that becomes the program NAME_test, a gtest
  # with a main of its own, which NAME.test starts by <test pkg="atom_mapping" type="NAME_test" test-name="NAME"/>.
  file(GLOB ros_tests CONFIGURE_DEPENDS test/ros/*.test)
  foreach(test ${ros_tests})
    get_filename_component(name ${test} NAME_WE)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/test/ros/${name}_test.cpp)
      add_rostest_gtest(${name}_test test/ros/${name}.test test/ros/${name}_test.cpp)
      target_link_libraries(${name}_test ${ATOM_MAPPING_LIBRARIES} ${catkin_LIBRARIES})
      add_dependencies(${name}_test ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
    else()
      add_rostest(test/ros/${name}.test)
    endif()
    string(APPEND expected_results "${test_results}/rostest-test_ros_${name}.xml\n")
  endforeach()

  # Any other test/ros/NAME_test.cpp: a gtest of what needs no roscore.
  file(GLOB ros_gtests CONFIGURE_DEPENDS test/ros/*_test.cpp)
  foreach(source ${ros_gtests})
    get_filename_component(name ${source} NAME_WE)
    if(NOT TARGET ${name})
      catkin_add_gtest(${name} ${source})
      target_link_libraries(${name} ${ATOM_MAPPING_LIBRARIES} ${catkin_LIBRARIES} gtest_main)
      add_dependencies(${name} ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
      string(APPEND expected_results "${test_results}/gtest-${name}.xml\n")
    endif()
  endforeach()

  # test/structure/NAME_test.py: a Python unittest of the repository itself.
  file(GLOB structure_tests CONFIGURE_DEPENDS test/structure/*_test.py)
  foreach(test ${structure_tests})
    get_filename_component(name ${test} NAME_WE)
    set(result ${test_results}/structure-${name}.xml)
    catkin_run_tests_target(structure ${name} structure-${name}.xml
      COMMAND "${PYTHON_EXECUTABLE} ${test} --gtest_output=xml:${result}")
    string(APPEND expected_results "${result}\n")
  endforeach()
endif()

if(ATOM_MAPPING_MESSAGES)
  include(cmake/server_tests.cmake)
endif()

# benchmark/NAME_benchmark.cpp: a program of Google Benchmark cases. Built with the tests, run by scripts/benchmark.sh only.
if(NOT ATOM_MAPPING_SANITIZE)
  find_package(benchmark REQUIRED)
  file(GLOB benchmarks CONFIGURE_DEPENDS benchmark/*_benchmark.cpp)
  foreach(source ${benchmarks})
    get_filename_component(name ${source} NAME_WE)
    add_executable(${name} EXCLUDE_FROM_ALL ${source})
    target_include_directories(${name} PRIVATE test/core)
    target_link_libraries(${name} ${ATOM_MAPPING_CORE_LIBRARIES} benchmark::benchmark)
    if(TARGET tests)
      add_dependencies(tests ${name})
    endif()
  endforeach()
endif()

# scripts/test.sh counts: a test that left no result has failed.
file(WRITE ${CMAKE_BINARY_DIR}/expected_test_results.txt "${expected_results}")

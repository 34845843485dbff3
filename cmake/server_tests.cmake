# The server's threads under the thread sanitizer, without a roscore: test/ros/*_concurrency_test.cpp and what they call.
# ATOM_MAPPING_MESSAGES: where another build of the package has generated its messages' headers.
find_package(catkin REQUIRED COMPONENTS
  geometry_msgs roscpp sensor_msgs std_srvs tf2 tf2_eigen visualization_msgs diagnostic_msgs shape_msgs nav_msgs)
include_directories(SYSTEM ${catkin_INCLUDE_DIRS} ${ATOM_MAPPING_MESSAGES})
set(server_sources "")
foreach(name answer_request check_request cloud_conversion cloud_server fit_to_limits header_fault loaded_kind
    map_queries map_snapshot map_storage no_returns point_queries pose_conversion scan_counts scan_report_message
    scan_server scan_worker simulated_messages throttled_log)
  list(APPEND server_sources src/ros/${name}.cpp)
endforeach()
add_library(server_under_test STATIC ${server_sources})
target_link_libraries(server_under_test PUBLIC atom_map_sim atom_map_baseline atom_map_io atom_map ${catkin_LIBRARIES})

file(GLOB server_tests CONFIGURE_DEPENDS test/ros/*_concurrency_test.cpp)
foreach(source ${server_tests})
  get_filename_component(name ${source} NAME_WE)
  set(result ${test_results}/gtest-${name}.xml)
  add_executable(${name} ${source})
  target_link_libraries(${name} server_under_test gtest gtest_main)
  add_test(NAME ${name} COMMAND ${name} --gtest_output=xml:${result})
  set_tests_properties(${name} PROPERTIES
    ENVIRONMENT TSAN_OPTIONS=suppressions=${CMAKE_CURRENT_SOURCE_DIR}/test/thread_sanitizer.supp)
  string(APPEND expected_results "${result}\n")
endforeach()

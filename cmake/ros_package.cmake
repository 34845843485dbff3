# What catkin must know before any target: dependencies, messages, exports.
find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs diagnostic_updater geometry_msgs message_filters message_generation nav_msgs rosbag roscpp sensor_msgs
  shape_msgs std_msgs std_srvs tf2 tf2_eigen tf2_msgs tf2_ros visualization_msgs)

add_message_files(FILES ScanReport.msg)
add_service_files(FILES
  CastRay.srv
  CheckCollision.srv
  ClearRegion.srv
  ExtractSurface.srv
  MapFile.srv
  PlanPath.srv
  QueryOccupancy.srv
  QuerySignedDistance.srv)
generate_messages(DEPENDENCIES geometry_msgs nav_msgs shape_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${ATOM_MAPPING_EXPORTED_LIBRARIES}
  CATKIN_DEPENDS diagnostic_msgs diagnostic_updater geometry_msgs message_filters message_runtime nav_msgs rosbag roscpp
    sensor_msgs shape_msgs std_msgs std_srvs tf2 tf2_eigen tf2_msgs tf2_ros visualization_msgs
  DEPENDS EIGEN3)

#pragma once

#include <ros/master.h>

#include <string>

namespace atom_mapping {

// What to tell a person who waits for a map while no cloud comes on `topic`: whether anyone would send one, and on which
// other topics there are clouds, but for those of the node itself, under `own_name`.
std::string describeSilence(const std::string& topic, const ros::master::V_TopicInfo& advertised,
                            const std::string& own_name);

}  // namespace atom_mapping

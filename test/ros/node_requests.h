// What the requests of node_requests_test.cpp share: nodes that answer them, and what spoils a good one.
#pragma once

#include <geometry_msgs/Point.h>
#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "atom_mapping/MapFile.h"
#include "map_file_request.h"
#include "node_client.h"

namespace atom_mapping {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr std::size_t kTooMany = 1001;  // over services/max_points

// What spoils a good request, and a part of the answer's message.
template <class Request>
struct Spoiler {
  const char* name;
  std::function<void(Request&)> spoil;
  std::string says;
};

template <class Message>
std::vector<std::uint8_t> bytesOf(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

inline geometry_msgs::Point pointAt(double x, double y, double z) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

class NodeRequests : public testing::TestWithParam<const char*> {
 protected:
  static void SetUpTestSuite() {
    folder = std::filesystem::path(testing::TempDir()) / ("node_requests_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "folder.h5");
    std::filesystem::create_directories(folder / "folder.ply");
    std::ofstream(folder / "text.h5") << "no map";
    client = new NodeClient;
    ASSERT_TRUE(client->waitForNode());
    ASSERT_TRUE(NodeClient::waitUntil([] { return client->subscribers() >= 2; }));
  }

  static void TearDownTestSuite() {
    delete client;
    std::filesystem::remove_all(folder);
  }

  static std::string path(const std::string& name) { return (folder / name).string(); }

  template <class Service>
  typename Service::Response call(const std::string& name, const typename Service::Request& request) {
    return NodeClient::call<Service>(name, request, GetParam());
  }

  // The map, byte by byte.
  std::string mapFile() {
    const auto saved = call<MapFile>("save_map", at(path("witness.h5")));
    EXPECT_TRUE(saved.success) << saved.message;
    std::ifstream in(path("witness.h5"), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  // Maps a scan, unless this node has one.
  void mapScan() {
    if (call<MapFile>("save_map", at(path("witness.h5"))).atoms > 0) return;
    const SimulatedDrive drive = makeCoarseDrive();
    client->publish(drive.transform(0));
    client->publish(drive.cloud(0));
    ASSERT_TRUE(NodeClient::waitUntil([&] { return call<MapFile>("save_map", at(path("witness.h5"))).atoms > 100; }));
  }

  template <class Service>
  void expectRefused(const std::string& service, const typename Service::Request& request, const std::string& says) {
    typename Service::Response response = call<Service>(service, request);
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(says), std::string::npos) << "expected: " << says << "\n" << response.message;
    response.message.clear();
    typename Service::Response nothing;
    nothing.success = 0;
    EXPECT_TRUE(bytesOf(response) == bytesOf(nothing)) << "a refusal answers nothing else";
  }

  template <class Service>
  void expectAllRefused(const std::string& service, const typename Service::Request& good,
                        const std::vector<Spoiler<typename Service::Request>>& spoilers) {
    mapScan();
    const std::string before = mapFile();
    for (const auto& spoiler : spoilers) {
      SCOPED_TRACE(service + ": " + spoiler.name);
      typename Service::Request request = good;
      spoiler.spoil(request);
      expectRefused<Service>(service, request, spoiler.says);
    }
    EXPECT_TRUE(mapFile() == before) << service << " changed the map";
  }

  static inline std::filesystem::path folder;
  static inline NodeClient* client = nullptr;
};

// Of any request that has an array of points by that name, and a frame_id.
template <class Request>
std::vector<Spoiler<Request>> spoiledPoints(std::vector<geometry_msgs::Point> Request::*points,
                                            const std::string& name) {
  std::vector<Spoiler<Request>> spoilers{
      {"an unknown frame", [](auto& r) { r.frame_id = "nowhere"; }, "nowhere"},
      {"a frame of slashes", [](auto& r) { r.frame_id = "//map"; }, "name a frame that tf knows"},
      {"a frame with a space", [](auto& r) { r.frame_id = "a map"; }, "name a frame that tf knows"},
      {"a frame of no letters", [](auto& r) { r.frame_id = std::string("\0\xff\n", 3); }, "name a frame that tf knows"},
      {"too many", [=](auto& r) { (r.*points).resize(kTooMany); },
       name + " has 1001 elements; services/max_points permits 1000"}};
  for (const double bad : {kNan, kInf, -kInf, 1e300, 1.1e8}) {
    for (double geometry_msgs::Point::*axis :
         {&geometry_msgs::Point::x, &geometry_msgs::Point::y, &geometry_msgs::Point::z}) {
      spoilers.push_back(
          {"a point that is no place", [=](auto& r) { (r.*points).back().*axis = bad; }, name + "[1] is ("});
    }
  }
  return spoilers;
}

}  // namespace atom_mapping

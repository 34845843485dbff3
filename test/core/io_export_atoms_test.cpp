#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../test_folder.h"
#include "atom_mapping/base/random.h"
#include "atom_mapping/io/export_atoms.h"
#include "atom_mapping/io/read_atoms.h"

namespace atom_map {
namespace {

namespace fs = std::filesystem;
using pcl::PCLPointField;
using Row = std::vector<double>;

struct Table {
  std::vector<std::string> columns;
  std::vector<int> types;  // of pcl::PCLPointField
  std::vector<Row> rows;
};

Table toTable(const pcl::PCLPointCloud2& cloud) {
  Table table;
  for (const auto& field : cloud.fields) {
    table.columns.push_back(field.name);
    table.types.push_back(field.datatype);
  }
  for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
    Row row;
    for (const auto& field : cloud.fields) {
      const std::uint8_t* at = &cloud.data[i * cloud.point_step + field.offset];
      float single = 0.0F;
      double value = 0.0;
      std::memcpy(&single, at, sizeof(single));
      if (field.datatype == PCLPointField::FLOAT64) std::memcpy(&value, at, sizeof(value));
      row.push_back(field.datatype == PCLPointField::FLOAT64 ? value : static_cast<double>(single));
    }
    table.rows.push_back(row);
  }
  return table;
}

Table readPly(const std::string& file) {
  pcl::PCLPointCloud2 cloud;
  EXPECT_EQ(pcl::PLYReader().read(file, cloud), 0);
  return toTable(cloud);
}

Table readPcd(const std::string& file) {
  pcl::PCLPointCloud2 cloud;
  EXPECT_EQ(pcl::PCDReader().read(file, cloud), 0);
  return toTable(cloud);
}

Table readCsv(const std::string& file) {
  std::ifstream in(file);
  Table table;
  std::string line;
  std::string word;
  std::getline(in, line);
  for (std::istringstream words(line); std::getline(words, word, ',');) table.columns.push_back(word);
  while (std::getline(in, line)) {
    table.rows.emplace_back();
    for (std::istringstream words(line); std::getline(words, word, ',');) table.rows.back().push_back(std::stod(word));
  }
  return table;
}

AtomMap makeMap(Mode mode, const Eigen::Vector3d& origin, int atoms) {
  AtomMap map(mode, 0.25);
  map.anchor(origin);
  Random random(1);
  for (int i = 0; i < atoms; ++i) {
    const Eigen::Vector3f center(100.0F * random.uniform(), 100.0F * random.uniform(), 10.0F * random.uniform());
    const float values[] = {random.uniform() - 0.5F, 0.01F * random.uniform()};
    map.atoms().insert(center, values);
  }
  return map;
}

// What a file should hold.
std::vector<Row> rowsOf(const AtomMap& map) {
  std::vector<Row> rows;
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const Eigen::Vector3d center = map.toMap(atom.center());
    rows.push_back({center.x(), center.y(), center.z(), map.radius(), atom.value(0)});
    if (map.mode() == Mode::kSignedDistance) rows.back().push_back(atom.value(1));
  });
  return rows;
}

void expectSame(const std::vector<Row>& rows, const std::vector<Row>& expected, double tolerance) {
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), expected[i].size());
    for (std::size_t j = 0; j < rows[i].size(); ++j) ASSERT_NEAR(rows[i][j], expected[i][j], tolerance);
  }
}

// What exportAtoms throws; empty if nothing.
template <class Error>
std::string messageOf(const AtomMap& map, const std::string& file) {
  try {
    exportAtoms(map, file);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

class ExportAtoms : public FolderTest {
 protected:
  const AtomMap map_ = makeMap(Mode::kOccupancy, {0, 0, 0}, 1000);
};

TEST_F(ExportAtoms, PlyAndPcdHoldEveryAtomToTheBit) {
  exportAtoms(map_, path("map.ply"));
  exportAtoms(map_, path("map.pcd"));
  for (const Table& table : {readPly(path("map.ply")), readPcd(path("map.pcd"))}) {
    EXPECT_EQ(table.columns, (std::vector<std::string>{"x", "y", "z", "radius", "log_odds"}));
    EXPECT_EQ(table.types, std::vector<int>(5, PCLPointField::FLOAT32));
    expectSame(table.rows, rowsOf(map_), 0.0);
  }
}

TEST_F(ExportAtoms, RenderMapReadsThePly) {
  for (const Eigen::Vector3d& origin : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(691608, 5334760, 520)}) {
    const AtomMap map = makeMap(Mode::kOccupancy, origin, 100);
    exportAtoms(map, path("map.ply"));
    const ExportedAtoms atoms = readAtoms(path("map.ply"));
    EXPECT_EQ(atoms.radius, map.radius());
    std::vector<Row> rows;
    for (std::size_t i = 0; i < atoms.centers.size(); ++i) {
      const Eigen::Vector3d center = atoms.origin + atoms.centers[i].cast<double>();
      rows.push_back({center.x(), center.y(), center.z(), atoms.radius, atoms.log_odds[i]});
    }
    expectSame(rows, rowsOf(map), 1e-5);
  }
}

TEST_F(ExportAtoms, PlyHeaderIsPlain) {
  exportAtoms(map_, path("map.ply"));
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment atoms of an AtomMap, metres\ncomment radius 0.25\n"
      "element vertex 1000\nproperty float x\nproperty float y\nproperty float z\nproperty float radius\n"
      "property float log_odds\nend_header\n";
  EXPECT_EQ(contents(path("map.ply")).substr(0, header.size()), header);
  EXPECT_EQ(fs::file_size(path("map.ply")), header.size() + 1000 * 20);
}

TEST_F(ExportAtoms, CsvHoldsEveryAtomToATenthOfAMillimetre) {
  exportAtoms(map_, path("map.csv"));
  const Table table = readCsv(path("map.csv"));
  EXPECT_EQ(table.columns, (std::vector<std::string>{"x", "y", "z", "radius", "log_odds"}));
  expectSame(table.rows, rowsOf(map_), 1e-4);
}

TEST_F(ExportAtoms, SignedDistanceModeWritesDistanceAndVariance) {
  const AtomMap map = makeMap(Mode::kSignedDistance, {0, 0, 0}, 100);
  const std::vector<std::string> columns = {"x", "y", "z", "radius", "signed_distance", "variance"};
  for (const char* name : {"map.ply", "map.pcd", "map.csv"}) exportAtoms(map, path(name));
  for (const Table& table : {readPly(path("map.ply")), readPcd(path("map.pcd")), readCsv(path("map.csv"))}) {
    EXPECT_EQ(table.columns, columns);
    expectSame(table.rows, rowsOf(map), 1e-4);
  }
}

TEST_F(ExportAtoms, AMapFarFromItsFramesOriginLosesNothing) {
  const AtomMap map = makeMap(Mode::kOccupancy, {691608.0, 5334760.0, 520.0}, 100);  // UTM
  for (const char* name : {"map.ply", "map.pcd", "map.csv"}) exportAtoms(map, path(name));
  for (const Table& table : {readPly(path("map.ply")), readPcd(path("map.pcd"))}) {
    EXPECT_EQ(table.types[1], PCLPointField::FLOAT64);
    EXPECT_EQ(table.types[4], PCLPointField::FLOAT32);
    expectSame(table.rows, rowsOf(map), 1e-9);
  }
  expectSame(readCsv(path("map.csv")).rows, rowsOf(map), 1e-4);
}

TEST_F(ExportAtoms, AnEmptyMapGivesAFileOfNoRows) {
  for (const char* name : {"map.ply", "map.pcd", "map.csv"}) exportAtoms(AtomMap(Mode::kOccupancy, 0.5), path(name));
  EXPECT_NE(contents(path("map.ply")).find("element vertex 0\n"), std::string::npos);
  EXPECT_NE(contents(path("map.pcd")).find("POINTS 0\n"), std::string::npos);
  EXPECT_EQ(contents(path("map.csv")), "x,y,z,radius,log_odds\n");
}

TEST_F(ExportAtoms, AnUnknownExtensionIsRefusedWithTheRemedy) {
  const std::string remedy = "name a file that ends in .ply, .pcd or .csv";
  for (const char* name : {"map.obj", "map", ".ply", "map.ply.gz"}) {
    EXPECT_NE(messageOf<std::invalid_argument>(map_, path(name)).find(remedy), std::string::npos) << name;
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(ExportAtoms, AFileThatCannotBeWrittenIsNamedWithTheReason) {
  EXPECT_EQ(messageOf<std::runtime_error>(map_, path("none/map.ply")),
            "cannot write " + path("none/map.ply") + ": No such file or directory");
  fs::create_directory(path("folder.ply"));
  EXPECT_EQ(messageOf<std::runtime_error>(map_, path("folder.ply")),
            "cannot write " + path("folder.ply") + ": Is a directory");
  EXPECT_FALSE(fs::exists(path("map.ply")));
}

// A limit on the size of files stands for a full disk.
TEST_F(ExportAtoms, AFullDiskIsReportedAndTheOldFileStays) {
  for (const std::string name : {"map.ply", "map.pcd", "map.csv"}) {
    std::ofstream(path(name)) << "old";
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit small{10000, limit.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message = messageOf<std::runtime_error>(map_, path(name));
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    EXPECT_EQ(message, "cannot write " + path(name) + ": File too large");
    EXPECT_EQ(contents(path(name)), "old");
    EXPECT_FALSE(fs::exists(path(name + ".part")));
  }
}

}  // namespace
}  // namespace atom_map

#include "atom_mapping/io/atom_table.h"

#include <pcl/common/io.h>

#include <cstring>

namespace atom_map {
namespace {

constexpr double kFarAway = 1e4;  // m, where floats lie a millimetre apart

void addColumn(pcl::PCLPointCloud2& table, const std::string& name, std::uint8_t type) {
  pcl::PCLPointField column;
  column.name = name;
  column.offset = table.point_step;
  column.datatype = type;
  column.count = 1;
  table.fields.push_back(column);
  table.point_step += static_cast<std::uint32_t>(pcl::getFieldSize(type));
}

pcl::PCLPointCloud2 makeTable(const AtomMap& map, std::uint8_t coordinate_type) {
  pcl::PCLPointCloud2 table;
  for (const char* axis : {"x", "y", "z"}) addColumn(table, axis, coordinate_type);
  addColumn(table, "radius", pcl::PCLPointField::FLOAT32);
  if (map.mode() == Mode::kOccupancy) {
    addColumn(table, "log_odds", pcl::PCLPointField::FLOAT32);
  } else {
    addColumn(table, "signed_distance", pcl::PCLPointField::FLOAT32);
    addColumn(table, "variance", pcl::PCLPointField::FLOAT32);
  }
  table.height = 1;
  table.width = static_cast<std::uint32_t>(map.atoms().size());
  table.row_step = table.width * table.point_step;
  table.data.resize(map.atoms().size() * table.point_step);
  table.is_dense = 1;
  return table;
}

template <class Value>
std::uint8_t* put(std::uint8_t* at, Value value) {
  std::memcpy(at, &value, sizeof(value));  // rows of 28 bytes leave doubles unaligned
  return at + sizeof(value);
}

}  // namespace

pcl::PCLPointCloud2 toTable(const AtomMap& map) {
  const bool is_far = map.origin().norm() > kFarAway;
  const int values = map.mode() == Mode::kOccupancy ? 1 : 2;
  auto table = makeTable(map, is_far ? pcl::PCLPointField::FLOAT64 : pcl::PCLPointField::FLOAT32);
  std::uint8_t* at = table.data.data();
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    for (const double coordinate : map.toMap(atom.center())) {
      at = is_far ? put(at, coordinate) : put(at, static_cast<float>(coordinate));
    }
    at = put(at, map.radius());
    for (int i = 0; i < values; ++i) at = put(at, atom.value(i));
  });
  return table;
}

}  // namespace atom_map

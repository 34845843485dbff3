#include "atom_mapping/io/export_atoms.h"

#include <pcl/io/pcd_io.h>

#include <cstring>
#include <filesystem>
#include <iomanip>
#include <locale>
#include <ostream>
#include <stdexcept>

#include "atom_mapping/io/atom_table.h"
#include "atom_mapping/io/write_file.h"

namespace atom_map {
namespace {

using Table = pcl::PCLPointCloud2;

void writeRows(const Table& table, std::ostream& out) {
  out.write(reinterpret_cast<const char*>(table.data.data()), static_cast<std::streamsize>(table.data.size()));
}

// By hand: PCL's writer leaves no room for a comment, and notices no full disk.
void writePly(const Table& table, float radius, std::ostream& out) {
  out << "ply\nformat binary_little_endian 1.0\ncomment atoms of an AtomMap, metres\n";
  out << "comment radius " << radius << "\nelement vertex " << table.width << "\n";
  for (const pcl::PCLPointField& column : table.fields) {
    out << "property " << (column.datatype == pcl::PCLPointField::FLOAT64 ? "double " : "float ") << column.name
        << "\n";
  }
  out << "end_header\n";
  writeRows(table, out);
}

void writePcd(const Table& table, std::ostream& out) {
  out << pcl::PCDWriter().generateHeaderBinary(table, Eigen::Vector4f::Zero(), Eigen::Quaternionf::Identity());
  out << "DATA binary\n";
  writeRows(table, out);
}

double valueAt(const Table& table, std::size_t row, const pcl::PCLPointField& column) {
  const std::size_t at = row * table.point_step + column.offset;
  double value = 0.0;
  float single = 0.0F;
  if (column.datatype == pcl::PCLPointField::FLOAT64) {
    std::memcpy(&value, &table.data[at], sizeof(value));
    return value;
  }
  std::memcpy(&single, &table.data[at], sizeof(single));
  return single;
}

void writeCsv(const Table& table, std::ostream& out) {
  for (std::size_t i = 0; i < table.fields.size(); ++i) out << (i == 0 ? "" : ",") << table.fields[i].name;
  out << "\n";
  for (std::size_t row = 0; row < table.width; ++row) {
    out << std::fixed << std::setprecision(4);
    for (std::size_t i = 0; i < 3; ++i) out << (i == 0 ? "" : ",") << valueAt(table, row, table.fields[i]);
    out << std::defaultfloat << std::setprecision(6);
    for (std::size_t i = 3; i < table.fields.size(); ++i) out << "," << valueAt(table, row, table.fields[i]);
    out << "\n";
  }
}

std::string extensionOf(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

}  // namespace

bool isAtomFile(const std::string& file) {
  const std::string extension = extensionOf(file);
  return extension == ".ply" || extension == ".pcd" || extension == ".csv";
}

void exportAtoms(const AtomMap& map, const std::string& file) {
  if (!isAtomFile(file)) {
    throw std::invalid_argument("cannot export to " + file + ": name a file that ends in .ply, .pcd or .csv");
  }
  const std::string extension = extensionOf(file);
  const Table table = toTable(map);
  writeFile(file, [&](std::ostream& out) {
    out.imbue(std::locale::classic());
    if (extension == ".ply") writePly(table, map.radius(), out);
    if (extension == ".pcd") writePcd(table, out);
    if (extension == ".csv") writeCsv(table, out);
  });
}

}  // namespace atom_map

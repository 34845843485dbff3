#include "atom_mapping/io/read_atoms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace atom_map {
namespace {

constexpr double kFarthest = 1e6;  // m, from the first atom

struct Property {
  std::string name;
  bool is_double;
};

struct Header {
  bool binary = false;
  std::size_t vertices = 0;
  float radius = 0.0F;
  std::vector<Property> properties;
};

Property readProperty(const std::string& type, std::istream& words) {
  const bool is_double = type == "double" || type == "float64";
  if (!is_double && type != "float" && type != "float32") {
    throw std::runtime_error("its vertices have a property that is neither float nor double");
  }
  std::string name;
  words >> name;
  return {name, is_double};
}

Header readHeader(std::istream& in) {
  Header header;
  std::string line;
  std::getline(in, line);
  if (line.rfind("ply", 0) != 0) throw std::runtime_error("not a PLY file");
  bool in_vertices = false;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string keyword, word;
    words >> keyword >> word;
    if (keyword == "end_header") return header;
    if (keyword == "format") {
      header.binary = word == "binary_little_endian";
      if (!header.binary && word != "ascii") throw std::runtime_error("neither ascii nor binary_little_endian");
    } else if (keyword == "comment" && word == "radius") {
      words >> header.radius;
    } else if (keyword == "element") {
      in_vertices = word == "vertex";
      if (in_vertices) words >> header.vertices;
    } else if (keyword == "property" && in_vertices) {
      header.properties.push_back(readProperty(word, words));
    }
  }
  throw std::runtime_error("its header does not end");
}

std::size_t columnOf(const Header& header, const std::string& name) {
  const auto found = std::find_if(header.properties.begin(), header.properties.end(),
                                  [&](const Property& property) { return property.name == name; });
  if (found == header.properties.end()) throw std::runtime_error("its vertices have no " + name);
  return static_cast<std::size_t>(found - header.properties.begin());
}

template <class Value>
double readBinary(std::istream& in) {
  Value value{};
  in.read(reinterpret_cast<char*>(&value), sizeof(value));
  return static_cast<double>(value);
}

double readValue(std::istream& in, bool binary, bool is_double) {
  if (binary) return is_double ? readBinary<double>(in) : readBinary<float>(in);
  double value = 0.0;
  in >> value;
  return value;
}

ExportedAtoms readStream(std::istream& in) {
  const Header header = readHeader(in);
  if (!(header.radius > 0.0F)) throw std::runtime_error("no comment `radius R` with a positive radius");
  const std::array<std::size_t, 4> columns = {columnOf(header, "x"), columnOf(header, "y"), columnOf(header, "z"),
                                              columnOf(header, "log_odds")};
  ExportedAtoms atoms;
  atoms.radius = header.radius;
  std::vector<double> row(header.properties.size());
  for (std::size_t i = 0; i < header.vertices; ++i) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      row[column] = readValue(in, header.binary, header.properties[column].is_double);
    }
    if (!in) throw std::runtime_error("it ends before its last vertex");
    const Eigen::Vector3d center(row[columns[0]], row[columns[1]], row[columns[2]]);
    if (i == 0) atoms.origin = center.array().floor();
    const bool is_finite = center.allFinite() && std::isfinite(row[columns[3]]);
    if (!is_finite || (center - atoms.origin).cwiseAbs().maxCoeff() > kFarthest) {
      throw std::runtime_error("vertex " + std::to_string(i) +
                               " is no atom: not of finite numbers, or over 1000 km off");
    }
    atoms.centers.emplace_back((center - atoms.origin).cast<float>());
    atoms.log_odds.push_back(static_cast<float>(row[columns[3]]));
  }
  return atoms;
}

}  // namespace

ExportedAtoms readAtoms(const std::string& ply_file) {
  std::ifstream in(ply_file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot open " + ply_file);
  try {
    return readStream(in);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot read " + ply_file + ": " + error.what());
  }
}

std::vector<Eigen::Vector3f> occupiedCenters(const ExportedAtoms& atoms) {
  std::vector<Eigen::Vector3f> centers;
  for (std::size_t i = 0; i < atoms.centers.size(); ++i) {
    if (atoms.log_odds[i] > 0.0F) centers.push_back(atoms.centers[i]);
  }
  return centers;
}

}  // namespace atom_map

#include "atom_mapping/ros/loaded_kind.h"

#include <sstream>
#include <stdexcept>

#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/ros/frame_name.h"

namespace atom_mapping {
namespace {

using atom_map::map_file::nameOf;

template <class Value>
void expectSame(const std::string& file, const char* name, const Value& theirs, const Value& ours,
                const char* other_remedy = "") {
  if (theirs == ours) return;
  std::ostringstream text;
  text << "cannot load " << file << ": its " << name << " is " << theirs << " and this node's is " << ours
       << "; load another map, or start the node with " << name << " " << theirs << other_remedy;
  throw std::runtime_error(text.str());
}

}  // namespace

void checkFrame(const std::string& file, const atom_map::MappingParameters& theirs,
                const atom_map::MappingParameters& ours) {
  expectSame(file, "map_frame", withoutSlash(theirs.map_frame), withoutSlash(ours.map_frame));
}

void refuseKind(const std::string& file, const atom_map::MappingParameters& theirs,
                const atom_map::MappingParameters& ours) {
  const char* const remedy = ", or call ~reset first: an empty map takes over the file's";
  expectSame(file, "mode", std::string(nameOf(theirs.mode)), std::string(nameOf(ours.mode)), remedy);
  expectSame(file, "radius", theirs.radius, ours.radius, remedy);
  throw std::runtime_error("cannot load " + file + ": this node's map has just become another; call again");
}

std::string describeKind(const atom_map::MappingParameters& parameters) {
  std::ostringstream text;
  text << nameOf(parameters.mode) << ", " << parameters.radius << " m";
  return text.str();
}

}  // namespace atom_mapping

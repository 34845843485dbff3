#pragma once

#include <map>
#include <string>
#include <variant>

namespace XmlRpc {
class XmlRpcValue;
}
namespace YAML {
class Node;
}

namespace atom_mapping {

// A list, a null, or whatever else no parameter takes.
struct OtherValue {
  std::string kind;  // for a person, such as "a list"
};

using ParameterValue = std::variant<bool, int, double, std::string, OtherValue>;

// Under full names, such as "scan/max_range".
using ParameterValues = std::map<std::string, ParameterValue>;

// What the parameter server holds under a node's `~`, or a YAML file such as config/atom_mapping.yaml holds. Throw
// std::invalid_argument where the root is no map; nothing at all gives no values.
ParameterValues flatten(const XmlRpc::XmlRpcValue& root);
ParameterValues flatten(const YAML::Node& root);

// Of a YAML file. Throws std::invalid_argument, with the file's name, where it cannot be read.
ParameterValues readParameterFile(const std::string& file);

}  // namespace atom_mapping

#include "atom_mapping/ros/parameter_values.h"

#include <XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>

namespace atom_mapping {
namespace {

using XmlRpc::XmlRpcValue;

ParameterValue toValue(XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value);
    case XmlRpcValue::TypeInt:
      return static_cast<int>(value);
    case XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    case XmlRpcValue::TypeArray:
      return OtherValue{"a list"};
    default:
      return OtherValue{"of another kind"};
  }
}

// A scalar reads as a flag or a number where it looks like one and is not quoted.
ParameterValue toValue(const YAML::Node& value) {
  if (value.IsSequence()) return OtherValue{"a list"};
  if (!value.IsScalar()) return OtherValue{"empty"};
  const bool is_quoted = value.Tag() == "!";
  bool flag = false;
  int number = 0;
  double real = 0.0;
  if (!is_quoted && YAML::convert<bool>::decode(value, flag)) return flag;
  if (!is_quoted && YAML::convert<int>::decode(value, number)) return number;
  if (!is_quoted && YAML::convert<double>::decode(value, real)) return real;
  return value.Scalar();
}

bool isMap(const XmlRpcValue& value) {
  return value.getType() == XmlRpcValue::TypeStruct;
}

bool isMap(const YAML::Node& value) {
  return value.IsMap();
}

bool isNothing(const XmlRpcValue& value) {
  return !value.valid();
}

bool isNothing(const YAML::Node& value) {
  return !value.IsDefined() || value.IsNull();
}

std::string nameOf(const XmlRpcValue::ValueStruct::value_type& entry) {
  return entry.first;
}

std::string nameOf(const YAML::const_iterator::value_type& entry) {
  return entry.first.IsScalar() ? entry.first.Scalar() : "?";
}

template <class Tree>
void addAll(const Tree& tree, const std::string& prefix, ParameterValues& values) {
  for (const auto& entry : tree) {
    const std::string name = prefix + nameOf(entry);
    if (isMap(entry.second)) {
      addAll(entry.second, name + "/", values);
    } else {
      values[name] = toValue(entry.second);
    }
  }
}

template <class Tree>
ParameterValues flattenTree(const Tree& root) {
  ParameterValues values;
  if (isNothing(root)) return values;
  if (!isMap(root)) throw std::invalid_argument("the parameters are no map from names to values");
  addAll(root, "", values);
  return values;
}

}  // namespace

ParameterValues flatten(const XmlRpcValue& root) {
  return flattenTree(root);
}

ParameterValues flatten(const YAML::Node& root) {
  return flattenTree(root);
}

ParameterValues readParameterFile(const std::string& file) {
  try {
    return flatten(YAML::LoadFile(file));
  } catch (const YAML::BadFile&) {
    throw std::invalid_argument("cannot open --config " + file);
  } catch (const std::exception& error) {
    throw std::invalid_argument("--config " + file + ": " + error.what());
  }
}

}  // namespace atom_mapping

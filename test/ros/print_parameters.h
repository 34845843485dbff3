// What parameters hold, as text by their names.
#pragma once

#include <map>
#include <sstream>
#include <string>

#include "atom_mapping/base/describe_parameters.h"

namespace atom_mapping {

// Shown to forEachParameter and its like.
class ParameterPrinter {
 public:
  template <class Number>
  void operator()(const char* name, const Number& value, const atom_map::Range& /*range*/) {
    print(name, value);
  }
  void operator()(const char* name, const std::string& value) { print(name, value); }
  void operator()(const char* name, const bool& value) { print(name, value); }
  template <class Choice>
  void operator()(const char* name, const Choice& value) {
    print(name, static_cast<int>(value));
  }

  std::map<std::string, std::string> texts;

 private:
  template <class Value>
  void print(const char* name, const Value& value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    texts[name] = text.str();
  }
};

}  // namespace atom_mapping

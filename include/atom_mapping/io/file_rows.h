#pragma once

#include <H5Cpp.h>

#include <algorithm>
#include <string>
#include <vector>

#include "atom_mapping/io/map_file_format.h"

namespace atom_map {

// The datasets of a map file that have as many rows, read stretch by stretch: what a file claims to hold is not believed before
// it is there.
class FileRows {
 public:
  explicit FileRows(hsize_t rows) : rows_(rows) {}

  // The next columns are those of the dataset. Throws std::runtime_error where it is not as map_file.h tells, of `width` columns
  // and all the rows; H5::Exception where there is none.
  void add(const H5::H5File& image, const std::string& name, hsize_t width);

  // Calls visit(values) for each column of each stretch of kChunk rows.
  template <class Visit>
  void forEachColumn(Visit&& visit) {
    for (hsize_t begin = 0; begin < rows_; begin += map_file::kChunk) {
      const hsize_t count = std::min<hsize_t>(map_file::kChunk, rows_ - begin);
      for (const Column& column : columns_) {
        read(column, begin, count);
        visit(values_);
      }
    }
  }

 private:
  struct Column {
    H5::DataSet set;
    hsize_t place;
  };
  void read(const Column& column, hsize_t begin, hsize_t count);

  hsize_t rows_;
  std::vector<Column> columns_;
  std::vector<float> values_;  // of one column of one stretch
};

}  // namespace atom_map

#pragma once

#include <H5Cpp.h>

#include <algorithm>
#include <string>
#include <vector>

#include "atom_mapping/io/map_file_format.h"

namespace atom_map {

// The atoms of a map file, read stretch by stretch: what a file claims to hold is not believed before it is there.
class AtomRows {
 public:
  // Throws std::runtime_error where a dataset is not as map_file.h tells, of `rows` rows; H5::Exception where there is none.
  AtomRows(const H5::H5File& image, Mode mode, hsize_t rows);

  // Calls visit(values) for each column of each stretch of kChunk atoms: x, y and z of the centres, then the values.
  template <class Visit>
  void forEachColumn(Visit&& visit) {
    for (hsize_t begin = 0; begin < rows_; begin += map_file::kChunk) {
      const hsize_t count = std::min<hsize_t>(map_file::kChunk, rows_ - begin);
      for (std::size_t c = 0; c < 2 + sets_.size(); ++c) {
        readColumn(c, begin, count);
        visit(column_);
      }
    }
  }

 private:
  void readColumn(std::size_t column, hsize_t begin, hsize_t count);

  hsize_t rows_;
  std::vector<H5::DataSet> sets_;  // centres, then values
  std::vector<float> column_;      // of one stretch
};

}  // namespace atom_map

#pragma once

#include <H5Cpp.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "atom_mapping/io/map_file_format.h"

namespace atom_map {

// The atoms of a map file, read stretch by stretch: what a file claims to hold is not believed before it is there.
class AtomRows {
 public:
  // Throws std::runtime_error where a dataset is not as map_file.h tells, of `rows` rows; H5::Exception where there is none.
  AtomRows(const H5::H5File& image, Mode mode, hsize_t rows);

  // Calls visit(row, centre, values) for each atom; of two values, the second is 0 in occupancy mode.
  template <class Visit>
  void forEach(Visit&& visit) {
    for (hsize_t begin = 0; begin < rows_; begin += map_file::kChunk) {
      const hsize_t count = std::min<hsize_t>(map_file::kChunk, rows_ - begin);
      for (std::size_t c = 0; c < 2 + sets_.size(); ++c) readColumn(c, begin, count);
      for (hsize_t i = 0; i < count; ++i) {
        const std::array<float, 2> values{stretch_[3][i], sets_.size() > 2 ? stretch_[4][i] : 0.0F};
        visit(begin + i, Eigen::Vector3f(stretch_[0][i], stretch_[1][i], stretch_[2][i]), values);
      }
    }
  }

 private:
  void readColumn(std::size_t column, hsize_t begin, hsize_t count);

  hsize_t rows_;
  std::vector<H5::DataSet> sets_;              // centres, then values
  std::array<std::vector<float>, 5> stretch_;  // columns, as in MapCopy
};

}  // namespace atom_map

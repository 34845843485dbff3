#include "atom_mapping/io/file_rows.h"

#include <array>
#include <stdexcept>

namespace atom_map {
namespace {

using map_file::kChunk;

// HDF5 makes room for a whole chunk, however little of it there is.
bool hasOurChunks(const H5::DataSet& set, int rank) {
  const H5::DSetCreatPropList layout = set.getCreatePlist();
  if (layout.getLayout() != H5D_CHUNKED) return false;
  std::array<hsize_t, 2> chunk{0, 1};
  return layout.getChunk(rank, chunk.data()) == rank && chunk[0] <= kChunk && chunk[1] == 1;
}

H5::DataSet openSet(const H5::H5File& image, const std::string& name, hsize_t rows, hsize_t width) {
  const H5::DataSet set = image.openDataSet(name);
  const H5::DataSpace space = set.getSpace();
  const int rank = width == 1 ? 1 : 2;
  std::array<hsize_t, 2> sizes{0, width};
  const bool has_rank = space.getSimpleExtentNdims() == rank;
  if (has_rank) space.getSimpleExtentDims(sizes.data());
  if (!has_rank || sizes[0] != rows || sizes[1] != width) {
    throw std::runtime_error(name + " does not have " + std::to_string(rows) + " rows" +
                             (rank == 2 ? " of " + std::to_string(width) + " columns" : ""));
  }
  if (!(set.getDataType() == H5::PredType::IEEE_F32LE)) {
    throw std::runtime_error(name + " is not made of floats of 32 bits");
  }
  if (rows > 0 && !hasOurChunks(set, rank)) {
    throw std::runtime_error(name + " is not in chunks of one column and at most " + std::to_string(kChunk) + " rows");
  }
  return set;
}

}  // namespace

void FileRows::add(const H5::H5File& image, const std::string& name, hsize_t width) {
  const H5::DataSet set = openSet(image, name, rows_, width);
  for (hsize_t place = 0; place < width; ++place) columns_.push_back({set, place});
}

void FileRows::read(const Column& column, hsize_t begin, hsize_t count) {
  const H5::DataSpace source = column.set.getSpace();
  const std::array<hsize_t, 2> start{begin, column.place};
  const std::array<hsize_t, 2> size{count, 1};
  source.selectHyperslab(H5S_SELECT_SET, size.data(), start.data());
  values_.resize(count);
  column.set.read(values_.data(), H5::PredType::NATIVE_FLOAT, H5::DataSpace(1, size.data()), source);
}

}  // namespace atom_map

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include "atom_mapping/io/read_atoms.h"

using atom_map::readAtoms;

namespace {

const char* const kHeader =
    "ply\nformat ascii 1.0\ncomment radius 0.25\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty float log_odds\nend_header\n";

class ReadAtoms : public testing::Test {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }

  const std::string& write(const std::string& content) const {
    std::ofstream(file_, std::ios::binary) << content;
    return file_;
  }

  std::string file_ = testing::TempDir() + "/read_atoms_test.ply";
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

Eigen::Vector3d centerOf(const atom_map::ExportedAtoms& atoms, std::size_t i) {
  return atoms.origin + atoms.centers[i].cast<double>();
}

TEST_F(ReadAtoms, takesAsciiAsItIsWritten) {
  const auto atoms = readAtoms(write(std::string(kHeader) + "1 2 3 0.5\n4 5 6 -0.5\n"));
  EXPECT_EQ(atoms.radius, 0.25F);
  ASSERT_EQ(atoms.centers.size(), 2U);
  EXPECT_EQ(centerOf(atoms, 1), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(atoms.log_odds, (std::vector<float>{0.5F, -0.5F}));
}

TEST_F(ReadAtoms, onlyPositiveLogOddsAreOccupied) {
  const auto occupied = occupiedCenters(readAtoms(write(std::string(kHeader) + "1 2 3 0.5\n4 5 6 -0.5\n")));
  ASSERT_EQ(occupied.size(), 1U);
  EXPECT_EQ(occupied[0], Eigen::Vector3f(0, 0, 0));
}

TEST_F(ReadAtoms, takesBinary) {
  const float rows[] = {1, 2, 3, 0.5F, 4, 5, 6, -0.5F};
  const std::string header = replaced(kHeader, "ascii", "binary_little_endian");
  const auto atoms = readAtoms(write(header + std::string(reinterpret_cast<const char*>(rows), sizeof rows)));
  EXPECT_EQ(centerOf(atoms, 1), Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(atoms.log_odds[1], -0.5F);
}

TEST_F(ReadAtoms, doublesFarFromTheOriginKeepTheirMillimetres) {
  const std::string header = replaced(kHeader, "float x", "double x");
  const auto atoms = readAtoms(write(header + "500000.125 0 0 1\n500010.127 0 0 1\n"));
  EXPECT_NEAR(centerOf(atoms, 1).x(), 500010.127, 1e-5);
}

TEST_F(ReadAtoms, findsPropertiesByName) {
  const std::string header = replaced(replaced(kHeader, "property float x\n", "property float variance\n"),
                                      "log_odds\n", "log_odds\nproperty float x\n");
  const auto atoms = readAtoms(write(header + "9 2 3 0.5 1\n9 5 6 0.5 4\n"));
  EXPECT_EQ(centerOf(atoms, 1), Eigen::Vector3d(4, 5, 6));
}

TEST_F(ReadAtoms, saysWhatIsWrong) {
  const std::string rows = "1 2 3 0.5\n4 5 6 -0.5\n";
  const std::string header = kHeader;
  EXPECT_THROW(readAtoms("/no/such/file.ply"), std::runtime_error);
  for (const std::string& content :
       {std::string(), "PNG" + header + rows, header, header + "1 2 3 0.5\n4 5", replaced(header, "end_header\n", ""),
        replaced(header, "radius 0.25", "made by hand") + rows, replaced(header, "0.25", "-1") + rows,
        replaced(header, "float z", "uchar z") + rows, replaced(header, "log_odds", "color") + rows,
        replaced(header, "vertex 2", "vertex 4000000000") + rows,
        replaced(header, "ascii", "binary_big_endian") + rows}) {
    EXPECT_THROW(readAtoms(write(content)), std::runtime_error) << content;
  }
}

TEST_F(ReadAtoms, refusesWhatIsNoAtom) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string header = replaced(kHeader, "ascii", "binary_little_endian");
  for (const auto& [place, value] :
       {std::pair(0, nan), std::pair(1, nan), std::pair(2, nan), std::pair(4, nan), std::pair(5, nan),
        std::pair(6, nan), std::pair(5, 1.0F / 0.0F), std::pair(6, 1e9F), std::pair(7, nan)}) {
    float rows[] = {1, 2, 3, 0.5F, 4, 5, 6, -0.5F};
    rows[place] = value;
    EXPECT_THROW(readAtoms(write(header + std::string(reinterpret_cast<const char*>(rows), sizeof rows))),
                 std::runtime_error)
        << place;
  }
}

}  // namespace

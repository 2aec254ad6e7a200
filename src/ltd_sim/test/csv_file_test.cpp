#include "ltd_sim/csv_file.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "scratch_directory.hpp"
#include "train_fixtures.hpp"

namespace {

TEST(AllDigitsTest, ReadsBackTheSameBits) {
  double x = 1.0 / 3.0;
  for (int i = 0; i < 10000; ++i) {
    EXPECT_EQ(std::strtod(ltd::allDigits(x).c_str(), nullptr), x);
    EXPECT_EQ(std::strtod(ltd::allDigits(-x).c_str(), nullptr), -x);
    x = std::nextafter(x * 1.0137, 1e300);
  }
  for (const double edge : {0.0, 0.1, 1e-310, 1e300, std::nextafter(1.0, 2.0), 4.10e6 / 460089.0})
    EXPECT_EQ(std::strtod(ltd::allDigits(edge).c_str(), nullptr), edge);
}

TEST(AllDigitsTest, UsesNoMoreDigitsThanNeeded) {
  EXPECT_EQ(ltd::allDigits(0.1), "0.1");
  EXPECT_EQ(ltd::allDigits(3.15), "3.15");
  EXPECT_EQ(ltd::allDigits(-460089.0), "-460089");
  EXPECT_EQ(ltd::allDigits(0.1 + 0.2), "0.30000000000000004");
}

class CsvFileTest : public fixtures::ScratchDirectory {};

TEST_F(CsvFileTest, HasAHeaderAndItsRowsWithEmptyCellsKept) {
  ltd::CsvFile file(path("a.csv"), {"x", "y", "z"});
  file.row({"1", "", "3"});
  file.row({"", "", ""});
  file.flush();
  EXPECT_EQ(read("a.csv"), "x,y,z\n1,,3\n,,\n");
}

TEST_F(CsvFileTest, RefusesARowThatDoesNotFitItsColumns) {
  ltd::CsvFile file(path("a.csv"), {"x", "y"});
  EXPECT_THROW(file.row({"1"}), std::runtime_error);
  EXPECT_THROW(file.row({"1", "2", "3"}), std::runtime_error);
}

TEST_F(CsvFileTest, NamesThePathAndTheReasonIfItCannotBeOpened) {
  try {
    ltd::CsvFile file(path("no/such/a.csv"), {"x"});
    FAIL() << "opened";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(fixtures::contains(error.what(), "no/such/a.csv: cannot be written: No such file"));
  }
}

TEST_F(CsvFileTest, MakesDirectoriesWithTheirParentsAndNamesThoseItCannot) {
  ltd::makeDirectories(path("a/b/c"));
  ltd::makeDirectories(path("a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(path("a/b/c")));
  write("file", "");
  try {
    ltd::makeDirectories(path("file/d"));
    FAIL() << "made";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(fixtures::contains(error.what(), "file/d: cannot be made: "));
  }
}

}  // namespace

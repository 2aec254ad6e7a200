#include <gtest/gtest.h>

#include <sstream>

#include "creep_force_table.hpp"
#include "loco_dynamics/contact/hertz.hpp"

namespace {

struct Answer {
  int status;
  std::string output;
  std::string errors;
};

Answer run(const std::vector<std::string>& arguments, const std::string& input) {
  std::istringstream in(input);
  std::ostringstream out, errors;
  const int status = loco::creepForceProgram(arguments, in, out, errors);
  return {status, out.str(), errors.str()};
}

const std::string kHeader = "a_mm,b_mm,N_N,V_mps,mu0,A,B_s_per_m,k0,alpha_inf,beta,creep_x,creep_y,spin_rad_per_m";
const std::string kSlide = "6,4,100000,10,0.35,1,0,1,1,0,";  // no reduction, Coulomb

/// Last two cells of the line with this number.
std::pair<double, double> forcesAt(const std::string& output, int number) {
  std::istringstream lines(output);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(lines, line);
  const std::size_t y = line.rfind(','), x = line.rfind(',', y - 1);
  return {std::stod(line.substr(x + 1)), std::stod(line.substr(y + 1))};
}

TEST(CreepForceTest, UnknownOptionsAndValuesAreRefused) {
  for (const std::vector<std::string>& bad :
       std::vector<std::vector<std::string>>{{"--methode", "polach"},
                                             {"--method", "fastsimm"},
                                             {"--method"},
                                             {"--grid", "20"},
                                             {"--grid", "0x4"},
                                             {"--grid", "20x20x20"},
                                             {"--grid", "20x-3"},
                                             {"--method", "closed", "--grid", "4x4"},
                                             {"--k-a", "0.3"},
                                             {"--k-a", "0.3", "--k-s", "0.1"},
                                             {"--method", "polach", "--k-a", "0.1", "--k-s", "0.3"},
                                             {"--method", "polach", "--k-a", "1.5", "--k-s", "0.3"},
                                             {"--flexibility", "one"},
                                             {"cases.csv"}}) {
    const Answer answer = run(bad, kHeader + "\n" + kSlide + "0.1,0,0\n");
    EXPECT_EQ(answer.status, 2) << bad.front();
    EXPECT_TRUE(answer.output.empty()) << bad.front();
    EXPECT_NE(answer.errors.find("creep_force: "), std::string::npos);
  }
}

TEST(CreepForceTest, AFaultOfTheCommandLineSaysWhatThereIs) {
  const std::string more = "\ncreep_force --help tells more\n";
  EXPECT_EQ(run({"--methode", "polach"}, "").errors,
            "creep_force: --methode: unknown option, did you mean '--method'?" + more);
  EXPECT_EQ(run({"--verbose"}, "").errors,
            "creep_force: --verbose: unknown option; there are: --method, --grid, --flexibility, --k-a, --k-s" + more);
  EXPECT_EQ(run({"cases.csv"}, "").errors,
            "creep_force: cases.csv: is no option: cases are read from standard input, creep_force < CASES.csv" + more);
  EXPECT_EQ(run({"--method", "--grid", "4x4"}, "").errors, "creep_force: --method: needs a value after it" + more);
}

TEST(CreepForceTest, HelpIsNoError) {
  const Answer answer = run({"--help"}, "");
  EXPECT_EQ(answer.status, 0);
  EXPECT_NE(answer.output.find("usage: creep_force"), std::string::npos);
}

TEST(CreepForceTest, BadRowsAreNamedWithTheirLineAndTheOthersComputed) {
  const Answer answer = run({}, kHeader + "\n" + kSlide + "0.1,0,0\n" + kSlide + "zero,0,0\n# a comment\n" + kSlide +
                                    "0.1,0\n-6,4,100000,10,0.35,1,0,0,1,0,0.1,0,0\n" + kSlide + "-0.1,0,0\n");
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.errors.find("standard input: line 3: creep_x = zero: must be a number"), std::string::npos);
  EXPECT_NE(answer.errors.find("standard input: line 5: has 12 cells"), std::string::npos);
  EXPECT_NE(answer.errors.find("standard input: line 6: a_mm = -6: must be > 0 and <= 1000"), std::string::npos);
  EXPECT_NE(answer.errors.find("standard input: line 6: k0 = 0: must be > 0 and <= 1"), std::string::npos);
  EXPECT_EQ(answer.output, kHeader + ",Fx_N,Fy_N\n" + kSlide + "0.1,0,0,-35000,0\n" + kSlide + "-0.1,0,0,35000,0\n");
}

TEST(CreepForceTest, FaultsAreToldInTheOrderOfTheirLines) {
  const Answer answer = run(
      {}, kHeader + "\n" + kSlide + "101,0,0\n" + kSlide + "zero,0,0\n" + kSlide + "0,0,-101\n" + kSlide + "0.1,0\n");
  EXPECT_EQ(
      answer.errors,
      "standard input: line 2: creep_x = 101: must be >= -100 and <= 100\n"
      "standard input: line 2: creep_x = 101: a ratio, 0.07 for 7 %: over V_mps it is a slip of 1010 m/s, must be "
      "<= 60\n"
      "standard input: line 3: creep_x = zero: must be a number\n"
      "standard input: line 4: spin_rad_per_m = -101: must be >= -100 and <= 100\n"
      "standard input: line 5: has 12 cells, the header names 13\n");
}

TEST(CreepForceTest, APercentageIsNoCreepageButARacingWheelHasOneBeyond1) {
  const Answer percent = run({}, kHeader + "\n" + kSlide + "7,0,0\n" + kSlide + "0,-7,0\n");
  EXPECT_EQ(
      percent.errors,
      "standard input: line 2: creep_x = 7: a ratio, 0.07 for 7 %: over V_mps it is a slip of 70 m/s, must be <= "
      "60\nstandard input: line 3: creep_y = -7: a ratio, 0.07 for 7 %: over V_mps it is a slip of 70 m/s, must be "
      "<= 60\n");
  const Answer racing = run({}, kHeader + "\n6,4,100000,0.5,0.35,1,0,1,1,0,70,0,0\n");
  EXPECT_EQ(racing.status, 0) << racing.errors;
  EXPECT_EQ(forcesAt(racing.output, 2).first, -35000.0);
}

TEST(CreepForceTest, EveryRangeIsChecked) {
  for (const char* bad :
       {"0,4,1e5,10,.35,1,0,1,1,0", "6,0,1e5,10,.35,1,0,1,1,0", "6,4,-1,10,.35,1,0,1,1,0", "6,4,1e5,-1,.35,1,0,1,1,0",
        "6,4,1e5,10,0,1,0,1,1,0", "6,4,1e5,10,1.1,1,0,1,1,0", "6,4,1e5,10,.35,0,0,1,1,0", "6,4,1e5,10,.35,1.1,0,1,1,0",
        "6,4,1e5,10,.35,1,-1,1,1,0", "6,4,1e5,10,.35,1,0,0,1,0", "6,4,1e5,10,.35,1,0,1.1,1,0",
        "6,4,1e5,10,.35,1,0,1,-.1,0", "6,4,1e5,10,.35,1,0,1,1.1,0", "6,4,1e5,10,.35,1,0,1,1,-1",
        "6,4,nan,10,.35,1,0,1,1,0", "6,4,1e5,10,.35,1,0,1,1,"}) {
    const Answer answer = run({}, kHeader + "\n" + bad + ",0.01,0,0\n");
    EXPECT_EQ(answer.status, 2) << bad;
    EXPECT_NE(answer.errors.find("standard input: line 2: "), std::string::npos) << bad;
  }
}

TEST(CreepForceTest, HeaderFaultsLeaveNothingComputed) {
  for (const std::string& header : {std::string("a_mm,b_mm"), kHeader + ",Nu", kHeader + ",a_mm", std::string()}) {
    const Answer answer = run({}, header + "\n" + kSlide + "0.1,0,0\n");
    EXPECT_EQ(answer.status, 2) << header;
    EXPECT_TRUE(answer.output.empty()) << header;
  }
  EXPECT_NE(run({}, kHeader + ",G_Gpa\n").errors.find("unknown column 'G_Gpa'"), std::string::npos);
}

TEST(CreepForceTest, ColumnsMayComeInAnyOrderAndRowsAreEchoedAsTheyStand) {
  const Answer answer = run({"--method", "fastsim"},
                            "# cases\nspin_rad_per_m, creep_y,creep_x,B_s_per_m,A,mu0,V_mps,N_N,b_mm,a_mm,nu,G_GPa\r\n"
                            "0,0,1.0e1 ,0,1,.5,0,+1000,4,6,0.25,80\r\n");
  EXPECT_EQ(answer.status, 0) << answer.errors;
  EXPECT_EQ(answer.output,
            "spin_rad_per_m, creep_y,creep_x,B_s_per_m,A,mu0,V_mps,N_N,b_mm,a_mm,nu,G_GPa,Fx_N,Fy_N\n"
            "0,0,1.0e1 ,0,1,.5,0,+1000,4,6,0.25,80,-500,0\n");
}

TEST(CreepForceTest, ShearModulusAndPoissonsRatioMatterWhereGiven) {
  const std::string case_row = kSlide + "1e-5,0,0";
  const double steel = forcesAt(run({"--method", "closed"}, kHeader + "\n" + case_row + "\n").output, 2).first;
  const Answer same = run({"--method", "closed"}, kHeader + ",G_GPa,nu\n" + case_row + ",82,0.28\n");
  const Answer soft = run({"--method", "closed"}, kHeader + ",G_GPa,nu\n" + case_row + ",41,0.28\n");
  EXPECT_EQ(forcesAt(same.output, 2).first, steel);
  EXPECT_NEAR(forcesAt(soft.output, 2).first, 0.5 * steel, 0.002 * -steel);  // a little less saturated
}

TEST(CreepForceTest, AnEllipseMayComeFromCurvaturesAndLoad) {
  const loco::HertzContact hertz({1.9, 1.1}, {200e9, 0.28});
  const auto [a_m, b_m] = hertz.computeEllipse(100e3);
  std::ostringstream given;
  given.precision(17);
  given << kHeader << "\n" << 1e3 * a_m << ',' << 1e3 * b_m << ",100000,10,0.35,1,0,1,1,0,0.001,0,0\n";
  const std::string rest = kHeader.substr(std::string("a_mm,b_mm").size());
  const Answer curved = run({}, "curvature_along_1pm,curvature_across_1pm" + rest +
                                    ",E_GPa\n1.9,1.1,100000,10,0.35,1,0,1,1,0,0.001,0,0,200\n");
  EXPECT_EQ(curved.status, 0) << curved.errors;
  EXPECT_NEAR(forcesAt(curved.output, 2).first, forcesAt(run({}, given.str()).output, 2).first, 1e-5);
  EXPECT_EQ(run({}, "a_mm,curvature_along_1pm" + rest + "\n").status, 2);
}

TEST(CreepForceTest, SignsAreContacts) {
  const Answer answer = run({}, kHeader + "\n" + kSlide + "0.001,0.001,0\n" + kSlide + "0,0,0.1\n");
  EXPECT_EQ(answer.status, 0);
  EXPECT_LT(forcesAt(answer.output, 2).first, 0.0);
  EXPECT_LT(forcesAt(answer.output, 2).second, 0.0);
  EXPECT_LT(forcesAt(answer.output, 3).second, 0.0);  // as in contact_modfastsim.csv
}

TEST(CreepForceTest, ClosedRefusesSpin) {
  const Answer answer = run({"--method", "closed"}, kHeader + "\n" + kSlide + "0.1,0,0.2\n");
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.errors.find("line 2: spin_rad_per_m = 0.2: must be 0 for --method closed"), std::string::npos);
}

TEST(CreepForceTest, PolachTakesItsFactorsFromColumnsOrOptions) {
  const std::string dry = "6,4,100000,10,0.55,0.4,0.6,1,1,0,0.001,0,0";
  const Answer neither = run({"--method", "polach"}, kHeader + "\n" + dry + "\n");
  const Answer ones = run({"--method", "polach", "--k-a", "1", "--k-s", "1"}, kHeader + "\n" + dry + "\n");
  EXPECT_EQ(neither.status, 0);
  EXPECT_EQ(neither.output, ones.output);
  const Answer columns = run({"--method", "polach"}, kHeader + ",kA,kS\n" + dry + ",1.0,0.4\n");
  const Answer options = run({"--method", "polach", "--k-a", "1.0", "--k-s", "0.4"}, kHeader + "\n" + dry + "\n");
  EXPECT_NEAR(forcesAt(columns.output, 2).first, -6425.0, 0.5);
  EXPECT_EQ(forcesAt(columns.output, 2), forcesAt(options.output, 2));
  EXPECT_EQ(run({"--method", "polach"}, kHeader + ",kA,kS\n" + dry + ",0.1,0.4\n").status, 2);
}

}  // namespace

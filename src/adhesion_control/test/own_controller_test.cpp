#include "own_controller.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "adhesion_control/lagged_controller.hpp"
#include "controller_fixtures.hpp"

namespace {

std::string contentOf(const std::string& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(OwnControllerTest, CutsASlippingAxleForItsTime) {
  const CutBackController controller(0.07, 0.5, 3000000, coCo());
  Driven driven(controller, coCo());
  driven.setReference(40e3);
  driven.setSlip(2, 0.08);
  std::vector<double> torque;
  for (int k = 0; k < 5; ++k) {
    driven.step();
    torque.push_back(driven.commands[2].torque_N_m);
    EXPECT_EQ(driven.commands[1].torque_N_m, 40e3);
    driven.setSlip(2, 0.0);
  }
  EXPECT_EQ(torque, (std::vector<double>{20e3, 20e3, 20e3, 40e3, 40e3}));
}

TEST(OwnControllerTest, MayHaveTheMotorsLagBehindIt) {
  const adhesion::LaggedController lagged(std::make_unique<CutBackController>(0.07, 0.5, 3000000, coCo()), 0.02,
                                          coCo());
  EXPECT_EQ(lagged.stateSize(), 12u);
}

TEST(OwnControllerTest, StandsInTheDocumentationAsItIsCompiledHere) {
  const std::string directory = TEST_DATA_DIR;
  const std::string code = contentOf(directory + "/own_controller.hpp");
  ASSERT_FALSE(code.empty());
  const std::string text = contentOf(directory + "/../../../docs/adhesion_control.md");
  EXPECT_NE(text.find("```cpp\n" + code + "```\n"), std::string::npos);
}

}  // namespace

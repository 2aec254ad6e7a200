#include "train_viz/train_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_fixtures.hpp"
#include "train_viz/colour_scale.hpp"

namespace {

using viz::TrainOutline;
using viz::TrainShape;

class TrainShapeTest : public fixtures::PaperLine {
 protected:
  TrainShape at(double head_m, int chosen = 1) const {
    return computeTrainShape(outline, world, chosen, placesFrom(head_m), noForces());
  }
};

TEST(TrainOutlineTest, RefusesWhatIsNoScenario) {
  EXPECT_THROW(TrainOutline::read("name: nothing"), rail::ConfigError);
  EXPECT_THROW(TrainOutline::read("]"), rail::ConfigError);
}

TEST(TrainOutlineTest, HasThePapersTrainWithTheAxlesOfItsBodies) {
  const TrainOutline outline = fixtures::outlineOf("paper_3d");
  ASSERT_EQ(outline.vehicles.size(), 108U);
  EXPECT_EQ(outline.locomotives, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(outline.vehicles[1].locomotive, 2);
  EXPECT_FALSE(outline.vehicles[3].locomotive);
  EXPECT_EQ(outline.vehicles[3].axles_m().size(), 4U);
  const std::vector<double> axles_m = outline.vehicles[0].axles_m();
  ASSERT_EQ(axles_m.size(), 6U);
  const double expected_m[] = {8.495, 6.645, 4.795, -4.795, -6.645, -8.495};  // config/bodies/co_co_134t.yaml
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(axles_m[i], expected_m[i], 1e-12) << i;
}

TEST(TrainOutlineTest, CountsLocomotivesInTheMiddleOfATrain) {
  const TrainOutline outline = fixtures::outlineOf("empties_distributed_power");
  ASSERT_EQ(outline.locomotives.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(outline.vehicles[outline.locomotives[i]].locomotive, static_cast<int>(i + 1));
  EXPECT_GT(outline.locomotives[2], 2U) << "not all at the head";
}

TEST_F(TrainShapeTest, OnStraightTrackBodiesStandInLineOverTheirPlaces) {
  const TrainShape shape = at(3000.0);
  for (std::size_t i = 0; i < shape.bodies.size(); ++i) {
    const Eigen::Isometry3d& X = shape.bodies[i].X_WB;
    EXPECT_NEAR(X.translation().x(), placesFrom(3000.0)[i], 1e-9);
    EXPECT_NEAR(X.translation().y(), 0.0, 1e-9);
    EXPECT_GT(X.translation().z(), 1.0) << "up is up";
    EXPECT_TRUE(X.linear().isIdentity(1e-12));
  }
  const double front_bogie_m = 3000.0 - 22.0 + 6.645;  // of the second locomotive, the first that is not chosen
  EXPECT_NEAR(shape.bogies[0].X_WB.translation().x(), front_bogie_m, 1e-9);
  EXPECT_NEAR(shape.bogies[1].X_WB.translation().x(), front_bogie_m - 2.0 * 6.645, 1e-9);
}

/// In the circular part a bogie's centre is 300 m from the circle's centre, a body's by the arrow of its chord less,
/// and both have the heading of the tangent. paper_3d's own car body stands 75 mm inside at 26 km/h, this one 74 mm.
TEST_F(TrainShapeTest, InTheCurveBogiesLieOnTheCircleAndBodiesOnTheirChord) {
  const rail::TrackPose begin = world.at(3350.0);
  const Eigen::Vector2d centre(begin.x_m - 300.0 * std::sin(begin.heading_rad),
                               begin.y_m + 300.0 * std::cos(begin.heading_rad));
  const std::vector<double> s_m = placesFrom(3540.0);
  const TrainShape shape = at(3540.0, 3);
  int checked = 0;
  for (std::size_t i = 0; s_m[i] > 3360.0; ++i, ++checked) {
    const Eigen::Isometry3d& X = shape.bodies[i].X_WB;
    const Eigen::Vector2d from_centre = X.translation().head<2>() - centre;
    const double half_angle_rad = outline.vehicles[i].bogies[0].x_m / 300.0;  // of the arc from bogie to bogie
    EXPECT_NEAR(from_centre.norm(), 300.0 * std::cos(half_angle_rad),
                1e-4);  // the plan is integrated to 1e-6 m over 5 m
    EXPECT_NEAR(300.0 - from_centre.norm(), outline.vehicles[i].locomotive ? 0.0736 : 0.0459, 1e-4);
    EXPECT_NEAR(from_centre.normalized().dot(X.linear().col(0).head<2>()), 0.0, 1e-6);
    const double turned = std::atan2(X.linear()(1, 0), X.linear()(0, 0)) - begin.heading_rad;
    EXPECT_NEAR(turned, (s_m[i] - 3350.0) / 300.0, 1e-6) << "to the left";
  }
  EXPECT_GE(checked, 10);
  for (std::size_t i = 0; i < 8; ++i)  // of the two locomotives that are not chosen and two wagons
    EXPECT_NEAR((shape.bogies[i].X_WB.translation().head<2>() - centre).norm(), 300.0, 1e-4);
}

TEST_F(TrainShapeTest, BodiesAreAsLongAsTheVehiclesLessTheCouplersRoom) {
  const TrainShape shape = at(3000.0);
  EXPECT_NEAR(shape.bodies[0].size_m.x(), 22.0 - viz::kBodyGap_m, 1e-12);
  EXPECT_NEAR(shape.bodies[3].size_m.x(), 15.0 - viz::kBodyGap_m, 1e-12);
  EXPECT_GT(shape.bodies[0].size_m.z(), shape.bodies[3].size_m.z()) << "a locomotive is taller than a wagon";
  ASSERT_EQ(shape.roofs.size(), 4U) << "of the wagons, and of each locomotive";
  EXPECT_EQ(shape.roofs[0].points.size(), 105U * 6U);
  const std::vector<Eigen::Vector3d>& first = shape.roofs[1].points;
  ASSERT_EQ(first.size(), 6U);
  for (const Eigen::Vector3d& point : first) EXPECT_NEAR(point.z(), 4.2, 0.05);
  EXPECT_GT((first[1] - first[0]).cross(first[2] - first[1]).z(), 0.0) << "seen from above";
}

/// At 3540 m the line points 43 degrees to the left of the map's x.
TEST_F(TrainShapeTest, LocomotivesAreCarriedByTheirOwnFramesAllElseByTheTrain) {
  const TrainShape shape = at(3540.0, 2);
  ASSERT_EQ(shape.carriers.size(), 4U);
  EXPECT_EQ(shape.carriers[0].frame, "train");
  EXPECT_EQ(shape.carriers[3].frame, "loco_3/base_link");
  EXPECT_TRUE(shape.carriers[0].X_WC.linear().isIdentity(0.0)) << "the end of the train must not swing";
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Isometry3d X_WT = viz::frameOf(world.at(placesFrom(3540.0)[i]));
    EXPECT_TRUE(shape.carriers[i + 1].X_WC.isApprox(X_WT, 1e-12)) << i;
    EXPECT_EQ(shape.bodies[i].carrier, i + 1);
    EXPECT_EQ(shape.roofs[i + 1].carrier, i + 1);
  }
  EXPECT_EQ(shape.carriers[0].X_WC.translation(), shape.carriers[1].X_WC.translation());
  EXPECT_EQ(shape.chosen, 2U);
  EXPECT_EQ(shape.chosen_bogies[1].carrier, 2U);
  EXPECT_EQ(shape.bogies[0].carrier, 1U);
  EXPECT_EQ(shape.bogies[2].carrier, 3U);
  EXPECT_EQ(shape.bogies[4].carrier, 0U) << "of the first wagon";
  EXPECT_EQ(shape.bodies[3].carrier, 0U);
  EXPECT_EQ(shape.couplers[0].carrier, 0U);
}

TEST_F(TrainShapeTest, CouplersReachFromBodyToBody) {
  for (const double head_m : {3000.0, 3500.0}) {
    const TrainShape shape = at(head_m);
    ASSERT_EQ(shape.couplers.size(), 107U);
    for (std::size_t i = 0; i < shape.couplers.size(); ++i) {
      const viz::Box &front = shape.bodies[i], &rear = shape.bodies[i + 1], &coupler = shape.couplers[i];
      const Eigen::Vector3d begin = coupler.X_WB * Eigen::Vector3d(0.5 * coupler.size_m.x(), 0.0, 0.0);
      const Eigen::Vector3d end = coupler.X_WB * Eigen::Vector3d(-0.5 * coupler.size_m.x(), 0.0, 0.0);
      const Eigen::Vector3d in_front = front.X_WB.inverse() * begin, in_rear = rear.X_WB.inverse() * end;
      EXPECT_NEAR(in_front.x(), -0.5 * front.size_m.x(), 1e-9) << i;
      EXPECT_NEAR(in_front.y(), 0.0, 1e-9);
      EXPECT_NEAR(in_rear.x(), 0.5 * rear.size_m.x(), 1e-9) << i;
      EXPECT_NEAR(begin.z(), viz::kCouplerHeight_m, 1e-9);
      if (head_m == 3000.0) {
        EXPECT_NEAR(coupler.size_m.x(), viz::kBodyGap_m, 1e-9) << i;
      }
    }
  }
}

TEST_F(TrainShapeTest, ACouplerThatStretchesIsDrawnLonger) {
  std::vector<double> s_m = placesFrom(3000.0);
  for (std::size_t i = 5; i < s_m.size(); ++i) s_m[i] -= 0.05;
  const TrainShape shape = computeTrainShape(outline, world, 1, s_m, noForces());
  EXPECT_NEAR(shape.couplers[4].size_m.x(), viz::kBodyGap_m + 0.05, 1e-9);
}

TEST_F(TrainShapeTest, DraftIsDrawnRedAndToTheLeftBuffBlueAndToTheRight) {
  std::vector<double> force_N = noForces();
  force_N[10] = 500e3;
  force_N[20] = -250e3;
  const TrainShape shape = computeTrainShape(outline, world, 1, placesFrom(3000.0), force_N);
  EXPECT_GT(shape.couplers[10].colour.r, shape.couplers[10].colour.b);
  EXPECT_GT(shape.couplers[20].colour.b, shape.couplers[20].colour.r);
  double left_m = 0.0, right_m = 0.0;
  for (const Eigen::Vector3d& point : shape.force_diagram.points) {
    left_m = std::max(left_m, point.y());
    right_m = std::min(right_m, point.y());
  }
  EXPECT_NEAR(left_m, 500e3 * viz::kDiagram_m_per_N, 1e-9);
  EXPECT_NEAR(right_m, -250e3 * viz::kDiagram_m_per_N, 1e-9);
}

TEST_F(TrainShapeTest, WheelsOfTheChosenLocomotiveStandOnTheRails) {
  const TrainShape shape = at(3000.0, 2);
  double lowest_m = 1.0, widest_m = 0.0;
  ASSERT_EQ(shape.chosen_bogies.size(), 2U);
  ASSERT_EQ(shape.chosen_wheels.size(), 18U) << "an axle and two wheels each";
  for (const viz::Cylinder& wheel : shape.chosen_wheels) {
    const Eigen::Vector3d& centre = wheel.X_WC.translation();
    lowest_m = std::min(lowest_m, centre.z() - 0.5 * wheel.size_m.x());
    EXPECT_NEAR(std::abs(wheel.X_WC.linear().col(2).y()), 1.0, 1e-12) << "its axle lies across the line";
    EXPECT_NEAR(centre.x(), placesFrom(3000.0)[1], 8.5);
    widest_m = std::max(widest_m, centre.y());
  }
  EXPECT_NEAR(lowest_m, 0.0, 1e-9);
  EXPECT_NEAR(widest_m, 0.75, 1e-9);
  EXPECT_EQ(shape.bogies.size(), 2U * 107U) << "its bogies are not drawn twice";
}

/// At 15.9 km of mine_to_port.csv: 9 per mille downhill, a curve with 95 mm of cant.
TEST(TrainShapeOnALineTest, BodiesClimbAndLeanWithTheirBogies) {
  const TrainOutline outline = fixtures::outlineOf("mine_to_port_1d");
  const rail::WorldTrack world(outline.track);
  const std::vector<double> s_m(outline.vehicles.size(), 15.9e3);
  const TrainShape shape = computeTrainShape(outline, world, 1, s_m, std::vector<double>(s_m.size() - 1, 0.0));
  const Eigen::Matrix3d R_WT = viz::frameOf(world.at(15.9e3)).linear(), R_WB = shape.bodies[0].X_WB.linear();
  EXPECT_NEAR(R_WB(2, 0), -0.009, 1e-4) << "downhill";
  EXPECT_NEAR(std::abs(R_WB(2, 1)), 0.095 / 1.5, 1e-3);
  EXPECT_TRUE(R_WB.isApprox(R_WT, 1e-3)) << "leans to the same side as the line";
  EXPECT_TRUE((R_WB.transpose() * R_WB).isIdentity(1e-12));
  EXPECT_NEAR(R_WB.determinant(), 1.0, 1e-12);
}

TEST(ColourScaleTest, CouplersAreGreyThenRedOrBlueAndFullAtTheScalesEnd) {
  const viz::Colour none = viz::couplerColour(0.0), draft = viz::couplerColour(viz::kFullCouplerForce_N),
                    buff = viz::couplerColour(-viz::kFullCouplerForce_N);
  EXPECT_DOUBLE_EQ(none.r, none.b);
  EXPECT_GT(draft.r - draft.b, 0.85);
  EXPECT_GT(buff.b - buff.r, 0.85);
  EXPECT_DOUBLE_EQ(viz::couplerColour(0.5 * viz::kFullCouplerForce_N).g, 0.5 * (none.g + draft.g));
  EXPECT_DOUBLE_EQ(viz::couplerColour(3.0 * viz::kFullCouplerForce_N).g, draft.g);
}

TEST(ColourScaleTest, ContactsAreGreenThenYellowThenRed) {
  const viz::Colour unused = viz::adhesionColour(0.0), half = viz::adhesionColour(0.5), all = viz::adhesionColour(1.0);
  EXPECT_GT(unused.g, unused.r + 0.5);
  EXPECT_GT(std::min(half.r, half.g), half.b + 0.5);
  EXPECT_GT(all.r, all.g + 0.5);
  EXPECT_DOUBLE_EQ(viz::adhesionColour(1.4).g, all.g);
  EXPECT_DOUBLE_EQ(viz::adhesionColour(0.25).r, 0.5 * (unused.r + half.r));
}

}  // namespace

#include "train_viz/contact_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_fixtures.hpp"
#include "train_viz/caption.hpp"
#include "train_viz/colour_scale.hpp"
#include "train_viz/track_shape.hpp"

namespace {

using viz::Contact;
using viz::ContactShape;

class ContactShapeTest : public fixtures::PaperLine {
 protected:
  /// The left front wheel of a locomotive at 3000 m: x is chainage, y left.
  static Contact leftFrontWheel() {
    Contact contact;
    contact.axle_m = 8.5;
    contact.y_m = 0.75;
    contact.normal_N = 110e3;
    contact.friction = 0.4;
    contact.a_m = 0.006;
    contact.b_m = 0.004;
    return contact;
  }
  ContactShape draw(const Contact& contact, double location_m = 3000.0) const {
    return viz::computeContactShape(world, 2, location_m, {contact});
  }
  static Eigen::Vector3d along(const viz::Arrow& arrow) { return arrow.to_m - arrow.from_m; }
};

TEST_F(ContactShapeTest, AWheelsLoadPointsUpFromTheRail) {
  const ContactShape shape = draw(leftFrontWheel());
  ASSERT_EQ(shape.normal_forces.size(), 1U);
  EXPECT_NEAR((shape.normal_forces[0].from_m - Eigen::Vector3d(3008.5, 0.75, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((along(shape.normal_forces[0]) - Eigen::Vector3d(0.0, 0.0, 1.1)).norm(), 0.0, 1e-9);
}

TEST_F(ContactShapeTest, IsCarriedByItsLocomotive) {
  const ContactShape shape = draw(leftFrontWheel(), 3540.0);
  EXPECT_EQ(shape.carrier.frame, "loco_2/base_link");
  EXPECT_TRUE(shape.carrier.X_WC.isApprox(viz::frameOf(world.at(3540.0)), 1e-12));
}

TEST_F(ContactShapeTest, TractionPointsForwardBrakingBackward) {
  for (const double force_N : {40e3, -40e3}) {
    Contact contact = leftFrontWheel();
    contact.longitudinal_N = force_N;
    const Eigen::Vector3d arrow = along(draw(contact).creep_forces[0]);
    EXPECT_NEAR((arrow - Eigen::Vector3d(force_N * viz::kArrow_m_per_N, 0.0, 0.0)).norm(), 0.0, 1e-9);
  }
}

/// A contact of a left wheel leans inwards: its angle is > 0 by the message's convention, its normal points to the
/// right.
TEST_F(ContactShapeTest, ForcesFollowTheContactsOwnFrame) {
  Contact contact = leftFrontWheel();
  contact.angle_rad = 0.5;
  contact.lateral_N = 20e3;
  const ContactShape shape = draw(contact);
  const Eigen::Vector3d normal(0.0, -std::sin(0.5), std::cos(0.5)), lateral(0.0, std::cos(0.5), std::sin(0.5));
  EXPECT_NEAR((along(shape.normal_forces[0]) - 1.1 * normal).norm(), 0.0, 1e-9);
  EXPECT_NEAR((along(shape.creep_forces[0]) - 0.2 * lateral).norm(), 0.0, 1e-9);
}

TEST_F(ContactShapeTest, InTheCurveForcesFollowTheTangentAtTheAxle) {
  Contact contact = leftFrontWheel();
  contact.longitudinal_N = 100e3;
  const double heading = world.at(3458.5).heading_rad;
  EXPECT_GT(heading, 0.3);
  const Eigen::Vector3d arrow = along(draw(contact, 3450.0).creep_forces[0]);
  EXPECT_NEAR(std::atan2(arrow.y(), arrow.x()), heading, 1e-9);
}

TEST_F(ContactShapeTest, TheColourTellsHowMuchOfTheFrictionIsUsed) {
  Contact contact = leftFrontWheel();
  contact.longitudinal_N = 0.3 * 110e3;
  contact.lateral_N = 0.4 * 110e3;
  contact.friction = 0.5;
  EXPECT_NEAR(contact.computeUse(), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(draw(contact).creep_forces[0].colour.g, viz::adhesionColour(1.0).g);
  contact.normal_N = 0.0;
  EXPECT_EQ(contact.computeUse(), 0.0) << "a wheel in the air";
}

TEST_F(ContactShapeTest, PatchesAreTheEllipseTenfoldAndOnlyWhereItIsKnown) {
  const ContactShape shape = draw(leftFrontWheel());
  ASSERT_EQ(shape.patches.size(), 1U);
  EXPECT_NEAR(shape.patches[0].size_m.x(), 0.12, 1e-12);
  EXPECT_NEAR(shape.patches[0].size_m.y(), 0.08, 1e-12);
  Contact unknown = leftFrontWheel();
  unknown.a_m = unknown.b_m = 0.0;
  EXPECT_TRUE(draw(unknown).patches.empty());
}

using TrackShapeTest = fixtures::PaperLine;

TEST_F(TrackShapeTest, ChordsStayWithinTheirToleranceAndStraightsTakeFewPoints) {
  const std::vector<double> s_m = viz::computeChords(outline.track, world, 0.002);
  EXPECT_EQ(s_m.front(), outline.track.start_m());
  EXPECT_EQ(s_m.back(), outline.track.end_m());
  for (std::size_t i = 0; i + 1 < s_m.size(); ++i) {
    const auto at = [&](double s) -> Eigen::Vector2d { return {world.at(s).x_m, world.at(s).y_m}; };
    const Eigen::Vector2d chord = at(s_m[i + 1]) - at(s_m[i]);
    for (const double share : {0.25, 0.5, 0.75}) {
      const Eigen::Vector2d d = at(s_m[i] + share * (s_m[i + 1] - s_m[i])) - at(s_m[i]);
      EXPECT_LT(std::abs(d.x() * chord.y() - d.y() * chord.x()) / chord.norm(), 0.0025) << s_m[i];  // places every 1 m
    }
  }
  EXPECT_LT(s_m.size(), 400U);  // 100 on 9.7 km of straight, 2.2 m a chord in R300
}

TEST_F(TrackShapeTest, RailsLieLeftAndRightOfTheLineAndPostsStandEvery100m) {
  const viz::TrackShape shape = viz::computeTrackShape(outline.track, world);
  ASSERT_EQ(shape.left_rail.size(), shape.right_rail.size());
  EXPECT_NEAR(shape.left_rail[0].y(), 0.75, 1e-9);
  EXPECT_NEAR(shape.right_rail[0].y(), -0.75, 1e-9);
  for (std::size_t i = 0; i < shape.left_rail.size(); ++i)
    EXPECT_NEAR((shape.left_rail[i] - shape.right_rail[i]).norm(), rail::kCantBaseline_m, 1e-9);
  ASSERT_EQ(shape.posts.size(), 101U + 11U);
  EXPECT_EQ(shape.posts[0].text, "0.0");
  EXPECT_EQ(shape.posts[1].text, "0 km");
  EXPECT_EQ(shape.posts[3].text, "0.2");
  EXPECT_NEAR(shape.posts[3].at_m.x(), 200.0, 1e-9);
  EXPECT_LT(shape.posts[3].at_m.y(), 0.0) << "right of the line";
}

TEST(CaptionTest, SaysSpeedPlaceTractionAndPressures) {
  viz::CaptionValues values;
  values.speed_mps = 25.0 / 3.6;
  values.location_m = 3412.3;
  values.notch = {8.0, 5.0};
  values.brake_notch = {0.0, 0.0};
  values.traction_N = {400e3, 250e3};
  EXPECT_EQ(viz::computeCaption(values, 2), "25.0 km/h at 3.412 km\nloco 2: notch 5, 250 kN of 650 kN");
  values.brake_notch[1] = 3.0;
  values.pipe_pressure_Pa = {4.5e5, 5.0e5};
  values.cylinder_pressure_Pa = {1.0e5, 0.2e5};
  EXPECT_EQ(viz::computeCaption(values, 2),
            "25.0 km/h at 3.412 km\nloco 2: notch 5, brake notch 3, 250 kN of 650 kN\n"
            "pipe 4.50 to 5.00 bar, cylinders up to 1.00 bar");
}

}  // namespace

#include "panels/one_instant.hpp"

#include <gtest/gtest.h>

namespace viz {
namespace {

void add(tf2::BufferCore& frames, const char* parent, const char* child, double time_s, double x_m) {
  geometry_msgs::TransformStamped msg;
  msg.header.frame_id = parent;
  msg.header.stamp = ros::Time(time_s);
  msg.child_frame_id = child;
  msg.transform.translation.x = x_m;
  msg.transform.rotation.w = 1.0;
  frames.setTransform(msg, "test");
}

TEST(OneInstantTest, WithoutATrainIsTheNewestOfEachFrame) {
  tf2::BufferCore frames;
  EXPECT_TRUE(newestInstant(frames).isZero());
  add(frames, "map", "loco_1/base_link", 1.0, 3000.0);
  EXPECT_TRUE(newestInstant(frames).isZero());
}

/// A message is taken in frame by frame: the picture stays at the instant before until the last one is there.
TEST(OneInstantTest, IsTheNewestThatIsThereAsAWhole) {
  tf2::BufferCore frames;
  for (const double time_s : {1.0, 1.1}) {
    add(frames, "map", "loco_1/base_link", time_s, 3000.0 + 14.0 * time_s);
    add(frames, "map", "train", time_s, 3000.0 + 14.0 * time_s);
  }
  add(frames, "map", "loco_1/base_link", 1.2, 3000.0 + 14.0 * 1.2);
  const ros::Time instant = newestInstant(frames);
  EXPECT_EQ(instant, ros::Time(1.1));
  EXPECT_NEAR(frames.lookupTransform("train", "loco_1/base_link", instant).transform.translation.x, 0.0, 1e-9);
  add(frames, "map", "train", 1.2, 3000.0 + 14.0 * 1.2);
  EXPECT_EQ(newestInstant(frames), ros::Time(1.2));
}

TEST(OneInstantTest, IsForgottenWhenTimeGoesBack) {
  tf2::BufferCore frames;
  add(frames, "map", "train", 30.0, 3500.0);
  frames.clear();
  EXPECT_TRUE(newestInstant(frames).isZero());
  add(frames, "map", "train", 1.0, 3000.0);
  EXPECT_EQ(newestInstant(frames), ros::Time(1.0));
}

}  // namespace
}  // namespace viz

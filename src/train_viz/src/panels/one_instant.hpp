#pragma once

#include <ros/time.h>
#include <rviz/display.h>
#include <tf2/buffer_core.h>

namespace viz {

/// The newest instant of which all frames of the train are there: `train` comes last in the run's message. 0 without
/// such a frame, which to tf2 means the newest of each.
ros::Time newestInstant(const tf2::BufferCore& frames);

/// rviz display train_viz/OneInstant: draws each picture with the frames of one instant. rviz asks for them one by one
/// while a thread of its own takes new ones in, so by itself it puts a picture together from two instants whenever a
/// message comes meanwhile; at four times 50 km/h one picture in five. Other frames are asked for at the same instant.
class OneInstant : public rviz::Display {
  Q_OBJECT

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private:
  void choose();
};

}  // namespace viz

#include "one_instant.hpp"

#include <rviz/frame_manager.h>
#include <rviz/visualization_manager.h>
#include <tf2/exceptions.h>
#include <tf2_ros/buffer.h>

namespace viz {

ros::Time newestInstant(const tf2::BufferCore& frames) {
  try {
    return frames.lookupTransform("map", "train", ros::Time()).header.stamp;
  } catch (const tf2::TransformException&) {
    return {};  // no train yet, or none any more: time has gone back
  }
}

void OneInstant::onInitialize() {
  if (auto* manager = dynamic_cast<rviz::VisualizationManager*>(context_))
    connect(manager, &rviz::VisualizationManager::preUpdate, this, &OneInstant::choose);
}

void OneInstant::onEnable() { context_->getFrameManager()->setSyncMode(rviz::FrameManager::SyncExact); }

void OneInstant::onDisable() { context_->getFrameManager()->setSyncMode(rviz::FrameManager::SyncOff); }

void OneInstant::choose() {
  rviz::FrameManager* frames = context_->getFrameManager();
  if (isEnabled()) frames->syncTime(newestInstant(*frames->getTF2BufferPtr()));
}

}  // namespace viz

#pragma once

#include <tf2_msgs/TFMessage.h>
#include <train_msgs/Adhesion.h>
#include <train_msgs/TrainState.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "train_viz/caption.hpp"
#include "train_viz/contact_shape.hpp"
#include "train_viz/track_shape.hpp"
#include "train_viz/train_outline.hpp"
#include "train_viz/train_shape.hpp"

/// From what is drawn to rviz's messages. Their stamp is 0: they are shown as they come. The line is in the frame
/// `map`, all else in the frames of its carriers and locked to them: rviz moves it as those frames move. rviz takes a
/// marker whole or not at all, so a box is a CUBE with pose and size (174 bytes), not its corners.
namespace viz {

visualization_msgs::MarkerArray toMsg(const TrackShape& shape);
visualization_msgs::MarkerArray toTrainMsg(const TrainShape& shape, const std::vector<Caption>& captions);
visualization_msgs::MarkerArray toCouplersMsg(const TrainShape& shape);
visualization_msgs::MarkerArray toMsg(const ContactShape& shape);

/// Another name for a frame of tf: a child that lies in it. For /tf_static, where it knows no time and so lags nothing.
tf2_msgs::TFMessage makeAlias(const std::string& frame, const std::string& alias);

/// Takes away all that this topic has shown.
visualization_msgs::MarkerArray clearingMsg();

CaptionValues fromMsg(const train_msgs::TrainState& msg);

/// The contacts of a locomotive, or one for each wheel where the model tells of axles only (2D): half the axle's force,
/// above the middle of the rail.
/// @throws std::runtime_error if the message has another number of axles than the outline
std::vector<Contact> fromMsg(const train_msgs::Adhesion& msg, const VehicleOutline& locomotive);

}  // namespace viz

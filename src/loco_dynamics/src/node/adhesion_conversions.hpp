#pragma once

#include <train_msgs/AxleAdhesion.h>
#include <train_msgs/ContactAdhesion.h>

#include <vector>

#include "loco_dynamics/adhesion_report.hpp"

namespace loco {

// What wheels tell of themselves, as LocoTraction and Adhesion carry it; the other messages: conversions.hpp.

void toMsg(const AdhesionReport& report, std::vector<train_msgs::AxleAdhesion>& axles,
           std::vector<train_msgs::ContactAdhesion>& contacts);
AdhesionReport fromMsg(const std::vector<train_msgs::AxleAdhesion>& axles,
                       const std::vector<train_msgs::ContactAdhesion>& contacts);

}  // namespace loco

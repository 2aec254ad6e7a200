#include <pluginlib/class_list_macros.hpp>

#include "lock_panel.hpp"
#include "one_instant.hpp"
#include "plot_panel.hpp"

PLUGINLIB_EXPORT_CLASS(viz::PlotPanel, rviz::Panel)
PLUGINLIB_EXPORT_CLASS(viz::LockPanel, rviz::Panel)
PLUGINLIB_EXPORT_CLASS(viz::OneInstant, rviz::Display)

#include <pluginlib/class_list_macros.hpp>

#include "lock_panel.hpp"
#include "plot_panel.hpp"

PLUGINLIB_EXPORT_CLASS(viz::PlotPanel, rviz::Panel)
PLUGINLIB_EXPORT_CLASS(viz::LockPanel, rviz::Panel)

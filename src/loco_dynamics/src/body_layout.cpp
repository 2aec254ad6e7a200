#include "loco_dynamics/body_layout.hpp"

#include <cassert>
#include <utility>

namespace loco {

BodyLayout::BodyLayout(std::vector<Body> bodies, const std::vector<Dof>& dofs)
    : bodies_(std::move(bodies)), dofs_(dofs) {
  assert(bodies_.size() == kBodies);
  for (const Body& body : bodies_) total_mass_kg_ += body.mass_kg;
}

double BodyLayout::inertia(std::size_t body, Dof dof) const {
  const Body& b = bodies_[body];
  return dof < kRoll ? b.mass_kg : b.inertia_kg_m2[static_cast<Eigen::Index>(dof - kRoll)];
}

}  // namespace loco

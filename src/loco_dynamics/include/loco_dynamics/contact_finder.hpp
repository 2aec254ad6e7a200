#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "loco_dynamics/profile/contact_region.hpp"

namespace loco {

/// Where a wheel touches its rail: real profiles (ContactSearch), or a simple shape in tests. Constant.
class ContactFinder {
 public:
  virtual ~ContactFinder() = default;
  /// @return number of regions, 0 if the wheel does not touch. Allocates nothing, throws nothing.
  virtual std::size_t find(Side side, const WheelsetPose& pose,
                           std::array<ContactRegion, kMostContacts>& regions) const = 0;
};

/// Any search with this one function as a ContactFinder.
template <typename Search>
class ContactFinderOf : public ContactFinder {
 public:
  explicit ContactFinderOf(Search search) : search_(std::move(search)) {}
  std::size_t find(Side side, const WheelsetPose& pose,
                   std::array<ContactRegion, kMostContacts>& regions) const override {
    return search_.find(side, pose, regions);
  }

 private:
  Search search_;
};

}  // namespace loco

#pragma once

#include "base/Views.hpp"

#include <memory>
#include <vector>

namespace asperity::fem
{
// The dofs of a rank whose velocity the boundary conditions prescribe. Immutable; copies share the
// data. Owned dofs come first, as in DofMap.
class HeldDofs
{
public:
  // flags(num local dofs): 1 at owned and ghost dofs that are held.
  HeldDofs(std::vector<int> flags, int num_owned);

  bool operator[](int dof) const { return data_->flags[dof] != 0; }
  std::vector<int> const& flags() const { return data_->flags; }
  std::vector<int> const& owned() const { return data_->owned; } // ascending

  // The same on the device.
  ConstFlagView flagsOnDevice() const { return data_->flags_on_device; }
  IndexView ownedOnDevice() const { return data_->owned_on_device; }

private:
  struct Data
  {
    std::vector<int> flags, owned;
    ConstFlagView flags_on_device;
    IndexView owned_on_device;
  };
  std::shared_ptr<const Data> data_;
};
} // namespace asperity::fem

#include "fem/constraints/HeldDofs.hpp"

namespace asperity::fem
{
HeldDofs::HeldDofs(std::vector<int> flags, int num_owned)
{
  auto data = std::make_shared<Data>();
  for (int dof = 0; dof < num_owned; ++dof) {
    if (flags[dof]) {
      data->owned.push_back(dof);
    }
  }
  data->flags_on_device = toDevice(flags, "asperity::fem::held");
  data->owned_on_device = toDevice(data->owned, "asperity::fem::heldRows");
  data->flags = std::move(flags);
  data_ = std::move(data);
}
} // namespace asperity::fem

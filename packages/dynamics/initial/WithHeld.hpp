#pragma once

#include "dynamics/Body.hpp"

#include <vector>

namespace asperity::dynamics
{
// The body with further owned dofs held. Collective.
Body withHeld(Body body, std::vector<int> const& dofs);
} // namespace asperity::dynamics

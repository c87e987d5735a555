#include "friction/laws/NoFriction.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::NoFriction)
ASPERITY_REGISTER_STATE_LAW(asperity::friction::NoState)

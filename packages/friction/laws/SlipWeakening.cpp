#include "friction/laws/SlipWeakening.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::SlipWeakeningLaw)
ASPERITY_REGISTER_STATE_LAW(asperity::friction::SlipWeakeningState)

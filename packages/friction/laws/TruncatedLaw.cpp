#include "friction/laws/TruncatedLaw.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::TruncatedLaw)

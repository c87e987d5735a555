#include "friction/laws/RegularisedLaw.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::RegularisedLaw)

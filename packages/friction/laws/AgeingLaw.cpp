#include "friction/laws/AgeingLaw.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_STATE_LAW(asperity::friction::AgeingLaw)

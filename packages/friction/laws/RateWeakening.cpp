#include "friction/laws/RateWeakening.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_STATE_LAW(asperity::friction::StrongRateWeakeningLaw)
ASPERITY_REGISTER_STATE_LAW(asperity::friction::FlashHeatingLaw)

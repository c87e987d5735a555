#include "friction/laws/SlipLaw.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_STATE_LAW(asperity::friction::SlipLaw)

#include "friction/laws/TabulatedLaw.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_STATE_LAW(asperity::friction::TabulatedLaw)

#include "friction/laws/CutOffLaw.hpp"

#include "friction/Registration.hpp"

ASPERITY_REGISTER_FRICTION_LAW(asperity::friction::CutOffLaw)

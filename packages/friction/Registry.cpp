#include "friction/Registry.hpp"

namespace asperity::friction
{
FrictionLawRegistry const& frictionLaws() { return FrictionLawRegistry::instance(); }

StateLawRegistry const& stateLaws() { return StateLawRegistry::instance(); }
} // namespace asperity::friction

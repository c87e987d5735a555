// A kind of fault of your own: slip on a rigid foundation.
// scenario/setup/conditions/FaultKind.hpp says how kinds differ.
#include "scenario/setup/conditions/FaultKind.hpp"

namespace
{
using namespace asperity;

struct FilmOnRock : scenario::FaultKind
{
  FilmOnRock() : FaultKind{"a film of a fluid on rigid rock.", fem::OtherSide::rigid_foundation} {}
};
} // namespace

ASPERITY_REGISTER(scenario::FaultKindRegistry, "Film on Rock", FilmOnRock)

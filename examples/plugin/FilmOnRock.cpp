// A kind of fault of your own: slip on a rigid foundation. How kinds differ is said in
// scenario/setup/conditions/FaultKind.hpp.
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

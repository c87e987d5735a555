// A law of bulk of your own: the standard linear solid, in which a share of the shear modulus
// relaxes, G(t) = G (1 - share (1 - exp(-t / time))). fem/bulk/BulkLaw.hpp says what a law has to
// have.
#include "fem/bulk/BulkLaw.hpp"

namespace
{
using namespace asperity;

struct StandardLinearSolid
{
  static constexpr char const* name = "Standard Linear Solid";

  double share; // [-]
  double time;  // [s]

  static constexpr ParameterOf<StandardLinearSolid> parameters[] = {
    {&StandardLinearSolid::share,
     {"Relaxing Share", "-", no_default, Range::closed(0, 1),
      "This share of the shear modulus relaxes."}},
    {&StandardLinearSolid::time,
     {"Relaxation Time", "s", no_default, Range::positive(),
      "Its stress falls to 1/e within this time at constant strain."}}};

  std::vector<fem::RelaxingShare> relaxation(fem::Material const&) const { return {{share, time}}; }
};
} // namespace

ASPERITY_REGISTER_BULK_LAW(StandardLinearSolid)

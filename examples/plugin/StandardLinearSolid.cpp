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
  static constexpr Parameter parameters[] = {
    {"Relaxing Share", "-", no_default, 0, 1, true, true,
     "This share of the shear modulus relaxes."},
    {"Relaxation Time", "s", no_default, 0, infinity, false, false,
     "Its stress falls to 1/e within this time at constant strain."}};

  static std::vector<fem::RelaxingShare> relaxation(double const* values, fem::Material const&)
  {
    return {{values[0], values[1]}};
  }
};
} // namespace

ASPERITY_REGISTER_BULK_LAW(StandardLinearSolid)

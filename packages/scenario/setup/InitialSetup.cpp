#include "scenario/setup/InitialSetup.hpp"

#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"

namespace asperity::scenario
{
namespace
{
Entries<InitialSettings> initialEntries()
{
  using S = InitialSettings;
  using dynamics::AlphaAtStart;
  Entries<S> entries;
  entries
    .choice("Displacement", &S::is_static, {{"Static", true}, {"Zero", false}},
            "Selects the initial displacement. Static: it balances gravity on a fault without "
            "friction. Zero: it is zero.")
    .others()
    .field(initial_entries::velocity[0], 0., "m/s", Range::any(),
           "The body starts with this velocity along x. An antiplane model has none.")
    .field(initial_entries::velocity[1], 0., "m/s", Range::any(),
           "The body starts with this velocity along y. An antiplane model has none.")
    .field(initial_entries::velocity[2], 0., "m/s", Range::any(),
           "The body starts with this velocity along z. Only antiplane models and solids have it.")
    .field(initial_entries::slip_rate, optional, "m/s", Range::any(),
           "The fault starts with this slip rate, in place of the one that follows from the "
           "velocity. It points along the tangent, in three dimensions along 'Slip Direction'. A "
           "two-sided fault needs it, since the velocity is the same on both of its sides.");
  entries
    .choice("Acceleration", &S::is_balanced, {{"Balanced", true}, {"Zero", false}},
            "Selects the initial acceleration. Balanced: it follows from the balance of momentum; "
            "a quasi-dynamic model has none. Zero: it is zero whatever the forces are.")
    .choice(initial_entries::state, &S::alpha,
            {{"Given", AlphaAtStart::given},
             {"Steady", AlphaAtStart::steady},
             {"Stress Balance", AlphaAtStart::stress_balance}},
            "Selects the initial state on the fault. Given: it is the entry 'alpha'. Steady: it is "
            "the steady state at the initial slip rate. Stress Balance: friction at the initial "
            "slip rate, together with the radiation damping of a quasi-dynamic model, bears the "
            "initial shear traction.")
    .others()
    .field(initial_entries::alpha, 0., "-", Range::any(),
           "The fault starts with this state alpha, the state variable of the friction law. Of "
           "rate-and-state friction it is ln(theta V* / L), and 0 is steady sliding at V*.");
  return entries;
}
} // namespace

RCP<const ParameterList> initialStateParameters() { return initialEntries().list(); }

InitialSettings InitialSettings::from(ParameterList const& list)
{
  return initialEntries().read(list, initial_path);
}
} // namespace asperity::scenario

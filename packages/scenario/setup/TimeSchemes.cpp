#include "scenario/setup/TimeSchemes.hpp"

#include "base/Errors.hpp"
#include "parameters/Entries.hpp"
#include "scenario/setup/DeckPaths.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
struct Newmark
{
  double beta = 0.25;
  double stability_limit = 0; // [s]; 0: not given
};

Entries<Newmark> newmarkEntries()
{
  return Entries<Newmark>()
    .real("beta", &Newmark::beta, "-", Range::closed(0, 0.5),
          "This is the weight of the new acceleration in the displacement. The scheme is "
          "unconditionally stable from 1/4 on.")
    .real("Stability Limit", &Newmark::stability_limit, "s", Range::atLeast(0),
          "No stable step is larger than this, 1 / (omega_max sqrt(1/4 - beta)). It is required "
          "for beta < 1/4, where the scheme is only conditionally stable.");
}

dynamics::RateUpdate newmark(TimeSettings const& settings, bool has_mass)
{
  ASPERITY_REQUIRE(has_mass, time_path
                               << " / Scheme = 'Newmark' needs inertia: without mass "
                                  "(Quasi-dynamic) its velocity would change its sign in every "
                                  "step. Choose 'Generalised Alpha' or 'Backward "
                                  "Euler'.");
  auto const [beta, limit] =
    newmarkEntries().read(settings.scheme_list, joinPath(time_path, "Newmark"));
  if (beta < 0.25) {
    const double largest = settings.largest_step;
    ASPERITY_REQUIRE(
      limit > 0,
      time_path << " / Newmark / beta = " << beta
                << " is only conditionally stable. Give the 'Stability Limit' of the step, or "
                   "choose beta from 0.25 to 0.5.");
    ASPERITY_REQUIRE(largest <= limit, time_path << " / Largest Step = " << largest
                                                 << " s is above the stability limit of " << limit
                                                 << " s that beta = " << beta << " needs.");
  }
  return dynamics::RateUpdate::newmark(beta);
}

dynamics::RateUpdate backwardEuler(TimeSettings const&, bool)
{
  return dynamics::RateUpdate::backwardEuler();
}

struct GeneralisedAlpha
{
  double spectral_radius = 0.5;
};

Entries<GeneralisedAlpha> generalisedAlphaEntries()
{
  return Entries<GeneralisedAlpha>().real(
    "Spectral Radius", &GeneralisedAlpha::spectral_radius, "-", Range::closed(0, 1),
    "A step multiplies modes that are far faster than itself by this factor: 0 removes "
    "them at once, 1 keeps them (Newmark). While every step doubles, they decay for values "
    "from 0.35 to 0.82; while every pair of steps doubles (Richardson), up to 0.87.");
}

dynamics::RateUpdate generalisedAlpha(TimeSettings const& settings, bool has_mass)
{
  const double radius = generalisedAlphaEntries()
                          .read(settings.scheme_list, joinPath(time_path, "Generalised Alpha"))
                          .spectral_radius;
  ASPERITY_REQUIRE(
    has_mass || radius < 1,
    time_path << " / Generalised Alpha / Spectral Radius = 1 damps nothing, and without "
                 "mass (Quasi-dynamic) the velocity would change its sign in every "
                 "step. Choose one below 1.");
  return dynamics::RateUpdate::generalisedAlpha(radius);
}
} // namespace

char const* const massless_scheme = "Generalised Alpha";

std::vector<TimeScheme> timeSchemes()
{
  return {{"Newmark", "it is of second order and needs inertia.", newmarkEntries().list(), newmark},
          {"Backward Euler", "it is of first order and damps all waves.", Declare().list(),
           backwardEuler},
          {"Generalised Alpha",
           "it is of second order and damps what is far faster than a step; a quasi-dynamic body "
           "has it where the deck names no scheme.",
           generalisedAlphaEntries().list(), generalisedAlpha}};
}

dynamics::RateUpdate makeRateUpdate(TimeSettings const& settings, bool has_mass)
{
  auto const schemes = timeSchemes();
  auto const chosen = std::find_if(schemes.begin(), schemes.end(), [&](TimeScheme const& scheme) {
    return scheme.name == settings.scheme;
  });
  ASPERITY_ASSERT(chosen != schemes.end());
  return chosen->update(settings, has_mass);
}
} // namespace asperity::scenario

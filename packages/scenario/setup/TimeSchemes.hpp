#pragma once

#include "dynamics/RateUpdate.hpp"
#include "parameters/Parameters.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::scenario
{
struct TimeSettings;

// A value of the entry `Time Stepping / Scheme`. TimeSchemes.cpp has a row for each: all that a
// deck, the list of parameters and a run know of a scheme is in its row.
struct TimeScheme
{
  std::string name;
  std::string meaning; // for the list of parameters
  RCP<const ParameterList> entries;
  // The settings choose this scheme. Without mass throws InputError where the scheme damps nothing:
  // the velocity would have the amplification factor -1.
  std::function<dynamics::RateUpdate(TimeSettings const& settings, bool has_mass)> update;
};

// All schemes, in the order of the list of parameters.
std::vector<TimeScheme> timeSchemes();

// The scheme of a body without mass whose deck names none.
extern char const* const massless_scheme;

// The update of the chosen scheme; throws what TimeScheme::update throws.
dynamics::RateUpdate makeRateUpdate(TimeSettings const& settings, bool has_mass = true);
} // namespace asperity::scenario

#pragma once

#include "dynamics/RateUpdate.hpp"
#include "parameters/Parameters.hpp"

#include <functional>
#include <string>
#include <vector>

namespace asperity::scenario
{
struct TimeSettings;

// A value of the entry `Time Stepping / Scheme`. TimeSchemes.cpp has a row for each, which is all
// that a scheme needs.
struct TimeScheme
{
  std::string name;
  std::string meaning; // for the list of parameters
  RCP<const ParameterList> entries;
  // Makes the rate update; the settings choose this scheme. Throws InputError for a body without
  // mass if the scheme is not dissipative: its velocity would have the amplification factor -1.
  std::function<dynamics::RateUpdate(TimeSettings const& settings, bool has_mass)> update;
};

// All schemes, in the order of the list of parameters.
std::vector<TimeScheme> timeSchemes();

// The scheme of a body without mass whose deck names none.
extern char const* const massless_scheme;

// The update of the chosen scheme; throws what TimeScheme::update throws.
dynamics::RateUpdate makeRateUpdate(TimeSettings const& settings, bool has_mass = true);
} // namespace asperity::scenario

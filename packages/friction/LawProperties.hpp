#pragma once

#include "friction/Parameter.hpp"

#include <functional>
#include <vector>

// What a law declares about itself in addition to its kernels. Its functions take the law's
// parameters at one node in the order of its table, on the host: each calls the member function of
// the law whose name it has, as slipDistance(). A function that the law does not have is empty.
namespace asperity::friction
{
// The meaning of alpha. A friction law can be used with a state law of the same alpha.
inline constexpr char const* logarithm_of_theta = "ln(theta V* / L)";
inline constexpr char const* no_state = "none";

// The derivatives of mu by ln V and by alpha at large slip rates, both dimensionless: a and b of
// mu = mu* + a ln(V / V*) + b alpha.
struct Sensitivity
{
  double slip_rate; // a
  double state;     // b
};

struct FrictionLawProperties
{
  std::vector<Parameter> parameters;
  std::function<Sensitivity(double const* values)> sensitivity;
  // mu* [-] of the state psi = mu* + b alpha that friction depends on.
  std::function<double(double const* values)> reference_friction = {};
  // mu_s - mu_d [-], the fall of friction with slip under a law that does not depend on V.
  std::function<double(double const* values)> strength_drop = {};
  char const* state_variable = logarithm_of_theta;
};

struct StateLawProperties
{
  std::vector<Parameter> parameters;
  // L [m], over which the state forgets the previous slip rate.
  std::function<double(double const* values)> slip_distance;
  // theta / exp(alpha) [s]: L / V* where theta is the classical state variable.
  std::function<double(double const* values)> theta_scale;
  // c [-] of Linker and Dieterich's term, d(alpha) = -(c / b) d(ln sigma_n), which is added to the
  // law's own evolution; b is the friction law's.
  std::function<double(double const* values)> stress_sensitivity = {};
  // Whether steady friction falls more at high slip rates than a and b say.
  bool weakens_at_high_rates = false;
  // Whether it takes steady friction from a table over log10(V s/m).
  bool has_table = false;
  char const* state_variable = logarithm_of_theta;
  // For messages: the assumptions and the source of the formula for the nucleation length, which is
  // that of Uenishi and Rice (2003) for friction laws with a strength drop and that of Rubin and
  // Ampuero (2005) for others. Null if neither formula holds for the law.
  char const* nucleation_source = nullptr;
};
} // namespace asperity::friction

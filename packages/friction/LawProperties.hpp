#pragma once

#include "friction/Parameter.hpp"

#include <functional>
#include <vector>

// What a law declares about itself in addition to its kernels. Its functions take the law's
// parameters at one node in the order of its table, on the host: each calls the member function of
// the law whose name it has, as slipDistance(). A function that the law does not have is empty.
namespace asperity::friction
{
// What alpha is. A friction law and a state law go together if they have the same alpha.
inline constexpr char const* logarithm_of_theta = "ln(theta V* / L)";
inline constexpr char const* no_state = "none";

// How mu changes at large slip rates: its derivatives by log V and by alpha, both
// dimensionless. These are a and b of mu = mu* + a log(V / V*) + b alpha.
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
  // mu_s - mu_d [-], by which friction falls with slip under a law that does not depend on V.
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
  // Whether it takes steady friction from a table, of log10 V [m/s].
  bool has_table = false;
  char const* state_variable = logarithm_of_theta;
  // For laws whose nucleation length follows from a formula, that of Uenishi and Rice for friction
  // laws with a strength drop, that of Rubin and Ampuero for others: what it holds for and where it
  // is from, for messages. Null for laws of which only the linear stability of slip is known.
  char const* nucleation_source = nullptr;
};
} // namespace asperity::friction

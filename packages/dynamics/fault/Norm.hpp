#pragma once

#include "parameters/Parameters.hpp"

#include <string>

namespace asperity::dynamics
{
// How the difference of two fields is measured over the fault.
enum class Norm
{
  root_mean_square,
  maximum
};

// The parameter `Norm` of a list with its default; `meaning` says what it measures.
Declare& declareNorm(Declare& list, Norm usual, std::string const& meaning);
Norm normOf(ParameterList const& parameters);
} // namespace asperity::dynamics

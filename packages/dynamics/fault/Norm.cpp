#include "dynamics/fault/Norm.hpp"

namespace asperity::dynamics
{
namespace
{
constexpr char const* maximum_norm = "Maximum";
} // namespace

Declare& declareNorm(Declare& list, std::string const& meaning)
{
  return list.choice("Norm", "Root Mean Square", {"Root Mean Square", maximum_norm}, meaning);
}

Norm normOf(ParameterList const& parameters)
{
  return parameters.get<std::string>("Norm") == maximum_norm ? Norm::maximum
                                                             : Norm::root_mean_square;
}
} // namespace asperity::dynamics

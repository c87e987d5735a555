#include "dynamics/fault/Norm.hpp"

namespace asperity::dynamics
{
namespace
{
constexpr char const* maximum_norm = "Maximum";
constexpr char const* root_mean_square_norm = "Root Mean Square";
} // namespace

Declare& declareNorm(Declare& list, Norm usual, std::string const& meaning)
{
  return list.choice("Norm", usual == Norm::maximum ? maximum_norm : root_mean_square_norm,
                     {root_mean_square_norm, maximum_norm}, meaning);
}

Norm normOf(ParameterList const& parameters)
{
  return parameters.get<std::string>("Norm") == maximum_norm ? Norm::maximum
                                                             : Norm::root_mean_square;
}
} // namespace asperity::dynamics

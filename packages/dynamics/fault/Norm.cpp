#include "dynamics/fault/Norm.hpp"

namespace asperity::dynamics
{
std::vector<std::pair<std::string, Norm>> normWords()
{
  return {{"Root Mean Square", Norm::root_mean_square}, {"Maximum", Norm::maximum}};
}
} // namespace asperity::dynamics

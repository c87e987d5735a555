#include "stretch/StepKinds.hpp"

#include "base/parallel/Reductions.hpp"
#include "scenario/setup/BulkSetup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace asperity;

namespace
{
// The longest side of the box around the mesh [m].
double longestSide(Mesh<3> const& mesh, Communicator const& communicator)
{
  double longest = 0;
  for (int d = 0; d < 3; ++d) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (auto const& x : mesh.vertices) {
      low = std::min(low, x[d]);
      high = std::max(high, x[d]);
    }
    longest =
      std::max(longest, maxOverRanks(high, communicator) + maxOverRanks(-low, communicator));
  }
  return longest;
}

} // namespace

double crossingTime(ParameterList const& deck, scenario::Problem<3> const& problem)
{
  if (problem.body.matrices.is_massless || scenario::quasiDynamic(deck.sublist("Bulk"))) {
    return 0;
  }
  double slowness = 0; // of the slowest shear wave [s/m]
  for (auto const& m : scenario::makeMaterials<3>(deck.sublist("Bulk"), problem.mesh)) {
    slowness = std::max(slowness, std::sqrt(m.density / m.shear_modulus));
  }
  return longestSide(problem.mesh, *problem.communicator) *
         maxOverRanks(slowness, *problem.communicator);
}

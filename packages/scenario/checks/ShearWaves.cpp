#include "scenario/checks/ShearWaves.hpp"

#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"

#include <algorithm>
#include <limits>

namespace asperity::scenario
{
template <int Dim>
ShearWaves shearWavesOf(Problem<Dim> const& problem)
{
  auto const diameters = mesh::cellDiameters(problem.mesh());
  ShearWaves mine{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t cell = 0; cell < diameters.size(); ++cell) {
    auto const& rock = problem.discretisation.rock.materials[cell];
    const double impedance = rock.shearImpedance();
    mine.through_cell = std::min(mine.through_cell, diameters[cell] * rock.density / impedance);
    mine.slowness = std::max(mine.slowness, rock.density / impedance);
  }
  auto const& communicator = *problem.communicator;
  return {minOverRanks(mine.through_cell, communicator), maxOverRanks(mine.slowness, communicator)};
}

template ShearWaves shearWavesOf(Problem<2> const&);
template ShearWaves shearWavesOf(Problem<3> const&);
} // namespace asperity::scenario

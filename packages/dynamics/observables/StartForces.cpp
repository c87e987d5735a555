#include "dynamics/observables/StartForces.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/observables/DofSums.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::dynamics
{
namespace
{
struct Square
{
  DofValues x;
  KOKKOS_INLINE_FUNCTION double operator()(int dof) const { return x(dof, 0) * x(dof, 0); }
};
} // namespace

RCP<Vector> residualAtStart(Body const& body, StartForces const& forces)
{
  const auto r0 = body.vector();
  r0->update(1, forces.load, 0);
  forces.resisting.subtractFrom(*r0);
  r0->update(-1, forces.force, 1);
  body.clearHeld(*r0);
  return r0;
}

double startImbalance(Body const& body, IndexView const& fault_dofs, StartForces const& forces,
                      Vector const& r0)
{
  const Square of_r0{reading(r0)};
  const auto [everywhere, on_fault, of_friction] = sumOverRanks(
    std::array<double, 3>{sumOfAll(body.numOwnedDofs(), of_r0), sumAt(fault_dofs, of_r0),
                          sumAt(fault_dofs, Square{reading(forces.force)})},
    *body.dofs->communicator());
  const auto ratio = [](double part, double whole) { return part > 0 ? part / whole : 0; };
  const double whole = std::max(
    {forces.load.norm2(), forces.resisting.elastic->norm2(), forces.resisting.viscous->norm2()});
  return std::max(std::sqrt(ratio(on_fault, std::max(on_fault, of_friction))),
                  std::sqrt(ratio(std::max(everywhere - on_fault, 0.), whole * whole)));
}

double startContradiction(Body const& body, fem::FaultSurface const& surface,
                          StartForces const& forces)
{
  auto const driving = body.vector();
  driving->update(1, forces.load, 0);
  forces.resisting.subtractFrom(*driving);
  driving->update(1, *forces.resisting.inertial, 1);

  constexpr double least_part = 0.01;
  auto const drives = driving->getData(0), resists = forces.force.getData(0);
  std::array<double, 2> area{}; // where friction acts with what drives the fault, and all of it
  for (int i = 0; i < surface.numNodes(); ++i) {
    if (!surface.slides(i)) {
      continue;
    }
    double product = 0, square = 0;
    for (int k = 0; k < surface.numTangents(); ++k) {
      const int dof = surface[i].dofs[k];
      if (!surface.held(i, k)) {
        product += drives[dof] * resists[dof];
        square += resists[dof] * resists[dof];
      }
    }
    area[0] += product < -least_part * square ? surface[i].weight : 0;
    area[1] += surface[i].weight;
  }
  area = sumOverRanks(area, *body.dofs->communicator());
  return area[0] > 0 ? area[0] / area[1] : 0;
}
} // namespace asperity::dynamics

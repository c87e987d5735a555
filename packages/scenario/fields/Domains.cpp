#include "scenario/fields/Domains.hpp"

#include "base/parallel/Reductions.hpp"

namespace asperity::scenario
{
namespace
{
template <int Dim>
io::OutputDomain faultDomain(Problem<Dim> const& problem)
{
  auto fault =
    io::boundaryDomain("fault", problem.mesh(), problem.surface().name(), problem.communicator);
  io::nameParts(fault, problem.mesh(), problem.discretisation.boundary.faults);
  double rise = 0; // of the normals, out of the plus side
  for (auto const& node : problem.surface()) {
    rise += node.weight * node.normal[1];
  }
  const double rounding = 1e-6 * problem.surface().totalWeight(); // of a vertical fault
  fault.is_foot_wall = Dim == 2 && sumOverRanks(rise, *problem.communicator) > rounding;
  return fault;
}
} // namespace

template <int Dim>
Domains makeDomains(Problem<Dim> const& problem)
{
  Domains domains;
  if (problem.surface().numGlobalNodes() > 0) {
    domains.emplace("fault", faultDomain(problem));
  }
  domains.emplace("volume", io::volumeDomain(problem.mesh(), problem.communicator));
  if (!problem.discretisation.boundary.surface.empty()) {
    domains.emplace("surface", io::boundaryDomain("surface", problem.mesh(),
                                                  problem.discretisation.boundary.surface,
                                                  problem.communicator, io::CurveStart::smaller_x));
  }
  return domains;
}

template Domains makeDomains(Problem<2> const&);
template Domains makeDomains(Problem<3> const&);
} // namespace asperity::scenario

#include "scenario/run/Condensation.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
// Whether all prescribed velocities are constant in time, except for slip on the fault.
template <int Dim>
bool boundariesMoveSteadily(Problem<Dim> const& problem)
{
  std::vector<int> slipping;
  for (auto const& node : problem.surface()) {
    slipping.insert(slipping.end(), node.dofs.begin(), node.dofs.end());
  }
  auto const varying = problem.discretisation.constraints->dofsThatVary();
  return std::all_of(varying.begin(), varying.end(), [&](int dof) {
    return std::find(slipping.begin(), slipping.end(), dof) != slipping.end();
  });
}
} // namespace

template <int Dim>
std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<Dim> const& problem)
{
  const bool is_wanted = problem.settings.solver.may_condense &&
                         problem.solver.correction == dynamics::Correction::direct;
  if (!is_wanted || problem.surface().numGlobalNodes() == 0 || problem.surface().mayOpen() ||
      !problem.discretisation.boundary.tractions.empty() ||
      !problem.discretisation.boundary.resistances.empty() || problem.model.body.cells ||
      problem.settings.bulk.hasGravity() || !boundariesMoveSteadily(problem)) {
    return nullptr;
  }
  return dynamics::StaticCondensation::make(problem.model);
}

template std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<2> const&);
template std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<3> const&);
} // namespace asperity::scenario

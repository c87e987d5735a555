#include "scenario/Condensation.hpp"

#include "scenario/setup/BulkSetup.hpp"

#include <algorithm>

namespace asperity::scenario
{
namespace
{
// Whether all that is prescribed off the fault is constant in time.
template <int Dim>
bool boundariesMoveSteadily(Problem<Dim> const& problem)
{
  auto const at_fault = problem.surface->vertices();
  auto const varying = problem.constraints->dofsThatVary();
  return std::all_of(varying.begin(), varying.end(), [&](int dof) {
    return std::find(at_fault.begin(), at_fault.end(), dof / problem.components) != at_fault.end();
  });
}

template <int Dim>
bool hasGravity(ParameterList const& bulk)
{
  auto const g = gravity<Dim>(bulk);
  return std::any_of(g.begin(), g.end(), [](double component) { return component != 0; });
}
} // namespace

template <int Dim>
std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<Dim> const& problem,
                                                               ParameterList const& deck)
{
  const bool is_wanted = deck.sublist("TNNMG").get<std::string>("Static Condensation") == "Auto" &&
                         problem.solver.correction == dynamics::Correction::direct;
  if (!is_wanted || hasGravity<Dim>(deck.sublist("Bulk")) || !boundariesMoveSteadily(problem)) {
    return nullptr;
  }
  return dynamics::StaticCondensation::make(problem);
}

template std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<2> const&,
                                                                        ParameterList const&);
template std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<3> const&,
                                                                        ParameterList const&);
} // namespace asperity::scenario

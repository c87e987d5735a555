#include "scenario/fields/OutputFields.hpp"

#include "scenario/fields/BodyFields.hpp"
#include "scenario/fields/FaultFields.hpp"
#include "scenario/fields/LockedFields.hpp"
#include "scenario/fields/RunScalars.hpp"

namespace asperity::scenario
{
template <int Dim>
void registerFields(io::FieldRegistry& registry, Problem<Dim> const& problem, RunView const& view,
                    Domains const& domains, std::map<std::string, fem::CoulombPlane> const& planes)
{
  if (domains.count("fault") > 0) {
    registerFaultFields(registry, problem, view);
  }
  for (auto const& [name, domain] : domains) {
    registerMotion(registry, problem, view, domain);
  }
  registerScalars(registry, view, Dim, problem.model.body.cells != nullptr,
                  problem.surface().mayOpen());
  registerLockedResponse(registry, problem, view, domains);
  registerStress(registry, problem, view, domains, planes);
}

template void registerFields(io::FieldRegistry&, Problem<2> const&, RunView const&, Domains const&,
                             std::map<std::string, fem::CoulombPlane> const&);
template void registerFields(io::FieldRegistry&, Problem<3> const&, RunView const&, Domains const&,
                             std::map<std::string, fem::CoulombPlane> const&);
} // namespace asperity::scenario

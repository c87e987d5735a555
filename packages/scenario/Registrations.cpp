#include "scenario/Registrations.hpp"

#include "dynamics/FaultProcess.hpp"
#include "dynamics/control/StepControlKind.hpp"
#include "dynamics/watches/Watch.hpp"
#include "fem/bulk/BulkLaw.hpp"
#include "friction/Registry.hpp"
#include "io/Output.hpp"
#include "multigrid/Smoother.hpp"
#include "scenario/setup/conditions/BoundaryKind.hpp"
#include "scenario/setup/conditions/FaultKind.hpp"

namespace asperity::scenario
{
std::vector<std::string> registrations()
{
  std::vector<std::string> all;
  for (auto const& some :
       {friction::frictionLaws().registrations(), friction::stateLaws().registrations(),
        fem::bulkLaws().registrations(), dynamics::StepControlRegistry::instance().registrations(),
        dynamics::FaultProcessRegistry::instance().registrations(),
        dynamics::WatchRegistry::instance().registrations(),
        multigrid::SmootherRegistry::instance().registrations(),
        io::OutputRegistry::instance().registrations(),
        BoundaryKindRegistry::instance().registrations(),
        FaultKindRegistry::instance().registrations()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}
} // namespace asperity::scenario

#include "stretch/Stretch.hpp"

#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"
#include "stretch/StepKinds.hpp"

using namespace asperity;

Stretch::Stretch(ParameterList const& deck, RCP<const Communicator> const& communicator)
    : problem_(scenario::makeProblem<3>(deck, communicator))
    , update_(scenario::makeRateUpdate(deck.sublist("Time Stepping"),
                                       !scenario::quasiDynamic(deck.sublist("Bulk"))))
    , step_(problem_.body, problem_.fault, update_,
            scenario::makeClock(deck.sublist("Time Stepping")),
            dynamics::CouplingSettings::from(deck.sublist("Coupling")), problem_.solver,
            scenario::memoryBudget(deck.sublist("TNNMG")), problem_.reaction)
    , control_(scenario::makeStepControl(deck.sublist("Time Stepping"), {}, step_))
    , state_(problem_.initial.clone())
    , crossing_time_(crossingTime(deck, problem_))
{
}

long long Stretch::numUnknowns() const
{
  return static_cast<long long>(problem_.mesh.num_global_vertices) * problem_.components;
}

int Stretch::advance() { return control_->advance(state_, count_).level; }

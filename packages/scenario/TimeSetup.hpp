#pragma once

#include "base/Parameters.hpp"
#include "dynamics/StepControl.hpp"

namespace asperity::scenario
{
// The deck's list `Time Stepping`.
RCP<const ParameterList> timeParameters();

double finalTime(ParameterList const& list);
dynamics::DyadicTime makeClock(ParameterList const& list);
dynamics::RateUpdate makeRateUpdate(ParameterList const& list);
std::unique_ptr<dynamics::StepControl> makeStepControl(ParameterList const& list,
                                                       dynamics::CoupledStep& step,
                                                       dynamics::Fault const& fault,
                                                       dynamics::DyadicTime const& clock);
} // namespace asperity::scenario

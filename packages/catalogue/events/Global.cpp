#include "catalogue/events/Global.hpp"

#include "base/parallel/Reductions.hpp"
#include "catalogue/events/FaultRates.hpp"
#include "parameters/Parameters.hpp"

#include <cmath>

namespace asperity::catalogue
{
namespace
{
std::string columns(bool on_curve)
{
  return std::string("time [s],peak_slip_rate [m/s],") +
         (on_curve ? "moment_rate_per_length [N/s],moment_per_length [N]"
                   : "moment_rate [N m/s],moment [N m]");
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> Global::validParameters()
{
  Declare parameters;
  parameters.boolean("Enabled", true, "If true, the run writes this output.");
  io::WriteRule::declare(parameters, 1, 0);
  return parameters.list();
}

std::string Global::meaning()
{
  return "Writes peak slip rate, moment rate and moment of the fault over time to global.csv.";
}

Global::Global(Teuchos::ParameterList const& parameters, io::OutputContext const& context)
    : fault_(context.domain("fault"))
    , slip_rate_(context.fields.field("fault", "slip_rate"))
    , slip_(context.fields.field("fault", "slip"))
    , rule_(parameters)
    , file_(context.directory / "global.csv", columns(fault_.isCurve()), context.comm)
{
  context.fields.field("fault", "shear_modulus").values(rigidity_);
  const auto free = countedNodes(context);
  for (std::size_t i = 0; i < rigidity_.size(); ++i) {
    rigidity_[i] *= fault_.weights[i] * free[i];
  }
}

void Global::write(io::StepInfo const& step)
{
  if (!rule_.isDue(step)) {
    return;
  }
  std::vector<double> rates, slip;
  slip_rate_.values(rates);
  slip_.values(slip);
  std::string row = io::exactNumber(step.time);
  for (const double value :
       {step.peak_slip_rate, moment(rates, 1), moment(slip, slip_.components)}) {
    row += ',' + io::exactNumber(value);
  }
  file_.writeRow(row);
}

// The integral over the fault of the shear modulus times the magnitude of the values.
double Global::moment(std::vector<double> const& values, int components) const
{
  double mine = 0;
  for (std::size_t i = 0; i < rigidity_.size(); ++i) {
    double magnitude = 0;
    for (int c = 0; c < components; ++c) {
      magnitude = std::hypot(magnitude, values[i * components + c]);
    }
    mine += rigidity_[i] * magnitude;
  }
  return sumOverRanks(mine, *fault_.comm);
}

void Global::save(Archive& archive) const
{
  archive.insert("rule", rule_);
  archive.insert("file", file_);
}

void Global::restore(Archive const& archive)
{
  rule_.restore(archive.child("rule"));
  file_.restore(archive.child("file"));
}

ASPERITY_REGISTER(io::OutputRegistry, "Global", io::OutputKindOf<Global>)
} // namespace asperity::catalogue

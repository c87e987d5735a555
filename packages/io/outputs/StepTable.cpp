#include "io/Output.hpp"
#include "io/files/TextTable.hpp"
#include "parameters/Parameters.hpp"

#include <Teuchos_Array.hpp>

namespace asperity::io
{
namespace
{
// DIR/steps.csv: one row for every accepted step, with the registry's scalars.
class StepTable : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Declare()
      .boolean("Enabled", true, "If true, the run writes this output.")
      .textArray("Quantities", std::vector<std::string>{},
                 "The quantities of these names are written in columns after the step, its time, "
                 "size, peak slip rate and wall time. If none is named, all are written.")
      .list();
  }

  static std::string meaning() { return "Writes to steps.csv what every accepted step cost."; }

  static std::vector<std::string> files() { return {"steps.csv"}; }

  StepTable(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : scalars_(chosenScalars(parameters, context.fields))
      , file_(context.directory / "steps.csv", header(scalars_), context.comm)
  {
  }

  void write(StepInfo const& step) override
  {
    if (step.step == 0) {
      return; // the initial state
    }
    std::string row = std::to_string(step.step) + ',' + exactNumber(step.time) + ',' +
                      exactNumber(step.step_size) + ',' + shortNumber(step.peak_slip_rate) + ',' +
                      shortNumber(step.wall_time);
    for (OutputScalar const* scalar : scalars_) {
      row += ',' + shortNumber(scalar->value());
    }
    file_.writeRow(row);
  }

  void closeSegment(int) override { file_.flush(); }
  void finish() override { file_.flush(); }
  void save(Archive& archive) const override { file_.save(archive); }
  void restore(Archive const& archive) override { file_.restore(archive); }

private:
  using Scalars = std::vector<OutputScalar const*>;

  static Scalars chosenScalars(Teuchos::ParameterList const& parameters,
                               FieldRegistry const& registry)
  {
    auto names = parameters.get<Teuchos::Array<std::string>>("Quantities").toVector();
    if (names.empty()) {
      names = registry.scalarNames();
    }
    Scalars scalars;
    for (auto const& name : names) {
      scalars.push_back(&registry.scalar(name));
    }
    return scalars;
  }

  static std::string header(Scalars const& scalars)
  {
    std::string text = "step,time [s],step_size [s],peak_slip_rate [m/s],wall_time [s]";
    for (OutputScalar const* scalar : scalars) {
      text += ',' + columnName(scalar->name, scalar->unit);
    }
    return text;
  }

  Scalars scalars_;
  TextTable file_;
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Step Table", OutputKindOf<StepTable>)
} // namespace asperity::io

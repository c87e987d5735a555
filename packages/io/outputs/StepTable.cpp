#include "io/Output.hpp"
#include "io/files/TextTable.hpp"
#include "parameters/Entries.hpp"

#include <string>
#include <vector>

namespace asperity::io
{
namespace
{
// DIR/steps.csv: one row for every accepted step, with the registry's scalars.
class StepTable : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters() { return entries().list(); }

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

  struct Settings
  {
    bool is_enabled = true;
    std::vector<std::string> quantities;
  };
  static Entries<Settings> entries()
  {
    return Entries<Settings>()
      .boolean("Enabled", &Settings::is_enabled, "If true, the run writes this output.")
      .textArray("Quantities", &Settings::quantities,
                 "The quantities of these names are written in columns after the step, its time, "
                 "size, peak slip rate and wall time. If none is named, all are written.");
  }

  static Scalars chosenScalars(Teuchos::ParameterList const& parameters,
                               FieldRegistry const& registry)
  {
    auto names = entries().read(parameters, parameters.name()).quantities;
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

// An output of your own: DIR/mean_slip.csv, the mean slip of the fault. io/Output.hpp
// says what an output has to have.
#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/files/TextTable.hpp"
#include "parameters/Parameters.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <array>
#include <cmath>

namespace
{
using namespace asperity;
using namespace asperity::io;

class MeanSlip : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    Declare parameters;
    parameters.boolean("Enabled", true, "Whether to write this output.");
    WriteRule::declare(parameters, 1, 0);
    return parameters.list();
  }
  static std::string meaning() { return "Slip averaged over the fault: mean_slip.csv."; }
  static std::string neededDomain() { return "fault"; } // left out of models without one

  MeanSlip(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : fault_(context.domain("fault"))
      , slip_(context.fields.field("fault", "slip"))
      , rule_(parameters)
      , file_(context.directory / "mean_slip.csv", "time [s],mean_slip [m]", context.comm)
  {
  }

  void write(StepInfo const& step) override
  {
    if (rule_.isDue(step)) {
      file_.writeRow(exactNumber(step.time) + ',' + exactNumber(meanSlip()));
    }
  }
  void closeSegment(int) override { file_.flush(); }
  void finish() override {}

  void save(Archive& archive) const override
  {
    Archive rule, file;
    rule_.save(rule);
    file_.save(file);
    archive.insert("rule", rule);
    archive.insert("file", file);
  }
  void restore(Archive const& archive) override
  {
    rule_.restore(archive.child("rule"));
    file_.restore(archive.child("file"));
  }

private:
  double meanSlip() const
  {
    std::vector<double> slip;
    slip_.values(slip);
    std::array<double, 2> mine{0, 0}, all{0, 0};
    for (std::size_t node = 0; node < fault_.numOwned(); ++node) {
      double magnitude = 0;
      for (int c = 0; c < slip_.components; ++c) {
        magnitude = std::hypot(magnitude, slip[node * slip_.components + c]);
      }
      mine[0] += fault_.weights[node] * magnitude;
      mine[1] += fault_.weights[node];
    }
    Teuchos::reduceAll(*fault_.comm, Teuchos::REDUCE_SUM, 2, mine.data(), all.data());
    return all[0] / all[1];
  }

  OutputDomain const& fault_;
  OutputField const& slip_;
  WriteRule rule_;
  TextTable file_;
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Mean Slip", OutputKindOf<MeanSlip>)

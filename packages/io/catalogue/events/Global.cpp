#include "base/parameters/Parameters.hpp"
#include "io/Output.hpp"
#include "io/WriteRule.hpp"
#include "io/catalogue/events/FaultRates.hpp"
#include "io/files/TextTable.hpp"
#include "io/parallel/Gather.hpp"
#include "io/platforms/PlatformFile.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace asperity::io
{
namespace
{
// DIR/global.csv: the fault as a whole over time, without the nodes whose slip rate is prescribed;
// for SEAS also DIR/seas/global.dat. Needs `slip_rate`, `slip` and `shear_modulus` on the fault.
class Global : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    Declare parameters;
    parameters.boolean("Enabled", true, "If true, the run writes this output.");
    WriteRule::declare(parameters, 1, 0);
    return parameters.list();
  }

  static std::string meaning()
  {
    return "Writes peak slip rate, moment rate and moment of the fault over time to global.csv.";
  }

  Global(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : fault_(context.location("fault"))
      , rates_(fault_, context.fields)
      , slip_(context.fields.field("fault", "slip"))
      , rule_(parameters)
      , file_(context.directory / "global.csv", columns(fault_.isCurve()), context.comm)
  {
    context.fields.field("fault", "shear_modulus").values(rigidity_);
    for (std::size_t i = 0; i < rigidity_.size(); ++i) {
      rigidity_[i] *= fault_.weights[i] * rates_.free()[i];
    }
    if (context.text.platform == Platform::seas) {
      text_.emplace(context.text, context.directory, seasContent(fault_.isCurve()), context.comm);
    }
  }

  void write(StepInfo const& step) override
  {
    steps_.add(step);
    if (!rule_.isDue(step)) {
      return;
    }
    const auto now = rates_.sample();
    const double rate = moment(now.rates, 1);
    std::vector<double> slip;
    slip_.values(slip);
    file_.writeRow(exactNumber(step.time) + ',' + shortNumber(now.peak) + ',' + shortNumber(rate) +
                   ',' + shortNumber(moment(slip, slip_.components)));
    if (text_) {
      const std::array<double, 2> values{detail::platformLogarithm(now.peak), rate};
      text_->writeRow(step.time, values.data(), values.size());
    }
  }

  void closeSegment(int) override
  {
    file_.flush();
    if (text_) {
      text_->flush(steps_);
    }
  }

  void finish() override {}

  void save(Archive& archive) const override
  {
    Archive rule, steps, file, text;
    rule_.save(rule);
    steps_.save(steps);
    file_.save(file);
    archive.insert("rule", rule);
    archive.insert("steps", steps);
    archive.insert("file", file);
    if (text_) {
      text_->save(text);
      archive.insert("text", text);
    }
  }

  void restore(Archive const& archive) override
  {
    rule_.restore(archive.child("rule"));
    steps_.restore(archive.child("steps"));
    file_.restore(archive.child("file"));
    if (text_) {
      text_->restore(archive.child("text"));
    }
  }

private:
  static std::string columns(bool on_curve)
  {
    return std::string("time [s],peak_slip_rate [m/s],") +
           (on_curve ? "moment_rate_per_length [N/s],moment_per_length [N]"
                     : "moment_rate [N m/s],moment [N m]");
  }

  static detail::PlatformContent seasContent(bool on_curve)
  {
    detail::PlatformContent content;
    content.name = "global.dat";
    content.remarks =
      detail::columnRemarks({"Time (s)", "Max slip rate (log10 m/s)",
                             on_curve ? "Moment rate per length (N/s)" : "Moment rate (N m/s)"});
    content.fields = "t max_slip_rate moment_rate";
    return content;
  }

  // The integral over the fault of the shear modulus times the magnitude of the values.
  double moment(std::vector<double> const& values, int components) const
  {
    double mine = 0;
    for (std::size_t i = 0; i < rigidity_.size(); ++i) {
      double magnitude = 0;
      for (int c = 0; c < components; ++c) {
        magnitude = std::hypot(magnitude, values[i * components + c]);
      }
      mine += rigidity_[i] * magnitude;
    }
    return detail::sumOverRanks(mine, *fault_.comm);
  }

  Location const& fault_;
  detail::FaultRates rates_;
  Field const& slip_;
  std::vector<double> rigidity_; // (num_owned) [N/m] or [N] modulus times weight; 0: not counted
  WriteRule rule_;
  detail::StepFacts steps_;
  TextTable file_;
  std::optional<detail::PlatformSeries> text_;
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Global", OutputKindOf<Global>)
} // namespace asperity::io

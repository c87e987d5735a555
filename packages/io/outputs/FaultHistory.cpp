#include "io/outputs/FieldHistory.hpp"
#include "io/platforms/SlipProfiles.hpp"

#include <optional>

namespace asperity::io
{
namespace
{
// For SEAS also slip profiles in text, with the same rows, where the fault is a curve.
class FaultHistory : public FieldHistory
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    Defaults defaults;
    defaults.fields = {"slip_rate", "alpha", "slip", "traction"};
    defaults.every_n_steps = 10;
    defaults.rate_change_factor = 1.5;
    return parametersWith(defaults);
  }

  static std::string meaning()
  {
    return "Writes fields on the fault over time to fault.h5 and fault.xdmf.";
  }

  FaultHistory(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : FieldHistory("fault", parameters, context)
  {
    if (context.text.platform == Platform::seas && context.location("fault").isCurve()) {
      profiles_.emplace(context);
    }
  }

  void write(StepInfo const& step) override
  {
    steps_.add(step);
    FieldHistory::write(step);
  }

  void closeSegment(int index) override
  {
    FieldHistory::closeSegment(index);
    if (profiles_) {
      profiles_->flush(steps_);
    }
  }

  void save(Archive& archive) const override
  {
    FieldHistory::save(archive);
    if (profiles_) {
      Archive steps, profiles;
      steps_.save(steps);
      profiles_->save(profiles);
      archive.insert("steps", steps);
      archive.insert("profiles", profiles);
    }
  }

  void restore(Archive const& archive) override
  {
    FieldHistory::restore(archive);
    if (profiles_) {
      steps_.restore(archive.child("steps"));
      profiles_->restore(archive.child("profiles"));
    }
  }

protected:
  void rowWritten(StepInfo const& step) override
  {
    if (profiles_) {
      profiles_->write(step);
    }
  }

private:
  detail::StepFacts steps_;
  std::optional<detail::SlipProfiles> profiles_;
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Fault History", OutputKindOf<FaultHistory>)
} // namespace asperity::io

// A step control of your own: it begins with the smallest step, and doubles the size after every n
// steps until it is the largest. dynamics/control/StepControlKind.hpp says what a control has to
// have.
#include "dynamics/control/StepControlKind.hpp"
#include "parameters/Parameters.hpp"

#include <algorithm>

namespace
{
using namespace asperity;
using namespace asperity::dynamics;

class GrowingSteps : public StepControl
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Declare()
      .integer("Steps of a Size", 10, Range::atLeast(1), "Steps before the size is doubled.")
      .list();
  }
  static std::string meaning() { return "steps begin with the smallest and grow."; }

  GrowingSteps(Teuchos::ParameterList const& parameters, ControlContext const& context)
      : StepControl(context.step)
      , steps_of_a_size_(parameters.get<int>("Steps of a Size"))
  {
  }

  bool adapts() const override { return false; }

  AcceptedStep advance(State& current, SolveCount& count) override
  {
    const std::int64_t growth = memory_.num_steps / steps_of_a_size_;
    const int level = static_cast<int>(std::max<std::int64_t>(clock().finestLevel() - growth, 0));
    return makeStep(current, level, count);
  }

private:
  int steps_of_a_size_;
};
} // namespace

ASPERITY_REGISTER(StepControlRegistry, "Growing Steps", StepControlKindOf<GrowingSteps>)

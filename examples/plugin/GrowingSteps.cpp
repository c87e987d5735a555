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
  // The size of the steps to come follows from what it remembers and from this entry.
  static bool mayChange(std::string const& entry) { return entry == "Steps of a Size"; }
  static std::string meaning() { return "steps begin with the smallest and grow."; }

  GrowingSteps(Teuchos::ParameterList const& parameters, ControlContext const& context)
      : StepControl(context)
      , steps_of_a_size_(parameters.get<int>("Steps of a Size"))
      , level_(clock().finestLevel())
  {
  }

  bool adapts() const override { return false; }

  AcceptedStep advance(State& current, SolveCount& count) override
  {
    auto const accepted = makeStep(current, level_, count);
    if (++made_ >= steps_of_a_size_) { // more than that where a restart has made it smaller
      made_ = 0;
      level_ = std::max(level_ - 1, 0);
    }
    return accepted;
  }

  // What a restart goes on from, in addition to the memory of every control.
  void save(Archive& archive, StateArchive const& states) const override
  {
    StepControl::save(archive, states);
    archive.set("growing/level", level_);
    archive.set("growing/made", made_);
  }
  void restore(Archive const& archive, StateArchive const& states) override
  {
    StepControl::restore(archive, states);
    level_ = static_cast<int>(archive.getInteger("growing/level"));
    made_ = static_cast<int>(archive.getInteger("growing/made"));
  }
  void adaptToClock() override
  {
    StepControl::adaptToClock();
    level_ = std::min(level_, clock().finestLevel());
  }

private:
  int steps_of_a_size_;
  int level_;    // of the steps of the present size
  int made_ = 0; // steps of that size
};
} // namespace

ASPERITY_REGISTER(StepControlRegistry, "Growing Steps", StepControlKindOf<GrowingSteps>)

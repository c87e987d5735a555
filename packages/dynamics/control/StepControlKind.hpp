#pragma once

#include "dynamics/control/StepControl.hpp"
#include "portability/Registry.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <string>

namespace asperity::dynamics
{
// What a control works with beside its parameters.
struct ControlContext
{
  CoupledStep& step;
  int order;        // of convergence of the scheme
  std::string path; // of the deck's list `Time Stepping`, for messages
};

// A kind of step control, registered under the name of its list in the deck's list `Time Stepping`.
class StepControlKind
{
public:
  static constexpr char const* registered_as = "step control";
  virtual ~StepControlKind() = default;

  virtual Teuchos::RCP<const Teuchos::ParameterList> validParameters() const = 0;
  virtual std::string meaning() const = 0; // a sentence for the list of parameters
  // `parameters` has been completed and validated.
  virtual std::unique_ptr<StepControl> make(Teuchos::ParameterList const& parameters,
                                            ControlContext const& context) const = 0;
};

// The kind of a class that has static validParameters(), static meaning() and a constructor
// (ParameterList const&, ControlContext const&). At the bottom of the file of the class:
//   ASPERITY_REGISTER(StepControlRegistry, "Step Doubling", StepControlKindOf<StepDoubling>)
template <class Type>
class StepControlKindOf : public StepControlKind
{
public:
  Teuchos::RCP<const Teuchos::ParameterList> validParameters() const override
  {
    return Type::validParameters();
  }
  std::string meaning() const override { return Type::meaning(); }
  std::unique_ptr<StepControl> make(Teuchos::ParameterList const& parameters,
                                    ControlContext const& context) const override
  {
    return std::make_unique<Type>(parameters, context);
  }
};

using StepControlRegistry = Registry<StepControlKind>;
} // namespace asperity::dynamics

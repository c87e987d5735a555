#include "io/outputs/FieldHistory.hpp"

namespace asperity::io
{
namespace
{
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
    return "Fields on the fault over time: fault.h5, fault.xdmf.";
  }

  FaultHistory(Teuchos::ParameterList const& parameters, OutputContext const& context)
    : FieldHistory("fault", parameters, context)
  {
  }
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Fault History", OutputKindOf<FaultHistory>)
} // namespace asperity::io

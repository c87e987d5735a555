#include "io/outputs/FieldHistory.hpp"

namespace asperity::io
{
namespace
{
class SurfaceHistory : public FieldHistory
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    Defaults defaults;
    defaults.fields = {"displacement"};
    defaults.every_n_steps = 10;
    defaults.rate_change_factor = 1.5;
    return parametersWith(defaults);
  }

  static std::string meaning()
  {
    return "Writes fields on the free surface over time to surface.h5 and surface.xdmf.";
  }

  SurfaceHistory(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : FieldHistory("surface", parameters, context)
  {
  }
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Surface History", OutputKindOf<SurfaceHistory>)
} // namespace asperity::io

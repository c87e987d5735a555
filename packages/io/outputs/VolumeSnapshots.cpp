#include "io/outputs/FieldHistory.hpp"

namespace asperity::io
{
namespace
{
class VolumeSnapshots : public FieldHistory
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    Defaults defaults;
    defaults.enabled = false; // large
    defaults.fields = {"displacement"};
    return parametersWith(defaults);
  }

  static std::string meaning()
  {
    return "Writes fields in the body at chosen times to volume.h5 and volume.xdmf.";
  }

  VolumeSnapshots(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : FieldHistory("volume", parameters, context)
  {
  }
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Volume Snapshots", OutputKindOf<VolumeSnapshots>)
} // namespace asperity::io

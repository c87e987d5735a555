#include "io/outputs/FieldHistory.hpp"

#include "parameters/Entries.hpp"

#include <algorithm>

namespace asperity::io
{
namespace
{
constexpr char const* fields_entry = "Fields";

struct HistorySettings
{
  bool is_enabled = true;
  std::vector<std::string> fields;
  bool is_single = true; // precision

  // They join those of the list.
  static Entries<HistorySettings> entries(HistorySettings const& defaults, ParameterList& list)
  {
    Entries<HistorySettings> entries(defaults, list);
    entries.boolean("Enabled", &HistorySettings::is_enabled, "If true, the run writes this output.")
      .textArray(fields_entry, &HistorySettings::fields, "The fields of these names are written.")
      .choice("Precision", &HistorySettings::is_single, {{"Single", true}, {"Double", false}},
              "Selects the precision of the fields in the file; times and coordinates are always "
              "written in double precision.");
    return entries;
  }
  static HistorySettings from(Teuchos::ParameterList const& parameters)
  {
    ParameterList declared;
    return entries({}, declared).read(parameters, parameters.name());
  }
};

std::vector<OutputField const*> chosenFields(std::string const& domain,
                                             Teuchos::ParameterList const& parameters,
                                             OutputContext const& context)
{
  auto names = HistorySettings::from(parameters).fields;
  if (parameters.getEntry(fields_entry).isDefault()) { // not every model has a state, say
    const auto is_missing = [&](auto const& name) {
      return !context.fields.hasField(domain, name);
    };
    names.erase(std::remove_if(names.begin(), names.end(), is_missing), names.end());
  }
  return context.fields.fields(domain, names,
                               "Asperity / Output: the list `Fields` for the " + domain);
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> FieldHistory::parametersWith(Defaults const& defaults)
{
  Declare parameters;
  HistorySettings::entries({defaults.enabled, defaults.fields}, *parameters.list());
  WriteRule::declare(parameters, defaults.every_n_steps, defaults.rate_change_factor);
  return parameters.list();
}

FieldHistory::FieldHistory(std::string const& domain, Teuchos::ParameterList const& parameters,
                           OutputContext const& context)
    : rule_(parameters)
    , series_({context.directory, domain, HistorySettings::from(parameters).is_single},
              context.domain(domain), chosenFields(domain, parameters, context))
{
}

void FieldHistory::write(StepInfo const& step)
{
  if (rule_.isDue(step)) {
    series_.append(step);
  }
}

void FieldHistory::closeSegment(int index) { series_.closeSegment(index); }

void FieldHistory::save(Archive& archive) const
{
  archive.insert("rule", rule_);
  archive.insert("series", series_);
}

void FieldHistory::restore(Archive const& archive)
{
  rule_.restore(archive.child("rule"));
  series_.restore(archive.child("series"));
}

Teuchos::RCP<const Teuchos::ParameterList> FaultHistory::validParameters()
{
  return parametersWith({true, {"slip_rate", "alpha", "slip", "traction", "opening"}, 10, 1.5});
}

std::string FaultHistory::meaning()
{
  return "Writes fields on the fault over time to fault.h5 and fault.xdmf.";
}

FaultHistory::FaultHistory(Teuchos::ParameterList const& parameters, OutputContext const& context)
    : FieldHistory("fault", parameters, context)
{
}

Teuchos::RCP<const Teuchos::ParameterList> SurfaceHistory::validParameters()
{
  return parametersWith({true, {"displacement"}, 10, 1.5});
}

std::string SurfaceHistory::meaning()
{
  return "Writes fields on the free surface over time to surface.h5 and surface.xdmf.";
}

SurfaceHistory::SurfaceHistory(Teuchos::ParameterList const& parameters,
                               OutputContext const& context)
    : FieldHistory("surface", parameters, context)
{
}

Teuchos::RCP<const Teuchos::ParameterList> VolumeSnapshots::validParameters()
{
  Defaults defaults;
  defaults.enabled = false; // large
  defaults.fields = {"displacement"};
  return parametersWith(defaults);
}

std::string VolumeSnapshots::meaning()
{
  return "Writes fields in the body at chosen times to volume.h5 and volume.xdmf.";
}

VolumeSnapshots::VolumeSnapshots(Teuchos::ParameterList const& parameters,
                                 OutputContext const& context)
    : FieldHistory("volume", parameters, context)
{
}

ASPERITY_REGISTER(OutputRegistry, "Fault History", OutputKindOf<FaultHistory>)
ASPERITY_REGISTER(OutputRegistry, "Surface History", OutputKindOf<SurfaceHistory>)
ASPERITY_REGISTER(OutputRegistry, "Volume Snapshots", OutputKindOf<VolumeSnapshots>)
} // namespace asperity::io

#include "io/outputs/FieldHistory.hpp"

#include <Teuchos_Array.hpp>

namespace asperity::io
{
namespace
{
std::vector<Field const*> chosenFields(std::string const& location,
                                       Teuchos::ParameterList const& parameters,
                                       OutputContext const& context)
{
  return context.fields.fields(location,
                               parameters.get<Teuchos::Array<std::string>>("Fields").toVector(),
                               "Asperity / Output: the list `Fields` for the " + location);
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> FieldHistory::parametersWith(Defaults const& defaults)
{
  Declare parameters;
  parameters.boolean("Enabled", defaults.enabled, "If true, the run writes this output.")
    .textArray("Fields", defaults.fields, "The fields of these names are written.")
    .choice("Precision", std::string("Single"), {"Single", "Double"},
            "Selects the precision of the fields in the file; times and coordinates are always "
            "written in double precision.");
  WriteRule::declare(parameters, defaults.every_n_steps, defaults.rate_change_factor);
  return parameters.list();
}

FieldHistory::FieldHistory(std::string const& location, Teuchos::ParameterList const& parameters,
                           OutputContext const& context)
    : rule_(parameters)
    , series_({context.directory, location, parameters.get<std::string>("Precision") == "Single"},
              context.location(location), chosenFields(location, parameters, context))
{
}

void FieldHistory::write(StepInfo const& step)
{
  if (rule_.isDue(step)) {
    series_.append(step);
    rowWritten(step);
  }
}

void FieldHistory::closeSegment(int index) { series_.closeSegment(index); }

void FieldHistory::save(Archive& archive) const
{
  Archive rule, series;
  rule_.save(rule);
  series_.save(series);
  archive.insert("rule", rule);
  archive.insert("series", series);
}

void FieldHistory::restore(Archive const& archive)
{
  rule_.restore(archive.child("rule"));
  series_.restore(archive.child("series"));
}
} // namespace asperity::io

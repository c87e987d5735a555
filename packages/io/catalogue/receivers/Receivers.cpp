#include "io/catalogue/receivers/Receivers.hpp"

#include "base/Errors.hpp"
#include "io/catalogue/fault_geometry/FaultAxis.hpp"
#include "io/series/SeriesLayout.hpp"

#include <Teuchos_Array.hpp>

namespace asperity::io
{
namespace
{
std::vector<detail::NamedPlace> placesIn(Teuchos::ParameterList const& list)
{
  std::vector<detail::NamedPlace> places;
  for (auto const& entry : list) {
    places.push_back({entry.first, list.get<Teuchos::Array<double>>(entry.first).toVector()});
  }
  return places;
}

detail::PlatformView platformView(OutputContext const& context)
{
  detail::PlatformView view;
  auto const& fault = context.location("fault");
  if (!fault.isCurve()) {
    view.plane = detail::faultPlane(fault, context.up);
    return view;
  }
  view.antiplane = context.fields.field("volume", "displacement").components == 1;
  view.is_level = detail::faultAxis(fault).is_level;
  return view;
}

detail::SegmentedTable::Options tableOf(OutputContext const& context,
                                        std::map<std::string, detail::ReceiverGroup> const& groups)
{
  detail::SegmentedTable::Options options;
  options.directory = context.directory;
  options.name = "receivers";
  options.columns = detail::timeColumns();
  for (auto const& [name, group] : groups) {
    const auto columns = group.columns(name);
    options.columns.insert(options.columns.end(), columns.begin(), columns.end());
  }
  options.describe_index = [&groups](h5::File& file) {
    file.setAttribute("format", "asperity receivers");
    file.setAttribute("format_version", std::int64_t(1));
    for (auto const& [name, group] : groups) {
      group.describe(file, name);
    }
  };
  return options;
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> Receivers::validParameters()
{
  const auto place = Declare()
                       .realArray("<receiver>", required, "m", Range::any(),
                                  "The receiver lies at this position, in coordinates of the mesh.")
                       .list();
  Declare parameters;
  parameters
    .boolean("Enabled", true,
             "If true, the run writes this output, provided that there are receivers.")
    .openSublist("On Fault", place, "Each entry puts a receiver of that name on the fault.")
    .openSublist("Off Fault", place, "Each entry puts a receiver of that name in the body.")
    .textArray("Fault Fields",
               std::vector<std::string>{"slip", "slip_rate", "traction", "normal_stress", "theta"},
               "The fields of these names are written for receivers on the fault.")
    .textArray("Body Fields", std::vector<std::string>{"displacement", "velocity"},
               "The fields of these names are written for receivers in the body.");
  WriteRule::declare(parameters, 1, 0);
  return parameters.list();
}

std::string Receivers::meaning()
{
  return "Writes time series at chosen places on the fault and in the body to receivers.h5.";
}

Receivers::Receivers(Teuchos::ParameterList const& parameters, OutputContext const& context)
    : rule_(parameters)
    , resamples_(context.text.platform == Platform::scec)
{
  const std::string path = "Asperity / Output / Receivers / ";
  const auto add = [&](std::string const& list, std::string const& group,
                       std::string const& location, std::string const& fields) {
    const auto places = placesIn(parameters.sublist(list));
    if (!places.empty()) {
      groups_.try_emplace(group, path + list, places, context.location(location))
        .first->second.chooseFields(parameters.get<Teuchos::Array<std::string>>(fields).toVector(),
                                    context.fields, path + fields);
    }
  };
  add("On Fault", "on_fault", "fault", "Fault Fields");
  add("Off Fault", "off_fault", "volume", "Body Fields");
  if (context.text.platform != Platform::none && !groups_.empty()) {
    writeTexts(context);
  }
  if (!groups_.empty()) {
    table_ = std::make_unique<detail::SegmentedTable>(tableOf(context, groups_), context.comm);
  }
}

void Receivers::writeTexts(OutputContext const& context)
{
  const auto view = platformView(context);
  const auto platform = context.text.platform;
  const bool is_seas = platform == Platform::seas;
  for (auto& [name, group] : groups_) {
    const bool on_fault = name == "on_fault";
    group.writeText(
      context, on_fault ? (is_seas ? "fltst_" : "fault") : (is_seas ? "blkst_" : "body"),
      on_fault ? detail::faultColumns(platform, view) : detail::bodyColumns(platform, view));
  }
}

void Receivers::write(StepInfo const& step)
{
  steps_.add(step);
  const bool is_due = rule_.isDue(step);
  if (groups_.empty() || !(is_due || resamples_)) {
    return;
  }
  std::vector<std::vector<double>> row{{step.time}, {static_cast<double>(step.step)}};
  for (auto& [name, group] : groups_) {
    const auto sampled = group.sample();
    for (auto const& field : group.chosenFields()) {
      row.push_back(sampled.at(field));
    }
    if (group.text()) {
      group.text()->write(step.time, sampled);
    }
  }
  if (is_due) {
    table_->append(1, row);
  }
}

void Receivers::closeSegment(int index)
{
  if (!groups_.empty()) {
    table_->closeSegment(index);
  }
  for (auto& [name, group] : groups_) {
    if (group.text()) {
      group.text()->flush(steps_);
    }
  }
}

std::string Receivers::signature() const
{
  std::string text;
  for (auto const& [name, group] : groups_) {
    text += name + '\n' + group.signature();
  }
  return text;
}

void Receivers::save(Archive& archive) const
{
  Archive rule, steps;
  rule_.save(rule);
  steps_.save(steps);
  archive.set("signature", signature());
  archive.insert("rule", rule);
  archive.insert("steps", steps);
  if (table_) {
    Archive table;
    table_->save(table);
    archive.insert("table", table);
  }
  for (auto const& [name, group] : groups_) {
    if (group.text()) {
      Archive text;
      group.text()->save(text);
      archive.insert(name, text);
    }
  }
}

void Receivers::restore(Archive const& archive)
{
  ASPERITY_REQUIRE(archive.get<std::string>("signature") == signature(),
                   "Asperity / Output / Receivers: the checkpoint continues files with other "
                   "receivers, fields or `SCEC / Time Step`. Restart with those of the earlier "
                   "run.");
  rule_.restore(archive.child("rule"));
  steps_.restore(archive.child("steps"));
  if (table_) {
    table_->restore(archive.child("table"));
  }
  for (auto& [name, group] : groups_) {
    if (group.text()) {
      group.text()->restore(archive.child(name));
    }
  }
}

ASPERITY_REGISTER(OutputRegistry, "Receivers", OutputKindOf<Receivers>)
} // namespace asperity::io

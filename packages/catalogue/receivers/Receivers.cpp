#include "catalogue/receivers/Receivers.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "io/series/SeriesLayout.hpp"

#include <Teuchos_Array.hpp>

namespace asperity::catalogue
{
namespace
{
io::SegmentedTable::Options tableOf(io::OutputContext const& context,
                                    std::map<std::string, ReceiverGroup> const& groups)
{
  io::SegmentedTable::Options options;
  options.directory = context.directory;
  options.name = "receivers";
  options.columns = io::timeColumns();
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

Entries<ReceiverSettings> ReceiverSettings::entries()
{
  const std::string meaning = "The receiver lies at this position, in coordinates of the mesh.";
  const auto in_body =
    Declare().realArray("<receiver>", required, "m", Range::any(), meaning).list();
  const auto on_fault =
    Declare()
      .realArray("<receiver>", required, "m", Range::any(),
                 meaning +
                   " On a fault in two dimensions a single number is the distance along it from "
                   "its upper end, or from the end of smaller x where the fault is level.")
      .list();
  const auto on_ground =
    Declare()
      .realArray("<receiver>", required, "m", Range::any(),
                 "The receiver lies where the vertical line through this position meets the free "
                 "surface, at its highest point there. Of several free surfaces it is the first "
                 "in the deck, as in Surface History. The coordinate along the axis that is Up may "
                 "be left out.")
      .list();
  Entries<ReceiverSettings> entries;
  entries
    .boolean("Enabled", &ReceiverSettings::is_enabled,
             "If true, the run writes this output, provided that there are receivers.")
    .others()
    .openSublist(on_fault_list, on_fault, "Each entry puts a receiver of that name on the fault.")
    .openSublist(off_fault_list, in_body, "Each entry puts a receiver of that name in the body.")
    .openSublist(
      on_ground_list, on_ground,
      "Each entry puts a receiver of that name on the ground. It is one of the receivers "
      "in the body.");
  entries
    .textArray("Fault Fields", &ReceiverSettings::fault_fields, optional,
               "The fields of these names are written for receivers on the fault. If it is left "
               "out, these are slip, slip_rate, traction, normal_stress, and the state as theta, "
               "or as psi or alpha where the laws do not define theta; a fault without friction "
               "has no normal stress and no state. In three dimensions slip_velocity is written, "
               "too, where a fault may open opening, and with fluids in the fault "
               "effective_normal_stress and their pore_pressure, darcy_velocity, fluid_pressure "
               "and temperature.")
    .textArray("Body Fields", &ReceiverSettings::body_fields,
               "The fields of these names are written for receivers in the body.");
  return entries;
}

ReceiverSettings ReceiverSettings::from(ParameterList const& list)
{
  return entries().read(list, list.name());
}

Teuchos::RCP<const Teuchos::ParameterList> Receivers::validParameters()
{
  auto entries = ReceiverSettings::entries();
  io::WriteRule::declare(entries.others(), 1, 0);
  return entries.list();
}

std::string Receivers::meaning()
{
  return "Writes time series at chosen places on the fault and in the body to receivers.h5.";
}

namespace
{
std::vector<std::string> usualFaultFields(io::FieldRegistry const& registry)
{
  std::vector<std::string> fields{"slip", "slip_rate", "traction"};
  const auto addIfThere = [&](std::string const& name) {
    const bool is_there = registry.hasField("fault", name);
    if (is_there) {
      fields.push_back(name);
    }
    return is_there;
  };
  for (auto const* name :
       {"slip_velocity", "opening", "normal_stress", "effective_normal_stress"}) {
    addIfThere(name);
  }
  // The first of these alone.
  static_cast<void>(addIfThere("theta") || addIfThere("psi") || addIfThere("alpha"));
  for (auto const* name : {"pore_pressure", "darcy_velocity", "fluid_pressure", "temperature"}) {
    addIfThere(name);
  }
  return fields;
}
} // namespace

Receivers::Receivers(Teuchos::ParameterList const& parameters, io::OutputContext const& context)
    : rule_(parameters)
{
  auto const settings = ReceiverSettings::from(parameters);
  auto const ground = groundOf(context.domains, context.up);
  const auto add = [&](std::vector<NamedPlace> const& places, std::string const& group,
                       std::string const& domain, std::string const& entry,
                       std::vector<std::string> const& fields) {
    if (!places.empty()) {
      auto const* above = domain == "volume" && ground ? &*ground : nullptr;
      groups_.try_emplace(group, places, context.domain(domain), above)
        .first->second.chooseFields(fields, context.fields, joinPath(receivers_path, entry));
    }
  };
  add(placesIn(parameters, on_fault_list), "on_fault", "fault", "Fault Fields",
      settings.fault_fields ? *settings.fault_fields : usualFaultFields(context.fields));
  add(placesInBody(parameters), "off_fault", "volume", "Body Fields", settings.body_fields);
  if (!groups_.empty()) {
    table_ = std::make_unique<io::SegmentedTable>(tableOf(context, groups_), context.comm);
  }
}

void Receivers::write(io::StepInfo const& step)
{
  if (!rule_.isDue(step) || groups_.empty()) {
    return;
  }
  std::vector<std::vector<double>> row{{step.time}, {static_cast<double>(step.step)}};
  for (auto const& [name, group] : groups_) {
    for (auto const* field : group.chosenFields()) {
      row.push_back(group.sample(*field));
    }
  }
  table_->append(1, row);
}

void Receivers::closeSegment(int index)
{
  if (table_) {
    table_->closeSegment(index);
  }
}

std::vector<std::string> Receivers::notes() const
{
  std::vector<std::string> notes;
  for (auto const& [name, group] : groups_) {
    auto const more = group.notes();
    notes.insert(notes.end(), more.begin(), more.end());
  }
  return notes;
}

std::vector<Warning> Receivers::warnings() const
{
  std::vector<Warning> warnings;
  for (auto const& [name, group] : groups_) {
    if (auto const warning = group.warning()) {
      warnings.push_back(*warning);
    }
  }
  return warnings;
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
  archive.set("signature", signature());
  archive.insert("rule", rule_);
  if (table_) {
    archive.insert("table", *table_);
  }
}

void Receivers::restore(Archive const& archive)
{
  ASPERITY_REQUIRE(archive.get<std::string>("signature") == signature(),
                   "Asperity / Output / Receivers: the checkpoint continues files with other "
                   "receivers or fields. Restart with those of the earlier run.");
  rule_.restore(archive.child("rule"));
  if (table_) {
    table_->restore(archive.child("table"));
  }
}

ASPERITY_REGISTER(io::OutputRegistry, "Receivers", io::OutputKindOf<Receivers>)
} // namespace asperity::catalogue

#include "catalogue/events/EventCatalogue.hpp"

#include "base/Errors.hpp"
#include "catalogue/events/EventTable.hpp"

#include <sstream>

namespace asperity::catalogue
{
namespace
{
constexpr char const* list_path = "Asperity / Output / Event Catalogue";
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> EventCatalogue::validParameters()
{
  return EventSettings::entries().list();
}

std::string EventCatalogue::meaning()
{
  return "Writes one row for every earthquake to events.csv.";
}

EventCatalogue::EventCatalogue(Teuchos::ParameterList const& parameters,
                               io::OutputContext const& context)
    : EventCatalogue(EventSettings::entries().read(parameters, list_path), context)
{
}

EventCatalogue::EventCatalogue(EventSettings const& settings, io::OutputContext const& context)
    : settings_(settings)
    , all_(settings, context, "events.csv")
{
  ASPERITY_REQUIRE(
    !all_.domain().isCurve() || settings.smallest_magnitude == EventSettings::no_magnitude,
    list_path << " / Smallest Magnitude = " << settings.smallest_magnitude
              << ": in two dimensions an event has a moment per length and no magnitude. Give "
                 "a Smallest Width instead.");
  if (!settings.each_fault) {
    return;
  }
  const auto files = eventFiles(all_.domain().boundaries);
  ASPERITY_REQUIRE(!files.empty(),
                   list_path << " / Each Fault is true, but "
                                "there is friction on one boundary alone, whose events are in "
                                "events.csv. Leave it out.");
  for (std::size_t i = 0; i < files.size(); ++i) {
    faults_.push_back(
      std::make_unique<FaultEvents>(settings, context, files[i], &all_, static_cast<int>(i)));
  }
}

void EventCatalogue::write(io::StepInfo const& step)
{
  all_.write(step);
  for (auto const& each : faults_) {
    each->write(step);
  }
}

void EventCatalogue::closeSegment(int index)
{
  all_.closeSegment(index);
  for (auto const& each : faults_) {
    each->closeSegment(index);
  }
}

void EventCatalogue::finish()
{
  all_.finish();
  for (auto const& each : faults_) {
    each->finish();
  }
}

bool EventCatalogue::endsRun() const
{
  return mayEndRun() && static_cast<std::int64_t>(events().size()) >= settings_.most_events;
}

std::string EventCatalogue::report() const
{
  std::ostringstream text;
  auto rows = events();
  for (auto& event : rows) {
    event.fault = io::partAt(all_.domain(), event.nucleation);
  }
  printEvents(text, rows);
  text << '\n';
  printSummary(text, summary());
  if (all_.numSmall() > 0) {
    text << "and " << all_.numSmall() << " that are left out: below 'Smallest Width' or 'Smallest "
         << "Magnitude' of the event catalogue\n";
  }
  text << all_.thresholdRemark();
  text << '\n';
  return text.str();
}

std::vector<double> EventCatalogue::signature() const
{
  return {settings_.merging_time, settings_.smallest_width, settings_.smallest_magnitude,
          static_cast<double>(faults_.size())};
}

void EventCatalogue::save(Archive& archive) const
{
  all_.save(archive);
  archive.set("choice", signature());
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    archive.insert("faults/" + std::to_string(i), *faults_[i]);
  }
}

void EventCatalogue::restore(Archive const& archive)
{
  ASPERITY_REQUIRE(
    archive.get<std::vector<double>>("choice") == signature(),
    "Asperity / Output / Event Catalogue: the checkpoint continues a table with "
    "another Merging Time, Smallest Width, Smallest Magnitude or Each Fault. Restart "
    "with those of the earlier run; asperity-plot and asperity-report can leave out "
    "more.");
  all_.restore(archive);
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    faults_[i]->restore(archive.child("faults/" + std::to_string(i)));
  }
}

ASPERITY_REGISTER(io::OutputRegistry, "Event Catalogue", io::OutputKindOf<EventCatalogue>)
} // namespace asperity::catalogue

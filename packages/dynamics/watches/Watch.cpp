#include "dynamics/watches/Watch.hpp"

namespace asperity::dynamics
{
Teuchos::RCP<const Teuchos::ParameterList> Watch::validParameters()
{
  return Teuchos::rcp(new Teuchos::ParameterList());
}

Watches::Watches(Teuchos::ParameterList const& parameters, WatchContext const& context)
{
  auto const& registry = WatchRegistry::instance();
  for (auto const& name : registry.names()) {
    watches_.push_back({name, registry.at(name).make(parameters, context)});
  }
}

void Watches::note(WatchedState const& now, Notes& notes)
{
  for (auto const& each : watches_) {
    each.watch->note(now, notes);
  }
}

void Watches::requireUsefulRun() const
{
  for (auto const& each : watches_) {
    each.watch->requireUsefulRun();
  }
}

std::vector<Warning> Watches::warningsOfRun() const
{
  Notes notes;
  for (auto const& each : watches_) {
    notes.add(each.watch->warningOfRun());
  }
  return notes.warnings;
}

std::string Watches::report() const
{
  std::string all;
  for (auto const& each : watches_) {
    all += each.watch->report();
  }
  return all;
}

void Watches::save(Archive& archive) const
{
  for (auto const& each : watches_) {
    Archive memory;
    each.watch->save(memory);
    archive.insert(each.name, memory);
  }
}

void Watches::restore(Archive const& archive, Watch::Restart const& restart)
{
  for (auto const& each : watches_) {
    each.watch->restore(archive.child(each.name), restart);
  }
}
} // namespace asperity::dynamics

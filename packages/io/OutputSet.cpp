#include "io/OutputSet.hpp"

#include "base/Errors.hpp"
#include "parameters/Entries.hpp"
#include "parameters/ParameterValue.hpp"
#include "parameters/Parameters.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::io
{
Teuchos::RCP<const Teuchos::ParameterList> OutputSet::validParameters()
{
  auto list = Teuchos::rcp(new ParameterList("Output"));
  declare(*list);
  return list;
}

namespace
{
// The entries of the deck's list that outputs read, complete.
ParameterList complete(Teuchos::ParameterList const& given)
{
  auto const valid = OutputSet::validParameters();
  ParameterList list;
  for (auto const& entry : *valid) {
    if (given.isParameter(entry.first)) {
      list.setEntry(entry.first, given.getEntry(entry.first));
    }
  }
  completeAndValidate(list, *valid, "Asperity / Output");
  return list;
}

// It joins those of the list.
Entries<DirectionUp> upEntries(ParameterList& list)
{
  Entries<DirectionUp> entries({}, list);
  entries.realArray(DirectionUp::entry, &DirectionUp::up, optional, "-", Range::any(),
                    "This vector points up in three dimensions; strike and dip of the fault "
                    "follow from it. Its length has no effect. If it is left out, up is the "
                    "axis that is nearest to the outward normal of the Free Surface; against "
                    "Gravity Direction if there is none; without both, if gravity acts, where "
                    "the boundaries face that nothing holds; else +y.");
  return entries;
}
} // namespace

DirectionUp DirectionUp::from(Teuchos::ParameterList const& output)
{
  ParameterList declared;
  return upEntries(declared).read(output, "Asperity / Output");
}

std::array<double, 3> DirectionUp::orDefault() const
{
  if (!up) {
    return {0, 1, 0};
  }
  auto const& v = *up;
  ASPERITY_REQUIRE(v.size() == 3 && std::hypot(v[0], v[1], v[2]) > 0,
                   "Asperity / Output / Up has to be three numbers, not all of them zero. For "
                   "example {0, 1, 0}.");
  return {v[0], v[1], v[2]};
}

void OutputSet::declare(Teuchos::ParameterList& list)
{
  Declare parameters(list);
  for (auto const& name : OutputRegistry::instance().names()) {
    auto const& kind = OutputRegistry::instance().at(name);
    parameters.sublist(name, kind.validParameters(), kind.meaning());
  }
  upEntries(list);
}

OutputSet::OutputSet(Teuchos::ParameterList const& parameters, OutputContext const& given)
{
  auto const list = complete(parameters);
  OutputContext context = given;
  context.up = DirectionUp::from(list).orDefault();
  makeOutputs(list, context);
  std::stable_partition(entries_.begin(), entries_.end(),
                        [](Entry const& entry) { return entry.output->mayEndRun(); });
}

std::vector<double> OutputSet::times(Teuchos::ParameterList const& parameters)
{
  std::vector<double> result;
  auto const all = complete(parameters);
  for (auto const& name : OutputRegistry::instance().names()) {
    auto const& list = all.sublist(name);
    if (list.get<bool>("Enabled") && list.isParameter("Times")) {
      auto const times = list.get<Teuchos::Array<double>>("Times");
      result.insert(result.end(), times.begin(), times.end());
    }
  }
  return result;
}

void OutputSet::makeOutputs(Teuchos::ParameterList const& parameters, OutputContext const& context)
{
  for (auto const& name : OutputRegistry::instance().names()) {
    auto const& kind = OutputRegistry::instance().at(name);
    auto const& list = parameters.sublist(name);
    const auto domain = kind.neededDomain();
    if (!list.get<bool>("Enabled")) {
      continue;
    }
    if (domain.empty() || context.domains.count(domain) > 0) {
      entries_.push_back({name, kind.make(list, context)});
    } else if (hasGivenEntry(list)) {
      left_out_.push_back({name, domain});
    }
  }
}

OutputSet::~OutputSet() = default;

// Those that may end the run are the first, so that the others know their last step.
void OutputSet::write(StepInfo const& given)
{
  StepInfo step = given;
  for (auto& entry : entries_) {
    entry.output->write(step);
    step.is_last = step.is_last || entry.output->endsRun();
  }
}

void OutputSet::closeSegment()
{
  for (auto& entry : entries_) {
    entry.output->closeSegment(num_closed_segments_);
  }
  ++num_closed_segments_;
}

Archive OutputSet::save() const
{
  Archive archive;
  archive.set("num_closed_segments", num_closed_segments_);
  for (auto const& entry : entries_) {
    archive.insert(entry.name, *entry.output);
  }
  return archive;
}

void OutputSet::restore(Archive const& archive)
{
  num_closed_segments_ = static_cast<int>(archive.getInteger("num_closed_segments"));
  for (auto& entry : entries_) {
    entry.output->restore(archive.child(entry.name));
  }
}

void OutputSet::finish()
{
  for (auto& entry : entries_) {
    entry.output->finish();
  }
}

bool OutputSet::endsRun() const
{
  return std::any_of(entries_.begin(), entries_.end(),
                     [](Entry const& entry) { return entry.output->endsRun(); });
}

std::optional<std::int64_t> OutputSet::numEvents() const
{
  for (auto const& entry : entries_) {
    if (auto const number = entry.output->numEvents()) {
      return number;
    }
  }
  return {};
}

std::string OutputSet::report() const
{
  std::string text;
  for (auto const& entry : entries_) {
    text += entry.output->report();
  }
  return text;
}

std::vector<std::string> OutputSet::notes() const
{
  std::vector<std::string> notes;
  for (auto const& entry : entries_) {
    auto const more = entry.output->notes();
    notes.insert(notes.end(), more.begin(), more.end());
  }
  return notes;
}

std::vector<Warning> OutputSet::warnings() const
{
  std::vector<Warning> warnings;
  for (auto const& entry : entries_) {
    auto const more = entry.output->warnings();
    warnings.insert(warnings.end(), more.begin(), more.end());
  }
  return warnings;
}
} // namespace asperity::io

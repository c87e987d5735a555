#include "io/OutputSet.hpp"

#include "base/Errors.hpp"
#include "base/parameters/Parameters.hpp"
#include "io/catalogue/events/EventCatalogue.hpp"
#include "io/catalogue/receivers/PointLocation.hpp"

#include <Teuchos_Array.hpp>

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
void declareUp(Declare& parameters)
{
  parameters.realArray("Up", std::vector<double>{0, 1, 0}, "-", Range::any(),
                       "This vector points up in three dimensions; strike and dip of the fault "
                       "follow from it. Its length has no effect.");
}

std::array<double, 3> upIn(Teuchos::ParameterList const& output)
{
  ParameterList list;
  if (output.isParameter("Up")) {
    list.setEntry("Up", output.getEntry("Up"));
  }
  Declare valid;
  declareUp(valid);
  completeAndValidate(list, *valid.list(), "Asperity / Output");
  auto const& up = list.get<Teuchos::Array<double>>("Up");
  ASPERITY_REQUIRE(up.size() == 3 && std::hypot(up[0], up[1], up[2]) > 0,
                   "Asperity / Output / Up has to be three numbers, not all of them zero. For "
                   "example {0, 1, 0}.");
  return {up[0], up[1], up[2]};
}
} // namespace

void OutputSet::declare(Teuchos::ParameterList& list)
{
  Declare parameters(list);
  for (auto const& name : OutputRegistry::instance().names()) {
    const auto kind = OutputRegistry::instance().create(name, "Output");
    parameters.sublist(name, kind->validParameters(), kind->meaning());
  }
  declareUp(parameters);
  TextFormat::declare(parameters);
}

namespace
{
TextFormat textFormat(Teuchos::ParameterList const& parameters, OutputContext const& context)
{
  TextFormat format = TextFormat::from(parameters);
  if (format.platform != Platform::none && format.element_size == 0) {
    format.element_size = detail::shortestElement(context.location("fault"));
  }
  return format;
}
} // namespace

OutputSet::OutputSet(Teuchos::ParameterList const& parameters, OutputContext const& given)
{
  OutputContext context = given;
  context.text = textFormat(parameters, given);
  context.up = upIn(parameters);
  platform_ = context.text.platform;
  for (auto const& name : OutputRegistry::instance().names()) {
    const auto kind = OutputRegistry::instance().create(name, "Output");
    ParameterList list = parameters.isSublist(name) ? parameters.sublist(name) : ParameterList();
    completeAndValidate(list, *kind->validParameters(), "Asperity / Output / " + name);
    if (list.get<bool>("Enabled")) {
      entries_.push_back({name, kind->make(list, context)});
    }
  }
}

OutputSet::~OutputSet() = default;

void OutputSet::write(StepInfo const& step)
{
  for (auto& entry : entries_) {
    entry.output->write(step);
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
  archive.set("text_format", std::string(platformName(platform_)));
  for (auto const& entry : entries_) {
    Archive part;
    entry.output->save(part);
    archive.insert(entry.name, part);
  }
  return archive;
}

void OutputSet::restore(Archive const& archive)
{
  auto const& earlier = archive.get<std::string>("text_format");
  ASPERITY_REQUIRE(earlier == platformName(platform_),
                   "Asperity / Output / Text Format is "
                     << platformName(platform_) << ", but it was " << earlier
                     << " in the run that the checkpoint continues. Restart with the Text Format "
                        "of the earlier run.");
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

EventCatalogue const* OutputSet::events() const
{
  for (auto const& entry : entries_) {
    if (auto const* catalogue = dynamic_cast<EventCatalogue const*>(entry.output.get())) {
      return catalogue;
    }
  }
  return nullptr;
}
} // namespace asperity::io

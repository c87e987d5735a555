#include "catalogue/events/Rupture.hpp"

#include "io/series/SeriesLayout.hpp"
#include "parameters/Entries.hpp"

#include <cmath>
#include <limits>

namespace asperity::catalogue
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct RuptureSettings
{
  bool is_enabled = true;
  double threshold = 1e-3; // [m/s]
};

Entries<RuptureSettings> ruptureEntries()
{
  return Entries<RuptureSettings>()
    .boolean("Enabled", &RuptureSettings::is_enabled, "If true, the run writes this output.")
    .real("Threshold", &RuptureSettings::threshold, "m/s", Range::positive(),
          "The rupture has reached a node when its slip rate is at least this. An event lasts as "
          "long as some node slips at least as fast.");
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> Rupture::validParameters()
{
  return ruptureEntries().list();
}

std::string Rupture::meaning()
{
  return "Writes to rupture.h5 when the rupture of each event reached each node of the fault.";
}

Rupture::Rupture(Teuchos::ParameterList const& parameters, io::OutputContext const& context)
    : EventFollower(context, ruptureEntries().read(parameters, parameters.name()).threshold)
    , table_(tableOptions(context.directory), context.comm)
    , first_time_(fault().numOwned(), nan)
{
}

void Rupture::finish()
{
  if (eventInProgress()) {
    addRow();
    stop();
    closeSegment(static_cast<int>(table_.rowsOfSegment().size()));
  }
}

void Rupture::save(Archive& archive) const
{
  Archive follower;
  EventFollower::save(follower);
  archive.insert("follower", follower);
  archive.insert("table", table_);
  archive.set("num_events", num_events_);
  archive.set("onset", onset_);
  archive.setAtNodes("event_time", event_time_, fault().name);
  archive.setAtNodes("first_time", first_time_, fault().name);
}

void Rupture::restore(Archive const& archive)
{
  using Numbers = std::vector<double>;
  EventFollower::restore(archive.child("follower"));
  num_events_ = archive.getInteger("num_events");
  onset_ = archive.getDouble("onset");
  event_time_ = archive.get<Numbers>("event_time");
  first_time_ = archive.get<Numbers>("first_time");
  table_.restore(archive.child("table"));
}

void Rupture::begin(Sample const& now)
{
  onset_ = crossingTime(now);
  event_time_.assign(fault().numOwned(), nan);
}

void Rupture::follow(Sample const& now)
{
  for (std::size_t i = 0; i < now.rates.size(); ++i) {
    if (now.rates[i] >= threshold() && std::isnan(event_time_[i])) {
      event_time_[i] = crossingTime(now, i);
      if (std::isnan(first_time_[i])) {
        first_time_[i] = event_time_[i];
      }
    }
  }
}

void Rupture::end(Sample const&) { addRow(); }

io::SegmentedTable::Options Rupture::tableOptions(std::filesystem::path const& directory)
{
  const h5::Shape nodes{static_cast<hsize_t>(fault().num_global_nodes)};
  io::SegmentedTable::Options options;
  options.directory = directory;
  options.name = "rupture";
  options.rows_per_write = 1;
  options.nodes = &fault();
  options.columns = {
    {"number", "-", "Number of the event, from 1.", h5::Type::int64, {}},
    {"onset", "s", "When the first node reached the threshold.", h5::Type::float64, {}},
    {"rupture_time", "s", "When each node first reached the threshold in the event; nan: never.",
     h5::Type::float64, nodes, io::SegmentedTable::Column::Support::nodes}};
  options.describe_index = [this](h5::File& file) {
    file.setAttribute("format", "asperity rupture");
    file.setAttribute("format_version", std::int64_t(1));
    io::writeDataset(file, "threshold", std::vector<double>{threshold()}, {1}, "m/s",
                     "Slip rate with which the rupture has arrived.");
  };
  options.nodal_numbers = {{"first_rupture_time", "s",
                            "When each node first reached the threshold; nan: never.",
                            &first_time_}};
  return options;
}

void Rupture::addRow()
{
  ++num_events_;
  table_.append(1, {{static_cast<double>(num_events_)}, {onset_}, event_time_});
}

ASPERITY_REGISTER(io::OutputRegistry, "Rupture", io::OutputKindOf<Rupture>)
} // namespace asperity::catalogue

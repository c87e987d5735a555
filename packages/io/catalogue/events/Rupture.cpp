#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parameters/Parameters.hpp"
#include "io/Output.hpp"
#include "io/catalogue/events/EventFollower.hpp"
#include "io/catalogue/fault_geometry/FaultPlaces.hpp"
#include "io/files/DurableFile.hpp"
#include "io/parallel/NodeGather.hpp"
#include "io/platforms/PlatformFile.hpp"
#include "io/series/SegmentedTable.hpp"
#include "io/series/SeriesLayout.hpp"

#include <cmath>
#include <limits>

namespace asperity::io
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// DIR/rupture.h5: when each node of the fault first reached a slip rate, in each event and in the
// run; for a platform also its file of rupture times. Needs `slip_rate` on the fault.
class Rupture : public detail::EventFollower
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Declare()
      .boolean("Enabled", true, "If true, the run writes this output.")
      .real("Threshold", 1e-3, "m/s", Range::positive(),
            "The rupture has reached a node when its slip rate is at least this. An event lasts as "
            "long as some node slips at least as fast.")
      .list();
  }

  static std::string meaning()
  {
    return "Writes to rupture.h5 when the rupture of each event reached each node of the fault.";
  }

  Rupture(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : EventFollower(context, parameters.get<double>("Threshold"))
      , gather_(fault())
      , table_(tableOptions(context.directory), context.comm)
      , directory_(context.directory)
      , text_(context.text)
      , first_time_(fault().numOwned(), nan)
  {
    if (text_.platform != Platform::none) {
      places_ = detail::faultPlaces(fault(), context.up);
    }
  }

  Rupture(Rupture const&) = delete; // the table describes itself with the members
  Rupture& operator=(Rupture const&) = delete;

  void closeSegment(int index) override
  {
    whole_first_time_ = gather_(first_time_, 1, 1);
    table_.closeSegment(index);
    onRoot(*fault().comm, [&] { writeText(); });
  }

  void finish() override
  {
    if (eventInProgress()) {
      addRow();
      stop();
      closeSegment(static_cast<int>(table_.rowsOfSegment().size()));
    }
  }

  void save(Archive& archive) const override
  {
    Archive follower, table;
    EventFollower::save(follower);
    table_.save(table);
    archive.insert("follower", follower);
    archive.insert("table", table);
    archive.set("num_events", num_events_);
    archive.set("onset", onset_);
    archive.set("event_time", event_time_);
    archive.set("first_time", first_time_);
  }

  void restore(Archive const& archive) override
  {
    using Numbers = std::vector<double>;
    EventFollower::restore(archive.child("follower"));
    num_events_ = archive.getInteger("num_events");
    onset_ = archive.getDouble("onset");
    event_time_ = archive.get<Numbers>("event_time");
    first_time_ = archive.get<Numbers>("first_time");
    whole_first_time_ = gather_(first_time_, 1, 1);
    table_.restore(archive.child("table"));
  }

protected:
  void begin(Sample const& now) override
  {
    onset_ = crossingTime(now);
    event_time_.assign(fault().numOwned(), nan);
  }

  void follow(Sample const& now) override
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

  void end(Sample const&) override { addRow(); }

private:
  detail::SegmentedTable::Options tableOptions(std::filesystem::path const& directory)
  {
    const h5::Shape nodes{static_cast<hsize_t>(fault().num_global_nodes)};
    detail::SegmentedTable::Options options;
    options.directory = directory;
    options.name = "rupture";
    options.rows_per_write = 1;
    options.nodes = &fault();
    options.columns = {
      {"number", "-", "Number of the event, from 1.", h5::Type::int64, {}},
      {"onset", "s", "When the first node reached the threshold.", h5::Type::float64, {}},
      {"rupture_time", "s", "When each node first reached the threshold in the event; nan: never.",
       h5::Type::float64, nodes, true}};
    options.describe_index = [this, nodes](h5::File& file) {
      file.setAttribute("format", "asperity rupture");
      file.setAttribute("format_version", std::int64_t(1));
      detail::writeDataset(file, "threshold", std::vector<double>{threshold()}, {1}, "m/s",
                           "Slip rate with which the rupture has arrived.");
      detail::writeDataset(file, "first_rupture_time", whole_first_time_, nodes, "s",
                           "When each node first reached the threshold; nan: never.");
    };
    return options;
  }

  void addRow()
  {
    ++num_events_;
    table_.append(1, {{static_cast<double>(num_events_)}, {onset_}, event_time_});
  }

  // SEAS: rupture.dat with x2, x3; SCEC: cplot with j, k; both in m along strike and down dip.
  void writeText() const
  {
    if (text_.platform == Platform::none) {
      return;
    }
    constexpr double never = 1e9; // what the platforms agreed on
    const bool is_seas = text_.platform == Platform::seas;
    detail::PlatformContent content;
    content.name = is_seas ? "rupture.dat" : "cplot";
    content.remarks = detail::columnRemarks({"Distance along strike (m)", "Distance down dip (m)",
                                             "Time (s) at which the slip rate first reached " +
                                               shortNumber(threshold()) + " m/s; 1E+09: never"});
    content.fields = is_seas ? "x2 x3 t" : "j k t";
    std::string text = detail::platformHeader(text_, content, nullptr) + '\n';
    for (std::size_t i = 0; i < whole_first_time_.size(); ++i) {
      const double time = std::isnan(whole_first_time_[i]) ? never : whole_first_time_[i];
      text += detail::platformNumber(places_.along_strike[i]) + ' ' +
              detail::platformNumber(places_.down_dip[i]) + ' ' + detail::platformTime(time) + '\n';
    }
    detail::replaceText(directory_ / text_.folder() / content.name, text);
  }

  detail::NodeGather gather_;
  detail::SegmentedTable table_;
  std::filesystem::path directory_;
  TextFormat text_;
  detail::FaultPlaces places_;

  std::int64_t num_events_ = 0;          // that have ended
  double onset_ = 0;                     // [s]
  std::vector<double> event_time_;       // (num_owned) [s] in the event in progress
  std::vector<double> first_time_;       // (num_owned) [s]
  std::vector<double> whole_first_time_; // (num_nodes), on rank 0
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Rupture", OutputKindOf<Rupture>)
} // namespace asperity::io

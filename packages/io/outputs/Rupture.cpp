#include "base/Errors.hpp"
#include "base/Parameters.hpp"
#include "io/Output.hpp"
#include "io/detail/DurableFile.hpp"
#include "io/detail/FaultAxis.hpp"
#include "io/detail/FaultRates.hpp"
#include "io/detail/Gather.hpp"
#include "io/detail/PlatformFile.hpp"
#include "io/detail/SeriesLayout.hpp"

#include <cmath>
#include <limits>

namespace asperity::io
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// DIR/rupture.h5: when each node of the fault first reached a slip rate, in each event and in the
// run; for a platform also its file of rupture times. Needs `slip_rate` on the fault.
class Rupture : public Output
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters()
  {
    return Declare()
      .boolean("Enabled", true, "Whether to write this output.")
      .real("Threshold", 1e-3, "m/s", Range::positive(),
            "Slip rate with which the rupture has arrived; an event is a contiguous time in which "
            "some node slides at least as fast.")
      .list();
  }

  static std::string meaning()
  {
    return "When the rupture of each event reached each node of the fault: rupture.h5.";
  }

  Rupture(Teuchos::ParameterList const& parameters, OutputContext const& context)
      : fault_(context.location("fault"))
      , rates_(fault_, context.fields)
      , threshold_(parameters.get<double>("Threshold"))
      , gather_(fault_)
      , geometry_(detail::gatherGeometry(fault_, gather_))
      , table_(tableOptions(context.directory), context.comm)
      , directory_(context.directory)
      , text_(context.text)
      , first_time_(fault_.numOwned(), nan)
  {
    if (text_.platform != Platform::none) {
      ASPERITY_REQUIRE(fault_.isCurve(), "Output / Text Format: the fault is not a curve. Choose "
                                         "None.");
      axis_ = detail::faultAxis(fault_);
    }
  }

  Rupture(Rupture const&) = delete; // the table describes itself with the members
  Rupture& operator=(Rupture const&) = delete;

  void write(StepInfo const& step) override
  {
    const auto now = rates_.sample();
    const bool is_seismic = now.peak >= threshold_;
    if (is_seismic && !in_progress_) {
      begin(step.time, now.peak);
    }
    if (in_progress_) {
      recordArrivals(step.time, now.rates);
      if (!is_seismic) {
        end();
      }
    }
    has_previous_ = true;
    previous_time_ = step.time;
    previous_peak_ = now.peak;
    previous_rates_ = now.rates;
  }

  void closeSegment(int index) override
  {
    whole_first_time_ = gather_(first_time_, 1, 1);
    table_.closeSegment(index);
    detail::onRoot(*fault_.comm, [&] { writeText(); });
  }

  void finish() override
  {
    if (in_progress_) {
      end();
      closeSegment(static_cast<int>(table_.rowsOfSegment().size()));
    }
  }

  void save(Archive& archive) const override
  {
    Archive table;
    table_.save(table);
    archive.insert("table", table);
    archive.set("num_events", num_events_);
    archive.set("in_progress", in_progress_);
    archive.set("onset", onset_);
    archive.set("event_time", event_time_);
    archive.set("first_time", first_time_);
    archive.set("previous/exists", has_previous_);
    archive.set("previous/time", previous_time_);
    archive.set("previous/peak", previous_peak_);
    archive.set("previous/rates", previous_rates_);
  }

  void restore(Archive const& archive) override
  {
    using Numbers = std::vector<double>;
    num_events_ = archive.getInteger("num_events");
    in_progress_ = archive.getInteger("in_progress") != 0;
    onset_ = archive.getDouble("onset");
    event_time_ = archive.get<Numbers>("event_time");
    first_time_ = archive.get<Numbers>("first_time");
    has_previous_ = archive.getInteger("previous/exists") != 0;
    previous_time_ = archive.getDouble("previous/time");
    previous_peak_ = archive.getDouble("previous/peak");
    previous_rates_ = archive.get<Numbers>("previous/rates");
    whole_first_time_ = gather_(first_time_, 1, 1);
    table_.restore(archive.child("table"));
  }

private:
  detail::SegmentedTable::Options tableOptions(std::filesystem::path const& directory)
  {
    const h5::Shape nodes{static_cast<hsize_t>(fault_.num_global_nodes)};
    detail::SegmentedTable::Options options;
    options.directory = directory;
    options.name = "rupture";
    options.rows_per_write = 1;
    options.columns = {
      {"number", "-", "Number of the event, from 1.", h5::Type::int64, {}},
      {"onset", "s", "When the first node reached the threshold.", h5::Type::float64, {}},
      {"rupture_time", "s", "When each node first reached the threshold in the event; nan: never.",
       h5::Type::float64, nodes}};
    options.describe_index = [this, nodes](h5::File& file) {
      file.setAttribute("format", "asperity rupture");
      file.setAttribute("format_version", std::int64_t(1));
      detail::writeGeometry(file, fault_, geometry_);
      detail::writeDataset(file, "threshold", std::vector<double>{threshold_}, {1}, "m/s",
                           "Slip rate with which the rupture has arrived.");
      detail::writeDataset(file, "first_rupture_time", whole_first_time_, nodes, "s",
                           "When each node first reached the threshold; nan: never.");
    };
    return options;
  }

  // Between the previous sample and this one; at this one if it is the first.
  double arrival(double before, double after, double time) const
  {
    if (!has_previous_) {
      return time;
    }
    const double at = detail::crossing(before, after, threshold_);
    return previous_time_ + at * (time - previous_time_);
  }

  void begin(double time, double peak)
  {
    in_progress_ = true;
    onset_ = arrival(previous_peak_, peak, time);
    event_time_.assign(fault_.numOwned(), nan);
  }

  void recordArrivals(double time, std::vector<double> const& rates)
  {
    for (std::size_t i = 0; i < rates.size(); ++i) {
      if (rates[i] >= threshold_ && std::isnan(event_time_[i])) {
        event_time_[i] = arrival(has_previous_ ? previous_rates_[i] : 0, rates[i], time);
        if (std::isnan(first_time_[i])) {
          first_time_[i] = event_time_[i];
        }
      }
    }
  }

  void end()
  {
    in_progress_ = false;
    ++num_events_;
    table_.append(1, {{static_cast<double>(num_events_)}, {onset_}, gather_(event_time_, 1, 1)});
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
                                               shortNumber(threshold_) + " m/s; 1E+09: never"});
    content.fields = is_seas ? "x2 x3 t" : "j k t";
    std::string text = detail::platformHeader(text_, content, nullptr) + '\n';
    for (std::size_t i = 0; i < whole_first_time_.size(); ++i) {
      const double time = std::isnan(whole_first_time_[i]) ? never : whole_first_time_[i];
      const double distance = axis_.distances[i];
      text += detail::platformNumber(axis_.is_level ? distance : 0) + ' ' +
              detail::platformNumber(axis_.is_level ? 0 : distance) + ' ' +
              detail::platformTime(time) + '\n';
    }
    detail::replaceText(directory_ / text_.folder() / content.name, text);
  }

  Location const& fault_;
  detail::FaultRates rates_;
  double threshold_; // [m/s]
  detail::NodeGather gather_;
  detail::WholeGeometry geometry_;
  detail::SegmentedTable table_;
  std::filesystem::path directory_;
  TextFormat text_;
  detail::FaultAxis axis_;

  std::int64_t num_events_ = 0; // that have ended
  bool in_progress_ = false;
  double onset_ = 0;                     // [s]
  std::vector<double> event_time_;       // (num_owned) [s] in the event in progress
  std::vector<double> first_time_;       // (num_owned) [s]
  std::vector<double> whole_first_time_; // (num_nodes), on rank 0
  bool has_previous_ = false;
  double previous_time_ = 0;
  double previous_peak_ = 0;
  std::vector<double> previous_rates_;
};
} // namespace

ASPERITY_REGISTER(OutputRegistry, "Rupture", OutputKindOf<Rupture>)
} // namespace asperity::io

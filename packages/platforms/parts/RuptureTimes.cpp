#include "platforms/parts/RuptureTimes.hpp"

#include "base/parallel/Agreement.hpp"
#include "io/files/DurableFile.hpp"
#include "io/parallel/BlocksInOrder.hpp"

#include <cmath>
#include <optional>

namespace asperity::platforms
{
RuptureTimes::RuptureTimes(Platform const& platform, io::OutputContext const& context,
                           std::string name, std::string fields, catalogue::Rupture const& rupture)
    : platform_(platform)
    , name_(std::move(name))
    , fields_(std::move(fields))
    , directory_(context.directory)
    , comm_(context.comm)
    , rupture_(rupture)
    , is_curve_(context.domain("fault").isCurve())
    , final_time_(context.final_time)
    , places_(catalogue::faultPlaces(context.domain("fault"), context.up))
    , blocks_(context.domain("fault"))
{
}

void RuptureTimes::flush(StepFacts const&)
{
  auto const& times = rupture_.firstTimes();
  std::vector<double> rows; // (num_owned, 3)
  for (std::size_t i = 0; i < times.size(); ++i) {
    rows.insert(rows.end(),
                {places_.along_strike[i], platform_.run.depth_of_upper_end + places_.down_dip[i],
                 std::isnan(times[i]) ? never() : times[i]});
  }
  std::optional<io::ReplacingText> file; // of rank 0
  onRoot(*comm_, [&] {
    file.emplace(directory_ / platform_.folder / name_);
    file->add(header() + '\n');
  });
  io::visitInOrder(blocks_(rows, 1, 3), *comm_, [&](std::vector<double> const& block) {
    for (std::size_t i = 0; i < block.size(); i += 3) {
      file->add(numberText(block[i]) + ' ' + numberText(block[i + 1]) + ' ' +
                timeText(block[i + 2]) + '\n');
    }
  });
  onRoot(*comm_, [&] { file->finish(); });
}

// 1e9 s is what the platforms agreed on. In longer runs it is a time like others.
double RuptureTimes::never() const
{
  double time = 1e9;
  while (time <= final_time_) {
    time *= 10;
  }
  return time;
}

std::string RuptureTimes::header() const
{
  FileContent content;
  content.name = name_;
  auto const along_strike = "Distance along strike (m) from the " +
                            std::string(is_curve_ ? "fault's end of smaller x" : "mesh's origin");
  auto const down_dip = "Distance down dip (m), " +
                        io::shortNumber(platform_.run.depth_of_upper_end) +
                        " at the upper end of the fault";
  content.remarks = columnRemarks({along_strike, down_dip,
                                   "Time (s) at which the slip rate first reached " +
                                     io::shortNumber(rupture_.threshold()) + " m/s; " +
                                     timeText(never()) + ": never"});
  content.fields = fields_;
  return fileHeader(platform_, content, nullptr);
}
} // namespace asperity::platforms

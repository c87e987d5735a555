#include "platforms/parts/RuptureTimes.hpp"

#include "base/parallel/Agreement.hpp"
#include "io/files/DurableFile.hpp"

#include <cmath>

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
    , places_(catalogue::faultPlaces(context.domain("fault"), context.up))
{
}

void RuptureTimes::flush(StepFacts const&)
{
  onRoot(*comm_, [&] { io::replaceText(directory_ / platform_.folder / name_, text()); });
}

std::string RuptureTimes::text() const
{
  constexpr double never = 1e9; // what the platforms agreed on
  FileContent content;
  content.name = name_;
  content.remarks = columnRemarks({"Distance along strike (m)", "Distance down dip (m)",
                                   "Time (s) at which the slip rate first reached " +
                                     io::shortNumber(rupture_.threshold()) + " m/s; 1E+09: never"});
  content.fields = fields_;
  std::string text = fileHeader(platform_, content, nullptr) + '\n';
  auto const& times = rupture_.firstTimes();
  for (std::size_t i = 0; i < times.size(); ++i) {
    text += numberText(places_.along_strike[i]) + ' ' +
            numberText(platform_.run.depth_of_upper_end + places_.down_dip[i]) + ' ' +
            timeText(std::isnan(times[i]) ? never : times[i]) + '\n';
  }
  return text;
}
} // namespace asperity::platforms

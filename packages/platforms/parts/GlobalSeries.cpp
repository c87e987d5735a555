#include "platforms/parts/GlobalSeries.hpp"

#include <array>

namespace asperity::platforms
{
namespace
{
FileContent contentFor(bool on_curve)
{
  FileContent content;
  content.name = "global.dat";
  content.remarks =
    columnRemarks({"Time (s)", "Max slip rate (log10 m/s)",
                   on_curve ? "Moment rate per length (N/s)" : "Moment rate (N m/s)"});
  content.fields = "t max_slip_rate moment_rate";
  return content;
}
} // namespace

GlobalSeries::GlobalSeries(Platform const& platform, io::OutputContext const& context,
                           catalogue::Global const& global)
    : global_(global)
    , file_(platform, contentFor(context.domain("fault").isCurve()), context)
{
}

void GlobalSeries::write(io::StepInfo const& step)
{
  if (global_.hasRow()) {
    const std::array<double, 2> values{decimalLogarithm(global_.peakSlipRate()),
                                       global_.momentRate()};
    file_.writeRow(step.time, values.data(), values.size());
  }
}
} // namespace asperity::platforms

#include "io/platforms/SlipProfiles.hpp"

#include "io/catalogue/fault_geometry/FaultAxis.hpp"

#include <algorithm>

namespace asperity::io::detail
{
namespace
{
// From the upper end of the fault down, on rank 0.
std::vector<double> depths(Location const& fault)
{
  auto distances = faultAxis(fault).distances;
  std::sort(distances.begin(), distances.end());
  return distances;
}

bool startsBelow(Location const& fault)
{
  const auto distances = faultAxis(fault).distances;
  return !distances.empty() && distances.front() > distances.back();
}

PlatformContent contentFor(Location const& fault)
{
  const auto z = depths(fault);
  PlatformContent content;
  content.name = "slip.dat";
  content.remarks = {"Row #1 = Distance along the fault (m) with two zeros first",
                     "Column #1 = Time (s)", "Column #2 = Max slip rate (log10 m/s)",
                     "Column #3-" + std::to_string(z.size() + 2) + " = Slip (m)"};
  content.fields = "z\nt\nmax_slip_rate\nslip\n" + platformTime(0) + ' ' + platformNumber(0);
  for (const double value : z) {
    content.fields += ' ' + platformNumber(value);
  }
  return content;
}
} // namespace

SlipProfiles::SlipProfiles(OutputContext const& context)
    : gather_(context.location("fault"))
    , rates_(context.location("fault"), context.fields)
    , slip_(context.fields.field("fault", "slip"))
    , is_reversed_(startsBelow(context.location("fault")))
    , file_(context.text, context.directory, contentFor(context.location("fault")), context.comm)
{
}

void SlipProfiles::write(StepInfo const& step)
{
  std::vector<double> slip;
  slip_.values(slip);
  const std::size_t components = slip_.components;
  const auto whole = gather_(slip, 1, components);
  std::vector<double> row;
  for (std::size_t node = 0; node < whole.size(); node += components) {
    row.push_back(whole[node]);
  }
  if (is_reversed_) {
    std::reverse(row.begin(), row.end());
  }
  row.insert(row.begin(), platformLogarithm(rates_.sample().peak));
  file_.writeRow(step.time, row.data(), row.size());
}
} // namespace asperity::io::detail

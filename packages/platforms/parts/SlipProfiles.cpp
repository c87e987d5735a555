#include "platforms/parts/SlipProfiles.hpp"

#include "io/parallel/BlocksInOrder.hpp"

namespace asperity::platforms
{
namespace
{
// z: of all nodes by number, on rank 0; parts: of a fault of several, or nothing.
FileContent contentFor(std::vector<double> const& z, std::string const& parts)
{
  FileContent content;
  content.name = "slip.dat";
  content.remarks = {
    "Row #1 = Distance along the fault from its upper end (m) with two zeros first" +
      (parts.empty() ? "" : "; " + parts),
    "Column #1 = Time (s)", "Column #2 = Max slip rate (log10 m/s)",
    "Column #3-" + std::to_string(z.size() + 2) + " = Slip (m)"};
  content.fields = "z\nt\nmax_slip_rate\nslip\n" + timeText(0) + ' ' + numberText(0);
  for (const double value : z) {
    content.fields += ' ' + numberText(value);
  }
  return content;
}
} // namespace

SlipProfiles::SlipProfiles(Platform const& platform, io::OutputContext const& context,
                           io::FaultHistory const& history)
    : history_(history)
    , fault_(context.domain("fault"))
    , blocks_(fault_)
    , slip_(context.fields.field("fault", "slip"))
    , sign_(ModelView::of(context).thrust_sign)
    , file_(platform,
            contentFor(io::joinedInOrder(fault_, blocks_(fault_.positions, 1, 1)),
                       io::partsText(fault_)),
            context)
{
}

void SlipProfiles::write(io::StepInfo const& step)
{
  if (!history_.hasRow()) {
    return;
  }
  std::vector<double> slip;
  slip_.values(slip);
  const std::size_t components = slip_.components;
  const auto whole = io::joinedInOrder(fault_, blocks_(slip, 1, components));
  std::vector<double> row;
  for (std::size_t node = 0; node < whole.size(); node += components) {
    row.push_back(sign_ * whole[node]);
  }
  row.insert(row.begin(), decimalLogarithm(step.peak_slip_rate));
  file_.writeRow(step.time, row.data(), row.size());
}
} // namespace asperity::platforms

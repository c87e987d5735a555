#include "scenario/checks/DriveCheck.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/checks/BoundaryField.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
namespace
{
constexpr int num_times = 128;

// [m/s]. No machine that shears rock or analogue materials passes some metres per second, and
// quasi-dynamic bodies, which have no waves, stand for plates and slow machines.
// Chosen by judgement; no deck in xml/ drives as fast.
double fastestDrive(bool is_quasi_dynamic) { return is_quasi_dynamic ? 1 : 10; }

// The largest value at the nodes of this rank from t = 0 to `end` [s].
double largest(NodalField const& field, double end)
{
  double size = 0;
  const int times = field.dependsOnTime() ? num_times : 0;
  for (int i = 0; i <= times; ++i) {
    for (const double value : field.at(times > 0 ? end * i / times : 0)) {
      size = std::max(size, std::abs(value));
    }
  }
  return size;
}
} // namespace

template <int Dim>
std::vector<Warning> warnOfDrive(Problem<Dim> const& problem)
{
  const double fastest = fastestDrive(problem.settings.bulk.isQuasiDynamic());
  const double end = problem.settings.time.final_time;
  std::vector<Warning> warnings;
  for (auto const& condition : problem.settings.conditions) {
    for (char const* entry : {condition_entries::velocity, condition_entries::plate_rate}) {
      if (!isGiven(condition.list, entry)) {
        continue;
      }
      const double rate = maxOverRanks(
        largest(boundaryField(condition, entry, problem.mesh()), end), *problem.communicator);
      if (rate > fastest) {
        warnings.push_back(
          {"rate of a drive",
           joinPath(condition.name, entry) + " reaches " + formatShort(rate) +
             " m/s. Plates move at 1e-10 to 1e-8 m/s, and machines that shear rock at up to some "
             "m/s. Is it in mm per year? 1 mm per year is 3.17e-11 m/s."});
      }
    }
  }
  return warnings;
}

template std::vector<Warning> warnOfDrive(Problem<2> const&);
template std::vector<Warning> warnOfDrive(Problem<3> const&);
} // namespace asperity::scenario

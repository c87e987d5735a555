#pragma once

#include "base/Warning.hpp"
#include "dynamics/checks/FaultResolution.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// Lines for the log. They have the nucleation length where a formula gives it for the state law
// (StateLawProperties::nucleation_source), or else the shortest wavelength that grows. lower_cells:
// how cells beside the fault become lower, see adviceOnLowerCells.
std::vector<std::string> describe(dynamics::FaultResolution const& resolution,
                                  LawChoice const& laws, std::string const& lower_cells);
// A sentence that says how the cells beside these faults become lower; empty if the settings of the
// mesh make them flat along all the faults already.
std::string adviceOnLowerCells(MeshSettings const& mesh, std::vector<std::string> const& faults);
// Warns if there are fewer than three cells per cohesive zone, and if only a part of the fault
// weakens and is less than half as long as the nucleation length, unless the state law weakens
// friction at high slip rates more than a and b say.
std::vector<Warning> warnOfResolution(dynamics::FaultResolution const& resolution,
                                      LawChoice const& laws);

// Warns of cells beside a fault that are far higher than long, whether the fault has friction or
// known slip. Collective.
template <int Dim>
std::optional<Warning> warnOfCellShape(Problem<Dim> const& problem);

// Lines for the log about places that cannot slip and about the front of slip to expect.
std::vector<std::string> describeScales(FaultScales const& scales);

// The fewest cells of the zone behind a front of slip (dynamics::FrontZone). With xml/bp6.xml and
// the slip law, 0.4, 0.8, 1.4 and 2.9 cells give peak slip rates of 12, 3.5, 1.5 and 1.1 times the
// limit for ever smaller cells.
constexpr double fewest_cells_of_front = 2;
// A warning if the zone has fewer cells; `where` says which front it is, as "at t = 3 s, (0, 1)".
Warning warnOfFront(double cells, std::string const& where);
} // namespace asperity::scenario

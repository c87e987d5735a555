#pragma once

#include <string>
#include <vector>

// Times at which formulas in t do something that steps may pass.
namespace asperity
{
// The constants with which a formula compares t, shifted or not, in their order: 120 and 300 of
// "t > 2 * 60 && 300 >= t", 70 of "t - 60 < 10", 50 and 70 of "abs(t - 60) < 10".
std::vector<double> timesComparedIn(std::string const& formula);

// The times at which t less a constant, or a constant less t, is zero: 60 of
// "exp(-((t - 60) / 5)^2)".
std::vector<double> timesShiftedIn(std::string const& formula);
} // namespace asperity

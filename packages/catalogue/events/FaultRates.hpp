#pragma once

#include "io/Output.hpp"

#include <array>
#include <vector>

namespace asperity::catalogue
{
// Where between two samples a rate meets the threshold, linear in its logarithm: 0 to 1.
double crossing(double before, double after, double threshold);

// The rate [m/s] at the vertex of the parabola in time [s] through the logarithms of three
// successive samples. The middle sample itself if it is not the largest, or more than twice one of
// the others: such samples do not resolve a peak.
double peakRate(std::array<double, 3> const& times, std::array<double, 3> const& rates);

// 1 where friction decides on the slip rate, and on faults whose slip is prescribed (field
// `given_slip`, if there is one); 0 where it is prescribed beside friction (field `prescribed`, if
// there is one): such nodes are no part of an earthquake. (num_owned)
std::vector<double> countedNodes(io::OutputContext const& context);
} // namespace asperity::catalogue

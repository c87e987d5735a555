#pragma once

#include "mesh/GlobalMesh.hpp"

#include <array>
#include <string>
#include <vector>

// Where faults meet, by places and names, as programs report it.
namespace asperity::mesh
{
// A crossing by its place [m] and the names of its two faults, ascending. Two names that are one
// fault there are "east/west".
template <int Dim>
struct NamedCrossing
{
  Point<Dim> place{};
  std::array<std::string, 2> faults;
};

// The crossings of a mesh that is split, in the order of crossingsOf.
template <template <int> class AnyMesh, int Dim>
std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const& mesh);

// Crossings, or joints, that follow one another along edges of both faults: in space a line, in the
// plane a single one.
template <int Dim>
struct MeetingLine
{
  std::array<std::string, 2> faults; // as in NamedCrossing; of joints the branch, then the other
  int num_vertices = 0;
  double length = 0;                // [m] of the edges between them
  std::array<Point<Dim>, 2> ends{}; // two that are far from each other
};

// The lines of a mesh that is split, in the order of their first crossings or joints.
template <int Dim>
std::vector<MeetingLine<Dim>> crossingLines(GlobalMesh<Dim> const& mesh);
template <int Dim>
std::vector<MeetingLine<Dim>> jointLines(GlobalMesh<Dim> const& mesh);
} // namespace asperity::mesh

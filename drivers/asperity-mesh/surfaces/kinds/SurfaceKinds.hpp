#pragma once

#include "Warnings.hpp"
#include "surfaces/Projection.hpp"
#include "surfaces/TriangleSurface.hpp"

#include "parameters/Parameters.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// A rectangle of the map, in coordinates of the model [m].
struct MapArea
{
  std::array<double, 2> low, high;
};

// What surfaces of a deck are made with.
struct SurfaceContext
{
  Projection const* projection = nullptr; // nullptr: none, and degrees are refused
  std::array<double, 2> origin{};         // of the model, in projected coordinates [m]
  std::filesystem::path folder;           // of the deck: files are relative to it
  // Surfaces with `Extend Up` go on above this z [m].
  double highest_ground = 0;
  // A grid is sampled in this area; without it, where it has values.
  std::optional<MapArea> area;
  RemarkSink remark = warn;
};

// The kinds of surfaces that a deck has: each has entries of its own, which stand in the list of
// the surface among others that this part does not read.
//
//   Declare declare;
//   declareSurface(declare);                      // `Type` and the entries of each type
//   chooseSurfaceType(list, path);                // a deck may leave out `Type`
//   completeAndValidate(list, *declare.list(), path);
//   makeSurface(list, path, context);
Declare& declareSurface(Declare& declare);

// Sets `Type`, unless the deck gives it, to the kind of which the list has the entry that names its
// source: `Surface File`, `Trace File`, `Trace`, `Contours File`, `Grid File` or `Top Centre`.
// InputError if it has none of them, or those of several kinds.
void chooseSurfaceType(ParameterList& list, std::string const& path);

// list: complete, see above; path: where it stands, for messages. InputError if files or numbers
// make no surface.
TriangleSurface makeSurface(ParameterList const& list, std::string const& path,
                            SurfaceContext const& context);

// The words of `Type`.
std::vector<std::string> surfaceTypes();
} // namespace asperity::geometry

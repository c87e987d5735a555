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

// The functions that a deck's list of a surface needs, for all registered kinds (SurfaceKind). Each
// kind has entries of its own. They stand in the list of the surface, which may have others, too.
//
//   Declare declare;
//   declareSurface(declare);                      // `Type` and the entries of each type
//   chooseSurfaceType(list, path);                // a deck may leave out `Type`
//   completeAndValidate(list, *declare.list(), path);
//   makeSurface(list, path, context);
Declare& declareSurface(Declare& declare);

// Sets `Type`, unless the deck gives it, to the kind of which the list has an entry that says where
// the surface comes from (SurfaceKind::sources), such as `Surface File` or `Top Centre`. InputError
// if it has none of them, or those of several kinds.
void chooseSurfaceType(ParameterList& list, std::string const& path);

// list: complete, see above; path: where it stands, for messages. InputError if files or numbers
// make no surface.
TriangleSurface makeSurface(ParameterList const& list, std::string const& path,
                            SurfaceContext const& context);

// The entry that names this file, in a list that has these other entries, too: `Surface File` for
// "main.stl". If the name does not tell the kind, that of the kind which has most of the entries.
std::string fileEntryFor(std::string const& file_name, std::vector<std::string> const& entries);
} // namespace asperity::geometry

#pragma once

#include "catalogue/receivers/Ground.hpp"
#include "parameters/Parameters.hpp"

#include <string>
#include <vector>

namespace asperity::catalogue
{
// The deck's list of receivers, for messages, and the lists of places in it.
inline constexpr char const* receivers_path = "Asperity / Output / Receivers";
inline constexpr char const* on_fault_list = "On Fault";
inline constexpr char const* off_fault_list = "Off Fault";
inline constexpr char const* on_ground_list = "On Ground";

// A named place, as the deck has it.
struct NamedPlace
{
  std::string list; // one of those above
  std::string name;
  std::vector<double> coordinates; // (dimension) [m]; fewer where the list allows it

  bool isOnGround() const { return list == on_ground_list; }
  std::string path() const; // of its entry, for messages
};

// The places in one of the lists of `Output / Receivers`.
std::vector<NamedPlace> placesIn(ParameterList const& receivers, std::string const& list);

// The places of receivers in the body: those off the fault and those on the ground. InputError if
// both lists have the same name.
std::vector<NamedPlace> placesInBody(ParameterList const& receivers);

// The points of the ground above or below places of `On Ground`. A place may lack its coordinate
// along the vertical axis, which then counts as 0. ground: null where the model has no free
// surface. InputError for such a model, for a place with another number of coordinates, and for
// one without ground above or below it. Collective.
std::vector<GroundPoint> pointsOnGround(std::vector<NamedPlace> const& places,
                                        Ground const* ground);
} // namespace asperity::catalogue

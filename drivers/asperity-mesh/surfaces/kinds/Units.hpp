#pragma once

#include "surfaces/Lofting.hpp"
#include "surfaces/Projection.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

#include "parameters/Parameters.hpp"

#include <array>
#include <string>

namespace asperity::geometry
{
// How the coordinates of a source become those of the model.
class Units
{
public:
  // horizontal: "m", "km", "degrees" (longitude and latitude, which need the projection);
  // vertical [m]: the unit of z. InputError, which starts with `path`, for degrees without a
  // projection.
  Units(std::string const& horizontal, double vertical, std::string const& path,
        SurfaceContext const& context);

  // The entries `Units` and `Depth Units` of sources that do not tell their units.
  static Declare& declare(Declare& declare);
  static Units read(ParameterList const& list, std::string const& path,
                    SurfaceContext const& context);

  double horizontal() const { return horizontal_; } // [m]; 1 for degrees
  bool areDegrees() const { return are_degrees_; }

  void toModel(Polyline& points) const;
  void fromModel(Polyline& points) const; // x and y alone

private:
  double horizontal_, vertical_;
  bool are_degrees_;
  Projection const* projection_;
  std::array<double, 2> origin_;
};

// 1 for "m", 1000 for "km"
double lengthUnit(std::string const& word);

// The file of an entry, relative to the folder of the deck.
std::string fileOf(ParameterList const& list, std::string const& name,
                   SurfaceContext const& context);

// z [m] up to which a surface goes that ends at lower_z and is to be cut by the ground.
double aboveGround(double lower_z, SurfaceContext const& context);

// The entry `Extend Up`.
Declare& declareExtendUp(Declare& declare, bool value);
} // namespace asperity::geometry

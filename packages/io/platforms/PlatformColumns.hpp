#pragma once

#include "io/catalogue/fault_geometry/FaultPlane.hpp"
#include "io/platforms/TextFormat.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity::io::detail
{
// A column of a station's file after the time, made of a field's component in one direction.
struct PlatformColumn
{
  char const* description; // "Slip (m)"
  char const* name;        // "slip"
  char const* field;       // of the registry; nullptr: zeros, what the model has not
  Direction direction;     // (1, 0, 0) of a field with one component
  double (*convert)(double);
};
using PlatformColumns = std::vector<PlatformColumn>;

// How the mesh lies in the platform's space.
struct PlatformView
{
  bool antiplane = false;               // displacement across the plane, which is along strike
  bool is_level = false;                // plane strain in a map: the fault runs along strike
  std::optional<FaultPlane> plane = {}; // in three dimensions, where the rest says nothing
};

// Of a station on the fault and one in the body. SEAS: slip, slip rate, shear stress, in plane
// strain normal stress, and state; displacement and velocity along the axes of the mesh. SCEC:
// slip along strike (h) or, where the plane is a section, down dip (v); n-stress positive in
// compression; displacement along strike, vertical (y) and across the fault.
//
// In three dimensions the rates are of the field `slip_velocity`; SEAS: 1 is from the fault into
// the body, 2 along strike, 3 down (dip, on the fault). SCEC: h along strike, v down (dip), n from
// the fault into the body.
PlatformColumns faultColumns(Platform platform, PlatformView const& view);
PlatformColumns bodyColumns(Platform platform, PlatformView const& view);

// The distinct fields of the columns.
std::vector<std::string> fieldsOf(PlatformColumns const& columns);

// The values of one row of the station `station`; sampled: (num_stations, components) by field.
std::vector<double> rowOf(PlatformColumns const& columns,
                          std::map<std::string, std::vector<double>> const& sampled,
                          std::size_t station, std::size_t num_stations);
} // namespace asperity::io::detail

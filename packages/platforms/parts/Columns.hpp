#pragma once

#include "catalogue/fault_geometry/FaultPlane.hpp"
#include "io/Output.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity::platforms
{
using catalogue::Direction;

// A column of a station's file after the time, made of a field's component in one direction.
struct Column
{
  char const* description; // "Slip (m)"
  char const* name;        // "slip"
  char const* field;       // of the registry; nullptr: the model has none, write zeros
  Direction direction;     // (1, 0, 0) of a field with one component
  double (*convert)(double);
};
using Columns = std::vector<Column>;

// Directions and conversions of columns.
inline constexpr Direction first_component{1, 0, 0};
inline constexpr Direction second_component{0, 1, 0};
inline constexpr Direction down{0, -1, 0};
double unchanged(double value);
double megapascal(double value);      // from Pa
double logarithmOfSize(double value); // decimal

// How the mesh lies in the platform's space.
struct ModelView
{
  bool antiplane = false; // displacement across the plane of the mesh, which is along strike
  bool is_level = false;  // plane strain in a map: the fault runs along strike
  // Plane strain in a section: the sign with which slip along the tangent is positive in a thrust,
  // where the hanging wall moves up dip.
  double thrust_sign = 1;
  std::optional<catalogue::FaultPlane> plane = {}; // in three dimensions; the rest says nothing

  static ModelView of(io::OutputContext const& context); // collective
};

// The distinct fields of the columns.
std::vector<std::string> fieldsOf(Columns const& columns);

// The values of one row of the station `station`; sampled: (num_stations, components) by field.
std::vector<double> rowOf(Columns const& columns,
                          std::map<std::string, std::vector<double>> const& sampled,
                          std::size_t station, std::size_t num_stations);
} // namespace asperity::platforms

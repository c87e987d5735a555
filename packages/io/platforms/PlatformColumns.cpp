#include "io/platforms/PlatformColumns.hpp"

#include "io/platforms/PlatformFile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::io::detail
{
namespace
{
double same(double value) { return value; }
double megapascal(double value) { return 1e-6 * value; }
double logarithmOfSize(double value) { return platformLogarithm(std::abs(value)); }

constexpr Direction first{1, 0, 0};
constexpr Direction second{0, 1, 0};

PlatformColumns seasFaultInSpace(FaultPlane const& plane)
{
  return {
    {"Slip along strike (m)", "slip_2", "slip", plane.strike, same},
    {"Slip down dip (m)", "slip_3", "slip", plane.dip, same},
    {"Slip rate along strike (log10 m/s)", "slip_rate_2", "slip_velocity", plane.strike,
     logarithmOfSize},
    {"Slip rate down dip (log10 m/s)", "slip_rate_3", "slip_velocity", plane.dip, logarithmOfSize},
    {"Shear stress along strike (MPa)", "shear_stress_2", "traction", plane.strike, megapascal},
    {"Shear stress down dip (MPa)", "shear_stress_3", "traction", plane.dip, megapascal},
    {"State (log10 s)", "state", "theta", first, platformLogarithm}};
}

PlatformColumns seasFault(PlatformView const& view)
{
  if (view.plane) {
    return seasFaultInSpace(*view.plane);
  }
  PlatformColumns columns{
    {"Slip (m)", "slip", "slip", first, same},
    {"Slip rate (log10 m/s)", "slip_rate", "slip_rate", first, platformLogarithm},
    {"Shear stress (MPa)", "shear_stress", "traction", first, megapascal}};
  if (!view.antiplane) {
    columns.push_back({"Normal stress (MPa)", "normal_stress", "normal_stress", first, megapascal});
  }
  columns.push_back({"State (log10 s)", "state", "theta", first, platformLogarithm});
  return columns;
}

PlatformColumns seasBodyInSpace(FaultPlane const& plane)
{
  return {{"Displacement from the fault (m)", "disp_1", "displacement", plane.inward, same},
          {"Displacement along strike (m)", "disp_2", "displacement", plane.strike, same},
          {"Displacement down (m)", "disp_3", "displacement", plane.down, same},
          {"Velocity from the fault (m/s)", "vel_1", "velocity", plane.inward, same},
          {"Velocity along strike (m/s)", "vel_2", "velocity", plane.strike, same},
          {"Velocity down (m/s)", "vel_3", "velocity", plane.down, same}};
}

PlatformColumns seasBody(PlatformView const& view)
{
  if (view.plane) {
    return seasBodyInSpace(*view.plane);
  }
  if (view.antiplane) {
    return {{"Displacement (m)", "disp", "displacement", first, same},
            {"Velocity (m/s)", "vel", "velocity", first, same}};
  }
  return {{"Displacement 1 (m)", "disp_1", "displacement", first, same},
          {"Displacement 2 (m)", "disp_2", "displacement", second, same},
          {"Velocity 1 (m/s)", "vel_1", "velocity", first, same},
          {"Velocity 2 (m/s)", "vel_2", "velocity", second, same}};
}

PlatformColumns scecFault(PlatformView const& view)
{
  const bool in_space = view.plane.has_value();
  const bool along_strike = view.antiplane || view.is_level;
  const auto along = [&](char const* field) { return in_space || along_strike ? field : nullptr; };
  const auto down = [&](char const* field) { return in_space || !along_strike ? field : nullptr; };
  const Direction h = in_space ? view.plane->strike : first;
  const Direction v = in_space ? view.plane->dip : first;
  char const* rate = in_space ? "slip_velocity" : "slip_rate";
  return {
    {"horizontal slip (m)", "h-slip", along("slip"), h, same},
    {"horizontal slip rate (m/s)", "h-slip-rate", along(rate), h, same},
    {"horizontal shear stress (MPa)", "h-shear-stress", along("traction"), h, megapascal},
    {"vertical slip (m)", "v-slip", down("slip"), v, same},
    {"vertical slip rate (m/s)", "v-slip-rate", down(rate), v, same},
    {"vertical shear stress (MPa)", "v-shear-stress", down("traction"), v, megapascal},
    {"normal stress (MPa)", "n-stress", "normal_stress", first, megapascal},
    {"log10 of state variable (log-seconds)", "log-theta", "theta", first, platformLogarithm}};
}

// The directions along strike, vertical and across the fault; null: the model has none.
using BodyDirections = std::array<std::optional<Direction>, 3>;

BodyDirections bodyDirections(PlatformView const& view)
{
  if (view.plane) {
    return {view.plane->strike, view.plane->down, view.plane->inward};
  }
  if (view.antiplane) {
    return {first, std::nullopt, std::nullopt};
  }
  return view.is_level ? BodyDirections{first, std::nullopt, second}
                       : BodyDirections{std::nullopt, second, first};
}

PlatformColumns scecBody(PlatformView const& view)
{
  const auto [h, v, n] = bodyDirections(view);
  const auto column = [](char const* description, char const* name, char const* field,
                         std::optional<Direction> const& direction) {
    return PlatformColumn{description, name, direction ? field : nullptr, direction.value_or(first),
                          same};
  };
  return {column("horizontal displacement (m)", "h-disp", "displacement", h),
          column("horizontal velocity (m/s)", "h-vel", "velocity", h),
          column("vertical displacement (m)", "v-disp", "displacement", v),
          column("vertical velocity (m/s)", "v-vel", "velocity", v),
          column("normal displacement (m)", "n-disp", "displacement", n),
          column("normal velocity (m/s)", "n-vel", "velocity", n)};
}
} // namespace

PlatformColumns faultColumns(Platform platform, PlatformView const& view)
{
  return platform == Platform::seas ? seasFault(view) : scecFault(view);
}

PlatformColumns bodyColumns(Platform platform, PlatformView const& view)
{
  return platform == Platform::seas ? seasBody(view) : scecBody(view);
}

std::vector<std::string> fieldsOf(PlatformColumns const& columns)
{
  std::vector<std::string> fields;
  for (auto const& column : columns) {
    if (column.field && std::find(fields.begin(), fields.end(), column.field) == fields.end()) {
      fields.emplace_back(column.field);
    }
  }
  return fields;
}

std::vector<double> rowOf(PlatformColumns const& columns,
                          std::map<std::string, std::vector<double>> const& sampled,
                          std::size_t station, std::size_t num_stations)
{
  std::vector<double> row;
  for (auto const& column : columns) {
    if (column.field == nullptr) {
      row.push_back(0);
      continue;
    }
    auto const& values = sampled.at(column.field);
    const std::size_t components = values.size() / num_stations;
    double value = 0;
    for (std::size_t c = 0; c < components; ++c) {
      value += column.direction[c] * values[station * components + c];
    }
    row.push_back(column.convert(value));
  }
  return row;
}
} // namespace asperity::io::detail

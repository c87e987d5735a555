#include "io/detail/PlatformColumns.hpp"

#include "io/detail/PlatformFile.hpp"

#include <algorithm>

namespace asperity::io::detail
{
namespace
{
double same(double value) { return value; }
double megapascal(double value) { return 1e-6 * value; }

PlatformColumns seasFault(PlatformView const& view)
{
  PlatformColumns columns{{"Slip (m)", "slip", "slip", 0, same},
                          {"Slip rate (log10 m/s)", "slip_rate", "slip_rate", 0, platformLogarithm},
                          {"Shear stress (MPa)", "shear_stress", "traction", 0, megapascal}};
  if (!view.antiplane) {
    columns.push_back({"Normal stress (MPa)", "normal_stress", "normal_stress", 0, megapascal});
  }
  columns.push_back({"State (log10 s)", "state", "theta", 0, platformLogarithm});
  return columns;
}

PlatformColumns seasBody(PlatformView const& view)
{
  if (view.antiplane) {
    return {{"Displacement (m)", "disp", "displacement", 0, same},
            {"Velocity (m/s)", "vel", "velocity", 0, same}};
  }
  return {{"Displacement 1 (m)", "disp_1", "displacement", 0, same},
          {"Displacement 2 (m)", "disp_2", "displacement", 1, same},
          {"Velocity 1 (m/s)", "vel_1", "velocity", 0, same},
          {"Velocity 2 (m/s)", "vel_2", "velocity", 1, same}};
}

PlatformColumns scecFault(PlatformView const& view)
{
  const bool along_strike = view.antiplane || view.is_level;
  const auto along = [&](char const* field) { return along_strike ? field : nullptr; };
  const auto down = [&](char const* field) { return along_strike ? nullptr : field; };
  return {{"horizontal slip (m)", "h-slip", along("slip"), 0, same},
          {"horizontal slip rate (m/s)", "h-slip-rate", along("slip_rate"), 0, same},
          {"horizontal shear stress (MPa)", "h-shear-stress", along("traction"), 0, megapascal},
          {"vertical slip (m)", "v-slip", down("slip"), 0, same},
          {"vertical slip rate (m/s)", "v-slip-rate", down("slip_rate"), 0, same},
          {"vertical shear stress (MPa)", "v-shear-stress", down("traction"), 0, megapascal},
          {"normal stress (MPa)", "n-stress", "normal_stress", 0, megapascal},
          {"log10 of state variable (log-seconds)", "log-theta", "theta", 0, platformLogarithm}};
}

PlatformColumns scecBody(PlatformView const& view)
{
  // The components along strike, vertical and across the fault; -1: none.
  const int h = view.antiplane || view.is_level ? 0 : -1;
  const int v = view.antiplane || view.is_level ? -1 : 1;
  const int n = view.antiplane ? -1 : view.is_level ? 1 : 0;
  const auto column = [](char const* description, char const* name, char const* field,
                         int component) {
    return PlatformColumn{description, name, component < 0 ? nullptr : field,
                          std::max(component, 0), same};
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
    row.push_back(column.convert(values[station * components + column.component]));
  }
  return row;
}
} // namespace asperity::io::detail

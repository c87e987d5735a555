#include "platforms/parts/Columns.hpp"

#include "catalogue/fault_geometry/FaultPlaces.hpp"
#include "platforms/TextFile.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::platforms
{
double unchanged(double value) { return value; }
double megapascal(double value) { return 1e-6 * value; }
double logarithmOfSize(double value) { return decimalLogarithm(std::abs(value)); }

ModelView ModelView::of(io::OutputContext const& context)
{
  ModelView view;
  auto const& fault = context.domain("fault");
  if (!fault.isCurve()) {
    view.plane = catalogue::faultPlane(fault, context.up);
    return view;
  }
  view.antiplane = context.fields.field("volume", "displacement").components == 1;
  const auto axis = catalogue::faultAxis(fault);
  view.is_level = axis.is_level;
  if (!view.antiplane && !axis.is_level && axis.tangent_rises == fault.is_foot_wall) {
    view.thrust_sign = -1;
  }
  return view;
}

std::vector<std::string> fieldsOf(Columns const& columns)
{
  std::vector<std::string> fields;
  for (auto const& column : columns) {
    if (column.field && std::find(fields.begin(), fields.end(), column.field) == fields.end()) {
      fields.emplace_back(column.field);
    }
  }
  return fields;
}

std::vector<double> rowOf(Columns const& columns,
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
} // namespace asperity::platforms

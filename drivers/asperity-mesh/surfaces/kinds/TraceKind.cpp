#include "surfaces/DippingSurface.hpp"
#include "surfaces/Lofting.hpp"
#include "surfaces/TraceFile.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/Units.hpp"

#include "base/Errors.hpp"
#include "parameters/fields/Field.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr char const* trace_file = "Trace File";
constexpr char const* trace_name = "Trace";
constexpr char const* upper_depth = "Upper Depth";
constexpr char const* dip_name = "Dip";
constexpr char const* dip_direction = "Dip Direction";

Teuchos::RCP<const ParameterList> traceEntries()
{
  Declare declare;
  declare
    .fileName(trace_file, optional,
              "The points of the trace are in this file, a line for each; 'Trace Columns' says "
              "what stands there.")
    .choice("Trace Columns", "x y", traceColumns(),
            "Says what the columns of the file are; dips are in degrees.")
    .realArray(trace_name, optional, "m, km or deg", Range::any(),
               "The trace has these points: x and y of the first one, of the second one, and so "
               "on.")
    .field(dip_name, optional, "deg", Range::open(0, 180),
           "The surface has this dip below the trace, to the right of someone who walks along it; "
           "more than 90 is a dip to the left. A formula in x, y and z [m] of points of the trace "
           "makes it vary along strike.")
    .withoutDatasets()
    .real(dip_direction, optional, "deg", Range::closed(-360, 360),
          "The surface dips everywhere along this azimuth, clockwise from y, instead of at right "
          "angles to the trace.")
    .real("Depth", required, "m", Range::any(), "The lower edge lies at z = -Depth.")
    .real(upper_depth, optional, "m", Range::any(),
          "The upper edge lies at z = -Upper Depth, on the surface through the trace.")
    .real("Spacing", 0., "m", Range::atLeast(0),
          "Points of the surface have at most this spacing; 0 makes it a tenth of the width down "
          "dip.");
  declareExtendUp(declare, true);
  return Units::declare(declare).list();
}

Polyline pointsOf(Teuchos::Array<double> const& numbers, std::string const& path)
{
  ASPERITY_REQUIRE(numbers.size() >= 4 && numbers.size() % 2 == 0,
                   joinPath(path, trace_name)
                     << " has " << numbers.size()
                     << " numbers; x and y of two or more points are needed.");
  Polyline points;
  for (int i = 0; i < numbers.size(); i += 2) {
    points.push_back({numbers[i], numbers[i + 1], 0});
  }
  return points;
}

TraceFile traceOf(ParameterList const& list, std::string const& path, SurfaceContext const& context)
{
  const bool has_file = isGiven(list, trace_file);
  ASPERITY_REQUIRE(has_file != isGiven(list, trace_name),
                   path << " needs either " << trace_file << " or " << trace_name << ".");
  return has_file
           ? readTrace(fileOf(list, trace_file, context), list.get<std::string>("Trace Columns"))
           : TraceFile{pointsOf(list.get<Teuchos::Array<double>>(trace_name), path), {}};
}

// z of a trace is in m, unless a file has it.
Units unitsOf(ParameterList const& list, std::string const& path, SurfaceContext const& context)
{
  const bool has_z = isGiven(list, trace_file) &&
                     list.get<std::string>("Trace Columns").find('z') != std::string::npos;
  return has_z ? Units::read(list, path, context)
               : Units(list.get<std::string>("Units"), 1, path, context);
}

std::vector<double> dipsOf(ParameterList const& list, TraceFile const& trace,
                           std::string const& path)
{
  ASPERITY_REQUIRE(trace.dips.empty() == isGiven(list, dip_name),
                   path << (trace.dips.empty() ? " has no dip. Give Dip, or a column of the file "
                                                 "and Trace Columns."
                                               : " has Dip and a column of dips. Remove one."));
  if (!trace.dips.empty()) {
    return trace.dips;
  }
  const Field dip(list, dip_name, path, {"surface"});
  std::vector<double> dips;
  for (auto const& point : trace.points) {
    dips.push_back(dip(point, 0, 0));
  }
  return dips;
}

TriangleSurface makeTrace(ParameterList const& list, std::string const& path,
                          SurfaceContext const& context)
{
  auto trace = traceOf(list, path, context);
  unitsOf(list, path, context).toModel(trace.points);
  DippingTrace given;
  given.dips = dipsOf(list, trace, path);
  given.trace = std::move(trace.points);
  if (isGiven(list, dip_direction)) {
    given.dip_direction = list.get<double>(dip_direction);
  }
  given.lower_z = -list.get<double>("Depth");
  given.spacing = list.get<double>("Spacing");
  given.upper_z = 0;
  for (auto const& point : given.trace) {
    given.upper_z = std::max(given.upper_z, point[2]);
  }
  if (isGiven(list, upper_depth)) {
    given.upper_z = -list.get<double>(upper_depth);
  } else if (list.get<bool>("Extend Up")) {
    given.upper_z = std::max(given.upper_z, aboveGround(given.lower_z, context));
  }
  return dippingSurface(given, path);
}

class TraceKind final : public SurfaceKind
{
public:
  std::vector<std::string> sources() const override { return {trace_file, trace_name}; }
  std::string fileEntry() const override { return trace_file; }
  FileFit fit(std::string const& /*file_name*/) const override { return FileFit::possible; }
  Teuchos::RCP<const ParameterList> entries() const override { return traceEntries(); }
  TriangleSurface make(ParameterList const& list, std::string const& path,
                       SurfaceContext const& context) const override
  {
    return makeTrace(list, path, context);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceKindRegistry, "Trace", TraceKind)
} // namespace asperity::geometry

#include "surfaces/Projection.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <cmath>
#include <regex>

#ifdef ASPERITY_HAVE_PROJ
#include <proj.h>
#endif

namespace asperity::geometry
{
#ifdef ASPERITY_HAVE_PROJ
namespace
{
// "utm11s" in PROJ's words; others as they are. PROJ takes a text that begins with + for a step of
// a pipeline unless it says that it is a coordinate system.
std::string coordinateSystem(std::string const& definition)
{
  static const std::regex utm("utm *([0-9]{1,2}) *([ns]?)", std::regex::icase);
  std::smatch match;
  std::string text = trimmed(definition);
  if (std::regex_match(text, match, utm)) {
    const std::string hemisphere = match[2];
    text = "+proj=utm +zone=" + match[1].str() +
           (hemisphere == "s" || hemisphere == "S" ? " +south" : "") + " +datum=WGS84";
  }
  const bool is_proj = text.find("+proj") != std::string::npos;
  return is_proj && text.find("+type=crs") == std::string::npos ? text + " +type=crs" : text;
}

using Object = std::unique_ptr<PJ, decltype(&proj_destroy)>;
Object owned(PJ* object) { return {object, &proj_destroy}; }
} // namespace

struct Projection::Transformation
{
  std::unique_ptr<PJ_CONTEXT, decltype(&proj_context_destroy)> context{proj_context_create(),
                                                                       &proj_context_destroy};
  Object object{nullptr, &proj_destroy};
  double unit = 1; // [m] of projected coordinates

  std::string reason() const
  {
    const int error = proj_context_errno(context.get());
    return error == 0
             ? ""
             : std::string(" PROJ says: ") + proj_context_errno_string(context.get(), error) + ".";
  }

  // The unit of a system of two axes in a plane; 0 if they are angles.
  double unitOf(PJ const* system) const
  {
    const auto axes = owned(proj_crs_get_coordinate_system(context.get(), system));
    double factor = 0;
    char const* name = nullptr;
    if (!axes || proj_cs_get_axis_info(context.get(), axes.get(), 0, nullptr, nullptr, nullptr,
                                       &factor, &name, nullptr, nullptr) == 0) {
      return 0;
    }
    return std::string(name).find("degree") == std::string::npos ? factor : 0;
  }
};

Projection::Projection(std::string const& definition, std::string const& path)
    : transformation_(std::make_unique<Transformation>())
    , where_(path + " = '" + definition + "'")
{
  auto& t = *transformation_;
  proj_log_level(t.context.get(), PJ_LOG_NONE);
  const std::string text = coordinateSystem(definition);
  const std::string advice = " Write for example 'utm11', 'EPSG:32611' or '+proj=tmerc "
                             "+lat_0=45.5 +lon_0=-122.7 +datum=WGS84'.";
  const auto system = owned(proj_create(t.context.get(), text.c_str()));
  ASPERITY_REQUIRE(system && proj_is_crs(system.get()),
                   where_ << " is no coordinate system." << t.reason() << advice);
  t.unit = t.unitOf(system.get());
  ASPERITY_REQUIRE(t.unit > 0, where_ << " is no projection to a plane: its coordinates are no "
                                         "lengths."
                                      << advice);
  const auto raw = owned(proj_create_crs_to_crs(
    t.context.get(), "+proj=longlat +datum=WGS84 +type=crs", text.c_str(), nullptr));
  t.object = owned(raw ? proj_normalize_for_visualization(t.context.get(), raw.get()) : nullptr);
  ASPERITY_REQUIRE(t.object,
                   where_ << " cannot be reached from longitude and latitude." << t.reason());
}

void Projection::toPlane(std::vector<std::array<double, 3>>& points) const
{
  for (auto& point : points) {
    const auto [x, y, z] = point;
    const auto projected =
      proj_trans(transformation_->object.get(), PJ_FWD, proj_coord(x, y, 0, HUGE_VAL));
    point = {projected.xy.x * transformation_->unit, projected.xy.y * transformation_->unit, z};
    ASPERITY_REQUIRE(std::isfinite(point[0]) && std::isfinite(point[1]),
                     where_ << " cannot project longitude " << formatShort(x) << ", latitude "
                            << formatShort(y)
                            << ". Are these degrees, and the longitude before the latitude?");
  }
}

void Projection::toGeographic(std::vector<std::array<double, 3>>& points) const
{
  for (auto& point : points) {
    const auto [x, y, z] = point;
    const double unit = transformation_->unit;
    const auto place = proj_trans(transformation_->object.get(), PJ_INV,
                                  proj_coord(x / unit, y / unit, 0, HUGE_VAL));
    point = {place.xy.x, place.xy.y, z};
    ASPERITY_REQUIRE(std::isfinite(point[0]) && std::isfinite(point[1]),
                     where_ << " has no longitude and latitude for x = " << formatShort(x)
                            << " m, y = " << formatShort(y)
                            << " m. Is this point too far from the middle of the projection?");
  }
}

bool Projection::isAvailable() { return true; }
#else
struct Projection::Transformation
{
};

Projection::Projection(std::string const& definition, std::string const& path)
{
  throw InputError(path + " = '" + definition +
                   "': this build has no projections. Build it with the PROJ library (on Debian "
                   "libproj-dev), or give coordinates in metres.");
}
void Projection::toPlane(std::vector<std::array<double, 3>>& /*points*/) const {}
void Projection::toGeographic(std::vector<std::array<double, 3>>& /*points*/) const {}
bool Projection::isAvailable() { return false; }
#endif

Projection::~Projection() = default;
Projection::Projection(Projection&&) noexcept = default;
Projection& Projection::operator=(Projection&&) noexcept = default;
} // namespace asperity::geometry

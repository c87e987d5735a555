#pragma once

#include "surfaces/TriangleSurface.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

#include "parameters/Parameters.hpp"
#include "registry/Registry.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// Whether a file can be the source of a kind of surface, by the file's name.
enum class FileFit
{
  none,
  possible, // as far as the name tells
  certain   // the extension is that of a format of this kind alone
};

// A kind of surface that a deck has, by the word of `Type`. Registered under that word at the end
// of the kind's file, which is all that the kind needs:
//   ASPERITY_REGISTER(SurfaceKindRegistry, "Trace", TraceKind)
class SurfaceKind
{
public:
  static constexpr char const* registered_as = "kind of surface";
  SurfaceKind() = default;
  virtual ~SurfaceKind() = default;
  SurfaceKind(SurfaceKind const&) = delete;
  SurfaceKind& operator=(SurfaceKind const&) = delete;

  // The entries of which one is given and says where the surface comes from.
  virtual std::vector<std::string> sources() const = 0;
  // The one of them that names a file; "" if none does.
  virtual std::string fileEntry() const = 0;
  // Whether that file may have this name.
  virtual FileFit fit(std::string const& file_name) const = 0;

  virtual Teuchos::RCP<const ParameterList> entries() const = 0;

  // list: complete; path: where it stands, for messages. InputError if files or numbers make no
  // surface.
  virtual TriangleSurface make(ParameterList const& list, std::string const& path,
                               SurfaceContext const& context) const = 0;
};
using SurfaceKindRegistry = Registry<SurfaceKind>;
} // namespace asperity::geometry

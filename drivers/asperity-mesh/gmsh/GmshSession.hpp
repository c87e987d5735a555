#pragma once

#include <functional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// Starts Gmsh's library, with its defaults and without the user's option files, and ends it. Only
// one object may exist at a time, because the library has global data. Options do not pass from one
// object to the next.
class GmshSession
{
public:
  // `arguments` as those of Gmsh's program. What Gmsh tells goes to the terminal if `is_loud`.
  explicit GmshSession(bool is_loud, std::vector<std::string> const& arguments = {});
  ~GmshSession();
  GmshSession(GmshSession const&) = delete;
  GmshSession& operator=(GmshSession const&) = delete;

  // InputError, which starts with `where`, if Gmsh cannot read the file.
  void open(std::string const& file_name, std::string const& where) const;
};

// What Gmsh's library throws, which before version 4.9 is strings; "" if that is nothing. An
// InputError is not caught.
std::string errorOfGmsh(std::function<void()> const& call);

// Gmsh's numbers of the types of elements.
constexpr int type_segment = 1, type_triangle = 2, type_tetrahedron = 4, type_point = 15;

// "Point", "Curve", "Surface", "Volume", as Gmsh's own interface calls entities.
char const* entityName(int dimension);
} // namespace asperity::geometry

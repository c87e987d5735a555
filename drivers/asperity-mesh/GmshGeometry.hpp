#pragma once

#include <string>
#include <vector>

// A geometry of Gmsh, a script whose file name ends in .geo, which is meshed before it is read.

bool isGeometry(std::string const& file_name);

// A number of the script that the command line replaces: one of its DefineConstant.
struct GeometryConstant
{
  std::string name;
  double value;
};

// The names that the script, which is without comments, defines by DefineConstant[name = value,
// name = {value, ...}, ...], in their order, each once.
std::vector<std::string> constantsOf(std::string const& script);

// The constants from "NAME=VALUE" each. InputError, with the nearest name, if the script does not
// define one of them, if a value is no number, or if a name is given twice; and if the file cannot
// be read, or it or a script that it includes runs programs (SystemCall).
std::vector<GeometryConstant> readConstants(std::string const& file_name,
                                            std::vector<std::string> const& settings);

// Meshes the geometry that Gmsh's library has opened, in its own dimension, 2 or 3. InputError,
// which starts with `where` and has Gmsh's last error, if that fails.
void meshGeometry(std::string const& where);

// "" if there is no error. Call gmsh::initialize before.
std::string lastErrorOfGmsh();

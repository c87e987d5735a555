#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

// A geometry of Gmsh, a script whose file name ends in .geo, which is meshed before it is read.

bool isGeometry(std::string const& file_name);

// The constants, by their names, from "NAME=VALUE" each: numbers that replace those of the script's
// DefineConstant[name = value, name = {value, ...}, ...]. InputError, with the nearest name, if the
// script does not define one of them, if a value is no number, or if a name is given twice; and if
// the file cannot be read, or it or a script that it includes runs programs (SystemCall).
std::map<std::string, double> readConstants(std::string const& file_name,
                                            std::vector<std::string> const& settings);

// Meshes the geometry that Gmsh's library has opened, in its own dimension, 2 or 3. InputError,
// which starts with `where` and has Gmsh's last error, if that fails.
void meshGeometry(std::string const& where);

// What Gmsh's library throws, which before version 4.9 is strings; "" if that is nothing.
std::string errorOfGmsh(std::function<void()> const& call);

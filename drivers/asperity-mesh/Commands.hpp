#pragma once

#include <string>
#include <vector>

// The commands of asperity-mesh; `words` are the arguments after the name of the command.
// InputError if an argument, or a file that it names, is wrong.

void printHelp();

// IN.msh or IN.geo OUT.h5 [--overwrite] [--set NAME=VALUE]...
void convert(std::vector<std::string> const& words);

// OUT.h5 [--overwrite] [--periodic] [--<parameter> VALUE]...
void makeWedge(std::vector<std::string> const& words);
std::string wedgeOptions(); // the parameters for --help, a line each

// OUT.h5 [--overwrite] [--<parameter> VALUE]...
void makeRectangle(std::vector<std::string> const& words);
std::string rectangleOptions();

// OUT.h5 [--overwrite] [--<parameter> VALUE]...
void makeBox(std::vector<std::string> const& words);
std::string boxOptions();

// FILE.h5 --parts N --output OUT.h5 [--boundary NAME] [--boundary-weight W] [--overwrite]
void partition(std::vector<std::string> const& words);

// FILE.h5
void printInfo(std::vector<std::string> const& words);

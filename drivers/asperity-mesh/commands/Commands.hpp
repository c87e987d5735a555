#pragma once

#include "commands/Arguments.hpp"

namespace asperity::geometry
{
// The commands of asperity-mesh, which the table in Commands.cpp describes. InputError if an
// argument, or a file that it names, is wrong.
void build(Arguments& arguments);
void convert(Arguments& arguments);
void makeWedge(Arguments& arguments);
void makeRectangle(Arguments& arguments);
void makeBox(Arguments& arguments);
void partition(Arguments& arguments);
void printInfo(Arguments& arguments);

// Runs the command of the first word with the others. InputError also if there is no such command.
void runCommand(std::vector<std::string> const& words);
void printHelp(); // of all commands
} // namespace asperity::geometry

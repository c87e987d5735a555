#pragma once

#include "Arguments.hpp"

// The commands of asperity-mesh, which main.cpp describes. InputError if an argument, or a file
// that it names, is wrong.
void build(Arguments& arguments);
void convert(Arguments& arguments);
void makeWedge(Arguments& arguments);
void makeRectangle(Arguments& arguments);
void makeBox(Arguments& arguments);
void partition(Arguments& arguments);
void printInfo(Arguments& arguments);

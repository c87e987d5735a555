#include "Commands.hpp"

#include <iostream>

void printHelp()
{
  std::cout
    << "asperity-mesh makes, converts and partitions meshes.\n\n"
       "  asperity-mesh convert IN.msh OUT.h5 [--overwrite]\n"
       "  asperity-mesh convert IN.geo OUT.h5 [--overwrite] [--set NAME=VALUE]...\n"
       "    Converts a mesh of Gmsh, or meshes and converts a geometry of Gmsh; --set "
       "replaces\n"
       "    its numbers of DefineConstant. Physical groups become regions, boundaries and, where\n"
       "    they lie inside, faults. A .geo is a program: take it only from whom you trust.\n"
       "  asperity-mesh wedge OUT.h5 [--overwrite] [OPTION VALUE]...\n"
       "    Makes the subduction wedge of Pipping 2014, A.1, by bisection. Options:\n"
    << wedgeOptions()
    << "  asperity-mesh rectangle OUT.h5 [--overwrite] [OPTION VALUE]...\n"
       "    Makes a rectangle of right triangles, graded by bisection. Options:\n"
    << rectangleOptions()
    << "  asperity-mesh box OUT.h5 [--overwrite] [OPTION VALUE]...\n"
       "    Makes a box of bricks of six tetrahedra each, graded by bisection. Options:\n"
    << boxOptions()
    << "  asperity-mesh partition FILE.h5 --parts N --output OUT.h5 [--overwrite]\n"
       "                [--boundary NAME] [--boundary-weight W]\n"
       "    Divides a mesh, partitioned before or not, into N parts for N ranks, after it has "
       "been\n"
       "    split along its faults.\n"
       "    The parts also get equal shares of the vertices of the boundary, which is the fault; "
       "they\n"
       "    count W times in the balance (4). A mesh that is partitioned again keeps both "
       "options.\n"
       "  asperity-mesh info FILE.h5\n"
       "    Prints counts, sizes, regions, boundaries and faults of a mesh, partitioned or not.\n"
       "    Counts are those after the split along the faults.\n\n"
       "Exit status: 0 done, 2 the input is at fault, 5 a file cannot be written.\n";
}

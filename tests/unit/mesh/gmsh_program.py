"""What Gmsh's own program does: gmsh -2 (or -3) IN.geo [-part N] -o OUT.msh, by its library.

    python3 gmsh_program.py LIBRARY IN.geo OUT.msh [N]
"""

import ctypes
import sys

nothing = None  # where errors would be noted


def main(library, script, target, parts="0"):
    gmsh = ctypes.CDLL(library)
    gmsh.gmshInitialize(0, nothing, 0, nothing, nothing)
    gmsh.gmshOptionSetNumber(b"General.Terminal", ctypes.c_double(0), nothing)
    gmsh.gmshOpen(script.encode(), nothing)
    gmsh.gmshModelMeshGenerate(gmsh.gmshModelGetDimension(nothing), nothing)
    if int(parts) > 0:
        gmsh.gmshModelMeshPartition(int(parts), nothing, 0, nothing, 0, nothing)
    gmsh.gmshWrite(target.encode(), nothing)
    gmsh.gmshFinalize(nothing)


if __name__ == "__main__":
    main(*sys.argv[1:])

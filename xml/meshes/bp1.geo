// SEAS BP1 and BP2: one half of a half space with a vertical strike-slip fault, antiplane.
//
//   asperity-mesh convert bp1.geo bp2.h5 --set h=50
//
// The fault lies at x = 0, the body at x >= 0, and y = -depth. Lengths in m.
//
//   boundaries   top, right, bottom; fault, from the surface down to where slip is imposed, and
//                deep, from there to where the model ends
//
// Down to `fine` the fault has cells of exactly h, and beside it columns of right triangles of the
// width h / sqrt(3). For that width the error of the stress that slip makes is of fourth order in
// h; on cells as wide as high it is of second order, and makes the fault stiffer. Event 1 of BP2
// must die 4 km below the surface, and breaks it where the fault is too stiff by this little.

DefineConstant[
  h = 100,               // size of the cells on the fault
  fine = 40e3,           // depth at which cells begin to grow
  locked = 40e3,         // depth at which `fault` ends and `deep` begins
  columns = 40,          // of width h / sqrt(3)
  width = 1600e3,        // of the model
  depth = 1600e3,
  growth = 0.08,         // of the cells, per length away from the columns
  largest = 160e3        // size of a cell
];

w = columns * h / Sqrt(3);

Point(1) = {0, 0, 0};
Point(2) = {w, 0, 0};
Point(3) = {w, -fine, 0};
Point(4) = {0, -fine, 0};
Point(5) = {0, -depth, 0};
Point(6) = {width, -depth, 0};
Point(7) = {width, 0, 0};

Line(1) = {1, 4};
Line(2) = {4, 3};
Line(3) = {3, 2};
Line(4) = {2, 1};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 2};
If (locked > fine)
  Point(8) = {0, -locked, 0};
  Line(8) = {4, 8};
  Line(9) = {8, 5};
  Curve Loop(1) = {-2, 8, 9, 5, 6, 7, -3};
  Physical Curve("fault") = {1, 8};
Else
  Line(9) = {4, 5};
  Curve Loop(1) = {-2, 9, 5, 6, 7, -3};
  Physical Curve("fault") = {1};
EndIf
Curve Loop(2) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Plane Surface(2) = {2};

Physical Curve("deep") = {9};
Physical Curve("top") = {4, 7};
Physical Curve("right") = {6};
Physical Curve("bottom") = {5};
Physical Surface("body") = {1, 2};

Transfinite Curve {1, 3} = Round(fine / h) + 1;
Transfinite Curve {2, 4} = columns + 1;
Transfinite Surface {2} = {1, 4, 3, 2};

// Cells grow with the distance from the columns.
Field[1] = MathEval;
Field[1].F = Sprintf("Min(%.16g,%.16g+%.16g*Sqrt(Max(x-%.16g,0)^2+Max(-y-%.16g,0)^2))",
                     largest, h, growth, w, fine);
Background Field = 1;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;

// SEAS BP3: a half space with a planar fault that dips from the surface at the origin.
//
//   asperity-mesh convert bp3.geo bp3_60.h5 --set dip=60
//
// The x axis lies along the surface and y points upwards; the fault dips to the right, so that the
// hanging wall, its plus side, lies there. With d = dip, x_d = x cos(d) - y sin(d) is the distance
// down dip. Lengths in m, angles in degrees.
//
//   boundaries   surface, left, right, bottom
//   faults       fault, from the surface down to where slip is imposed, and deep, from there to
//                where the model ends
//   regions      hanging, foot
//
// On the fault cells are exactly h long down to `fine`; from there on they grow by `fault_growth`
// per length along the fault and by `growth` per length away from it, up to `largest`. Beside the
// fault lie two strips of triangles in rows, mirror images of each other, whose cells are h wide at
// the fault and wider by the factor `across` from column to column: where cells on the two sides
// are not mirror images, slip that changes from node to node changes the normal stress, and where
// they lie without order, slip makes shear stress that it should not; both move events of BP3 by
// years. The strips begin `top` below the surface and become wider with depth.

DefineConstant[
  dip = 60,             // of the fault, between 0 and 90
  h = 100,              // size of the cells on the fault
  fine = 20e3,          // down dip, where cells begin to grow
  locked = 40e3,        // down dip, where `fault` ends and `deep` begins
  top = 4e3,            // down dip, where the strips beside the fault begin
  narrow = 1.5e3,       // largest width of a strip there
  wide = 8e3,           // and at `fine`
  across = 1.08,        // -, widths of neighbouring cells across a strip
  half_width = 800e3,   // the model reaches so far to the left and to the right of the origin
  depth = 600e3,        // and so deep
  fault_growth = 0.02,  // -, at most growth
  growth = 0.08,        // -
  largest = 80e3        // size of a cell
];

c = Cos(dip * Pi / 180);
s = Sin(dip * Pi / 180);
If (dip <= 0 || dip > 90)
  Error("dip = %g, which has to be above 0 and at most 90 degrees", dip);
  Abort;
EndIf
// The upper strip stays below the surface.
If (dip < 90)
  narrow = Min(narrow, 0.7 * top * s / c);
  wide = Min(wide, 0.7 * fine * s / c);
EndIf
columns = Round(Log(1 + (across - 1) * wide / h) / Log(across));
// Where the fault leaves the model: through the bottom or, if its dip is small, through the right.
through_bottom = depth * c < half_width * s;
If (through_bottom)
  end = depth / s;
Else
  end = half_width / c;
EndIf

Point(1) = {0, 0, 0};
Point(2) = {fine * c, -fine * s, 0};
Point(3) = {locked * c, -locked * s, 0};
Point(4) = {end * c, -end * s, 0};
Point(5) = {-half_width, 0, 0};
Point(6) = {-half_width, -depth, 0};
Point(7) = {half_width, -depth, 0};
Point(8) = {half_width, 0, 0};
Point(9) = {top * c, -top * s, 0};
// The corners of the strips, above and below the fault.
Point(10) = {top * c + narrow * s, -top * s + narrow * c, 0};
Point(11) = {fine * c + wide * s, -fine * s + wide * c, 0};
Point(12) = {top * c - narrow * s, -top * s - narrow * c, 0};
Point(13) = {fine * c - wide * s, -fine * s - wide * c, 0};

Line(1) = {1, 9};
Line(2) = {9, 2};
Line(3) = {2, 3};
Line(4) = {3, 4};
Line(5) = {1, 5};
Line(6) = {5, 6};
Line(7) = {8, 1};
Line(11) = {9, 10};
Line(12) = {10, 11};
Line(13) = {11, 2};
Line(14) = {9, 12};
Line(15) = {12, 13};
Line(16) = {13, 2};
If (through_bottom)
  Line(8) = {6, 4};
  Line(9) = {4, 7};
  Line(10) = {7, 8};
  Curve Loop(1) = {5, 6, 8, -4, -3, -16, -15, -14, -1};
  Curve Loop(2) = {1, 11, 12, 13, 3, 4, 9, 10, 7};
  Physical Curve("bottom") = {8, 9};
  Physical Curve("right") = {10};
Else
  Line(8) = {6, 7};
  Line(9) = {7, 4};
  Line(10) = {4, 8};
  Curve Loop(1) = {5, 6, 8, 9, -4, -3, -16, -15, -14, -1};
  Curve Loop(2) = {1, 11, 12, 13, 3, 4, 10, 7};
  Physical Curve("bottom") = {8};
  Physical Curve("right") = {9, 10};
EndIf
Curve Loop(3) = {2, -13, -12, -11};
Curve Loop(4) = {2, -16, -15, -14};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Plane Surface(4) = {4};

Physical Curve("surface") = {5, 7};
Physical Curve("left") = {6};
Physical Curve("fault") = {1, 2, 3};
Physical Curve("deep") = {4};
Physical Surface("foot") = {1, 4};
Physical Surface("hanging") = {2, 3};

Transfinite Curve {1} = Round(top / h) + 1;
Transfinite Curve {2, 12, 15} = Round((fine - top) / h) + 1;
Transfinite Curve {11, -13, 14, -16} = columns + 1 Using Progression across;
Transfinite Surface {3} = {9, 2, 11, 10} Left;
Transfinite Surface {4} = {9, 2, 13, 12} Left;

// The size on the fault at the place x_d that is nearest, between 0 and `locked`, and the distance
// from there.
nearest = Sprintf("Min(Max(x*(%.16g)-y*(%.16g),0),%.16g)", c, s, locked);
on_fault = Sprintf("%.16g+%.16g*Max(0,", h, fault_growth);
Field[1] = MathEval;
Field[1].F = StrCat(
  on_fault, nearest, Sprintf("-%.16g)", fine), Sprintf("+%.16g*Sqrt(", growth),
  "(x-", Sprintf("%.16g*", c), nearest, ")^2+(y+", Sprintf("%.16g*", s), nearest, ")^2)");
Field[2] = MathEval;
Field[2].F = Sprintf("%.16g", largest);
Field[3] = Min;
Field[3].FieldsList = {1, 2};
Background Field = 3;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;

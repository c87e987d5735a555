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
// per length along the fault and by `growth` per length away from it, up to `largest`.

DefineConstant[
  dip = 60,             // of the fault, between 0 and 90
  h = 100,              // size of the cells on the fault
  fine = 20e3,          // down dip, where cells begin to grow
  locked = 40e3,        // down dip, where `fault` ends and `deep` begins
  half_width = 400e3,   // the model reaches so far to the left and to the right of the origin
  depth = 300e3,        // and so deep
  fault_growth = 0.05,  // -, at most growth
  growth = 0.15,        // -
  largest = 40e3        // size of a cell
];

c = Cos(dip * Pi / 180);
s = Sin(dip * Pi / 180);
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

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {1, 5};
Line(5) = {5, 6};
Line(6) = {8, 1};
If (through_bottom)
  Line(7) = {6, 4};
  Line(8) = {4, 7};
  Line(9) = {7, 8};
  Curve Loop(1) = {4, 5, 7, -3, -2, -1};
  Curve Loop(2) = {1, 2, 3, 8, 9, 6};
  Physical Curve("bottom") = {7, 8};
  Physical Curve("right") = {9};
Else
  Line(7) = {6, 7};
  Line(8) = {7, 4};
  Line(9) = {4, 8};
  Curve Loop(1) = {4, 5, 7, 8, -3, -2, -1};
  Curve Loop(2) = {1, 2, 3, 9, 6};
  Physical Curve("bottom") = {7};
  Physical Curve("right") = {8, 9};
EndIf
Plane Surface(1) = {1};
Plane Surface(2) = {2};

Physical Curve("surface") = {4, 6};
Physical Curve("left") = {5};
Physical Curve("fault") = {1, 2};
Physical Curve("deep") = {3};
Physical Surface("foot") = {1};
Physical Surface("hanging") = {2};

Transfinite Curve {1} = Round(fine / h) + 1;

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

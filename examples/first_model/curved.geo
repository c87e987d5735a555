// A thrust fault that flattens with depth, for curved.xml, described in the manual.
//
//   asperity-mesh convert curved.geo curved.h5 --set h=250
//
// x points to the right, y up; the fault reaches the surface at the origin and dips to the right.
// Lengths in m, angles in degrees.

DefineConstant[
  surface_dip = 60,
  deep_dip = 30,        // at fault_depth and below
  fault_depth = 20e3,   // there the arc ends and a straight line goes on
  h = 250               // size of the cells on the arc
];
left = 60e3;
right = 100e3;
depth = 50e3;

// The arc has its centre above the surface.
s0 = Sin(surface_dip * Pi / 180);
c0 = Cos(surface_dip * Pi / 180);
s1 = Sin(deep_dip * Pi / 180);
c1 = Cos(deep_dip * Pi / 180);
radius = fault_depth / (c1 - c0);
end = radius * (s0 - s1);
Point(1) = {0, 0, 0};
Point(2) = {radius * s0, radius * c0, 0};
Point(3) = {end, -fault_depth, 0};
Circle(1) = {1, 2, 3};

// The straight line leaves through the bottom.
Point(4) = {end + (depth - fault_depth) * c1 / s1, -depth, 0};
Line(2) = {3, 4};

Point(5) = {-left, 0, 0};
Point(6) = {-left, -depth, 0};
Point(7) = {right, -depth, 0};
Point(8) = {right, 0, 0};
Line(3) = {1, 5};
Line(4) = {5, 6};
Line(5) = {6, 4};
Line(6) = {4, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Curve Loop(1) = {3, 4, 5, -2, -1};
Curve Loop(2) = {1, 2, 6, 7, 8};
Plane Surface(1) = {1};
Plane Surface(2) = {2};

Physical Surface("foot") = {1};
Physical Surface("hanging") = {2};
Physical Curve("fault") = {1};
Physical Curve("deep") = {2};
Physical Curve("surface") = {3, 8};
Physical Curve("left") = {4};
Physical Curve("bottom") = {5, 6};
Physical Curve("right") = {7};

// Cells have the size h on the arc and grow with the distance from it.
Transfinite Curve {1} = Ceil(radius * (surface_dip - deep_dip) * Pi / 180 / h) + 1;
Field[1] = Distance;
Field[1].CurvesList = {1};
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.1 * F1", h);
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

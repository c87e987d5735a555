// Two vertical strike-slip faults that cross along a vertical line, in a box.
//
//   asperity-mesh convert conjugate_3d.geo conjugate_3d.h5 --set h=800
//
// x points along the largest horizontal compression, z up. The faults strike at `angle` to either
// side of x, cross along x = y = 0 and reach the surface z = 0. They reach as far from the line as
// `right_west` and so on say, and down to their depths: that of left_lateral has to be the smaller
// one, so that the line ends at its lower edge. With left_east = 0 left_lateral ends at the line: it
// is a branch. Lengths in m, angles in degrees.
//
//   boundaries   surface, bottom, west, east, south, north
//   faults       right_lateral, which strikes from the south west to the north east, and
//                left_lateral, from the north west to the south east
//   region       rock
//
// Cells have the size h on the faults and grow by `growth` per length away from them, up to
// `largest`.

DefineConstant[
  h = 800,              // size of the cells on the faults
  angle = 30,           // of the faults to x
  right_west = 28e3,
  right_east = 3e3,
  right_depth = 20e3,
  left_west = 15e3,
  left_east = 15e3,
  left_depth = 18e3,
  half_width = 50e3,    // of the body, along x and along y
  depth = 40e3,         // of the body
  growth = 0.2,         // -
  largest = 12e3        // size of a cell
];

c = Cos(angle * Pi / 180);
s = Sin(angle * Pi / 180);

// The line, and its continuation on the deeper fault.
Point(1) = {0, 0, 0};
Point(2) = {0, 0, -left_depth};
Point(3) = {0, 0, -right_depth};
Line(1) = {1, 2};
Line(2) = {2, 3};

// The faults, each in two halves.
Point(11) = {-right_west * c, -right_west * s, 0};
Point(12) = {-right_west * c, -right_west * s, -right_depth};
Point(13) = {right_east * c, right_east * s, 0};
Point(14) = {right_east * c, right_east * s, -right_depth};
Line(11) = {1, 11};
Line(12) = {11, 12};
Line(13) = {12, 3};
Line(14) = {1, 13};
Line(15) = {13, 14};
Line(16) = {14, 3};
Curve Loop(11) = {11, 12, 13, -2, -1};
Curve Loop(12) = {14, 15, 16, -2, -1};
Point(21) = {-left_west * c, left_west * s, 0};
Point(22) = {-left_west * c, left_west * s, -left_depth};
Line(21) = {1, 21};
Line(22) = {21, 22};
Line(23) = {22, 2};
Curve Loop(21) = {21, 22, 23, -1};
right() = {11, 12};
left() = {21};
traces() = {11, 14, 21};
If (left_east > 0)
  Point(23) = {left_east * c, -left_east * s, 0};
  Point(24) = {left_east * c, -left_east * s, -left_depth};
  Line(24) = {1, 23};
  Line(25) = {23, 24};
  Line(26) = {24, 2};
  Curve Loop(22) = {24, 25, 26, -1};
  left() += {22};
  traces() += {24};
EndIf
faults() = {right(), left()};
For i In {0 : #faults() - 1}
  Plane Surface(faults(i)) = {faults(i)};
EndFor

// The box.
For i In {0 : 1}
  Point(31 + 4 * i) = {-half_width, -half_width, -i * depth};
  Point(32 + 4 * i) = {half_width, -half_width, -i * depth};
  Point(33 + 4 * i) = {half_width, half_width, -i * depth};
  Point(34 + 4 * i) = {-half_width, half_width, -i * depth};
  Line(31 + 4 * i) = {31 + 4 * i, 32 + 4 * i};
  Line(32 + 4 * i) = {32 + 4 * i, 33 + 4 * i};
  Line(33 + 4 * i) = {33 + 4 * i, 34 + 4 * i};
  Line(34 + 4 * i) = {34 + 4 * i, 31 + 4 * i};
EndFor
For i In {1 : 4}
  Line(40 + i) = {30 + i, 34 + i};
EndFor
Curve Loop(31) = {31, 32, 33, 34};
Curve Loop(32) = {35, 36, 37, 38};
Curve Loop(33) = {31, 42, -35, -41};
Curve Loop(34) = {32, 43, -36, -42};
Curve Loop(35) = {33, 44, -37, -43};
Curve Loop(36) = {34, 41, -38, -44};
For i In {31 : 36}
  Plane Surface(i) = {i};
EndFor
Surface Loop(1) = {31 : 36};
Volume(1) = {1};
Curve{traces()} In Surface{31};
Surface{faults()} In Volume{1};

Physical Surface("surface") = {31};
Physical Surface("bottom") = {32};
Physical Surface("south") = {33};
Physical Surface("east") = {34};
Physical Surface("north") = {35};
Physical Surface("west") = {36};
Physical Surface("right_lateral") = {right()};
Physical Surface("left_lateral") = {left()};
Physical Volume("rock") = {1};

// The square of the distance from a fault: along it beyond its ends, across it, and below it.
right = StrCat(Sprintf("Max(Max(%.16g*x+%.16g*y-%.16g,", c, s, right_east),
               Sprintf("0-%.16g*x-%.16g*y-%.16g),0)^2+", c, s, right_west),
               Sprintf("(%.16g*x-%.16g*y)^2+Max(0-z-%.16g,0)^2", s, c, right_depth));
left = StrCat(Sprintf("Max(Max(%.16g*x-%.16g*y-%.16g,", c, s, left_east),
              Sprintf("%.16g*y-%.16g*x-%.16g),0)^2+", s, c, left_west),
              Sprintf("(%.16g*x+%.16g*y)^2+Max(0-z-%.16g,0)^2", s, c, left_depth));
Field[1] = MathEval;
Field[1].F = StrCat(Sprintf("Min(%.16g,%.16g+%.16g*Sqrt(Min(", largest, h, growth), right, ",",
                    left, ")))");
Background Field = 1;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.Optimize = 1;

// A network of twelve faults in a map: strands of a shear zone, strands across it, branches.
//
//   asperity-mesh convert network.geo network.h5 --set h=300
//
// x points east and y north. The strands run at `strike` from x towards y, which is down to the
// east; points are written in a frame that is turned with them. The conjugate strands lie at
// `between` clockwise from there, so that the largest compression, which bisects that angle, is the
// same for both. Lengths in m, angles in degrees.
//
//   boundaries   bottom, right, top, left
//   faults       main_west, main_middle, main_east, north_west, north_east, south_west, south_east;
//                cross_middle and cross_east, which cross main_middle and main_east;
//                link, from main_west to north_west; branch_north and branch_south, which leave
//                north_east and south_west
//   region       rock
//
// From main_west to main_middle the main strand steps to the right, and from there to main_east to
// the left. A strand that meets another one has a point in common with it, so that each of the two
// is made of two lines. Cells have the size h on all faults and grow by `growth` per length away
// from them, up to `largest`.

DefineConstant[
  h = 300,              // size of the cells on the faults
  strike = -10,         // of the strands
  between = 70,         // from the strands to the conjugate ones
  branch = 20,          // from the strands to the branches
  step = 800,           // width of the two steps of the main strand
  half_width = 50e3,    // of the body
  half_height = 40e3,   // of the body
  growth = 0.15,        // -
  largest = 5e3         // size of a cell
];

c = Cos(between * Pi / 180);
s = Sin(between * Pi / 180);
turn = branch * Pi / 180;
upper = step / 2;       // of main_west and main_east
lower = -step / 2;      // of main_middle

// The strands.
Point(11) = {-17e3, upper, 0};
Point(12) = {-9e3, upper, 0};         // of link
Point(13) = {-5.5e3, upper, 0};
Point(14) = {-6.5e3, lower, 0};
Point(15) = {-1e3, lower, 0};         // of cross_middle
Point(16) = {6e3, lower, 0};
Point(17) = {5e3, upper, 0};
Point(18) = {11e3, upper, 0};         // of cross_east
Point(19) = {16.5e3, upper, 0};
Point(21) = {-13e3, 6e3, 0};
Point(22) = {-9e3 - c / s * (6e3 - upper), 6e3, 0}; // of link
Point(23) = {-4e3, 6e3, 0};
Point(24) = {-1e3, 7e3, 0};
Point(25) = {5.5e3, 7e3, 0};          // of branch_north
Point(26) = {8e3, 7e3, 0};
Point(31) = {-10e3, -7e3, 0};
Point(32) = {-7.5e3, -7e3, 0};        // of branch_south
Point(33) = {-1e3, -7e3, 0};
Point(34) = {2e3, -6e3, 0};
Point(35) = {11e3, -6e3, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {14, 15};
Line(14) = {15, 16};
Line(15) = {17, 18};
Line(16) = {18, 19};
Line(21) = {21, 22};
Line(22) = {22, 23};
Line(23) = {24, 25};
Line(24) = {25, 26};
Line(31) = {31, 32};
Line(32) = {32, 33};
Line(33) = {34, 35};

// The conjugate strands, 4.5 km to either side of a crossing, and the branches.
Point(41) = {-1e3 - 4.5e3 * c, lower + 4.5e3 * s, 0};
Point(42) = {-1e3 + 4.5e3 * c, lower - 4.5e3 * s, 0};
Point(43) = {11e3 - 4.5e3 * c, upper + 4.5e3 * s, 0};
Point(44) = {11e3 + 4.5e3 * c, upper - 4.5e3 * s, 0};
Point(45) = {5.5e3 + 5e3 * Cos(turn), 7e3 + 5e3 * Sin(turn), 0};
Point(46) = {-7.5e3 - 5e3 * Cos(turn), -7e3 - 5e3 * Sin(turn), 0};
Line(41) = {41, 15};
Line(42) = {15, 42};
Line(43) = {43, 18};
Line(44) = {18, 44};
Line(45) = {22, 12};
Line(46) = {25, 45};
Line(47) = {46, 32};
Rotate {{0, 0, 1}, {0, 0, 0}, strike * Pi / 180} { Point{11:19, 21:26, 31:35, 41:46}; }

Point(1) = {-half_width, -half_height, 0};
Point(2) = {half_width, -half_height, 0};
Point(3) = {half_width, half_height, 0};
Point(4) = {-half_width, half_height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
faults() = {11:16, 21:24, 31:33, 41:47};
Curve{faults()} In Surface{1};

Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Curve("main_west") = {11, 12};
Physical Curve("main_middle") = {13, 14};
Physical Curve("main_east") = {15, 16};
Physical Curve("north_west") = {21, 22};
Physical Curve("north_east") = {23, 24};
Physical Curve("south_west") = {31, 32};
Physical Curve("south_east") = {33};
Physical Curve("cross_middle") = {41, 42};
Physical Curve("cross_east") = {43, 44};
Physical Curve("link") = {45};
Physical Curve("branch_north") = {46};
Physical Curve("branch_south") = {47};
Physical Surface("rock") = {1};

Field[1] = Distance;
Field[1].CurvesList = {faults()};
Field[1].NumPointsPerCurve = Ceil(20e3 / h); // two and more for each cell of the longest
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = h;
Field[2].SizeMax = largest;
Field[2].DistMin = 0;
Field[2].DistMax = (largest - h) / growth;
Background Field = 2;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;

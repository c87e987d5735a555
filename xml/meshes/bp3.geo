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
// Down to `fine` the fault has cells of exactly h. Beside it lie rows of triangles, on the two
// sides mirror images of each other, each row shifted along the fault by h/2 from the row before.
// The first row has the height first * h, and each next row is higher by the factor `across`. With
// this shape the shear stress caused by slip is far more accurate than with squares or equilateral
// triangles (tests/verification/fault_stiffness). If the cells on the two sides were not mirror
// images, slip that changes from node to node would change the normal stress; irregular cells would
// cause errors of the shear stress. Such errors shift events of BP3 by years. The rows begin `top`
// down dip. Outside them cells grow by `growth` per length away from the fault and by
// `fault_growth` along it, up to `largest`.

DefineConstant[
  dip = 60,             // of the fault, above 0 and at most 90
  h = 100,              // size of the cells on the fault
  fine = 36e3,          // down dip, where cells begin to grow
  locked = 40e3,        // down dip, where `fault` ends and `deep` begins
  top = (dip < 60 ? 4e3 : 1e3), // down dip, where the rows begin
  wide = (dip < 60 ? 2e3 : 4.1e3), // the rows reach at most this far from the fault
  first = 0.35,         // height of the first row over h
  across = 1.04,        // factor of the height from row to row
  half_width = 2400e3,  // extent of the model to the left and to the right of the origin
  depth = 1800e3,       // of the model
  fault_growth = 0.01,  // -, at most growth
  growth = 0.05,        // -
  largest = 240e3       // size of a cell
];

c = Cos(dip * Pi / 180);
s = Sin(dip * Pi / 180);
If (dip <= 0 || dip > 90)
  Error("dip = %g, which has to be above 0 and at most 90 degrees", dip);
  Abort;
EndIf
// As many rows as fit into `wide`, and whose outer corner above the fault, `along` down dip of
// where they begin, uses at most four fifths of the depth there.
rows = 1;
away = first * h;
fits = 1;
For row In {2:1000}
  next_away = away + first * h * across^(row - 1);
  along = row * h / 2;
  If (fits == 1 && next_away <= wide && next_away * c <= 0.8 * (top + along) * s)
    rows = row;
    away = next_away;
  Else
    fits = 0;
  EndIf
EndFor
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
start = 1;
If (top > 0)
  Point(9) = {top * c, -top * s, 0};
  start = 9;
EndIf
Line(2) = {start, 2};
Line(3) = {2, 3};
Line(4) = {3, 4};
Line(5) = {1, 5};
Line(6) = {5, 6};
Line(7) = {8, 1};

upper_fault() = {};
upper_fault_back() = {};
If (top > 0)
  Line(1) = {1, 9};
  upper_fault() = {1};
  upper_fault_back() = {-1};
  Transfinite Curve {1} = Round(top / h) + 1;
EndIf
If (through_bottom)
  Line(8) = {6, 4};
  Line(9) = {4, 7};
  Line(10) = {7, 8};
  below_foot() = {8};
  beyond_fault() = {9, 10};
  Physical Curve("bottom") = {8, 9};
  Physical Curve("right") = {10};
Else
  Line(8) = {6, 7};
  Line(9) = {7, 4};
  Line(10) = {4, 8};
  below_foot() = {8, 9};
  beyond_fault() = {10};
  Physical Curve("bottom") = {8};
  Physical Curve("right") = {9, 10};
EndIf

// The ends of the rows, above the fault (side = 1) and below it (side = -1), where the rows begin
// and at `fine`: a point for each row. The lists `..._back` lead towards the fault.
For upper In {0:1}
  side = 2 * upper - 1;
  For lower In {0:1}
    at = (lower == 1 ? fine : top);
    last = (lower == 1 ? 2 : start);
    out() = {};
    back() = {};
    For row In {1:rows}
      x = at + row * h / 2;
      n = side * first * h * (across^row - 1) / (across - 1);
      next = newp;
      Point(next) = {x * c + n * s, -x * s + n * c, 0};
      step = newl;
      Line(step) = {last, next};
      out() = {out(), step};
      back() = {-step, back()};
      last = next;
    EndFor
    If (upper == 1 && lower == 0)
      up_begin() = out(); up_begin_back() = back(); up_begin_corner = last;
    ElseIf (upper == 1)
      up_end() = out(); up_end_back() = back(); up_end_corner = last;
    ElseIf (lower == 0)
      down_begin() = out(); down_begin_back() = back(); down_begin_corner = last;
    Else
      down_end() = out(); down_end_back() = back(); down_end_corner = last;
    EndIf
  EndFor
EndFor
up_far = newl;
Line(up_far) = {up_begin_corner, up_end_corner};
down_far = newl;
Line(down_far) = {down_begin_corner, down_end_corner};

// The rest of foot wall and hanging wall, and the rows above and below the fault.
Curve Loop(1) = {5, 6, below_foot(), -4, -3, down_end(), -down_far, down_begin_back(),
                 upper_fault_back()};
Curve Loop(2) = {7, upper_fault(), up_begin(), up_far, up_end_back(), 3, 4, beyond_fault()};
Curve Loop(3) = {2, up_end(), -up_far, up_begin_back()};
Curve Loop(4) = {2, down_end(), -down_far, down_begin_back()};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Plane Surface(4) = {4};

Physical Curve("surface") = {5, 7};
Physical Curve("left") = {6};
Physical Curve("fault") = {upper_fault(), 2, 3};
Physical Curve("deep") = {4};
Physical Surface("foot") = {1, 4};
Physical Surface("hanging") = {2, 3};

Transfinite Curve {2, up_far, down_far} = Round((fine - top) / h) + 1;
Transfinite Curve {up_begin(), up_end(), down_begin(), down_end()} = 2;
Transfinite Surface {3} = {start, 2, up_end_corner, up_begin_corner} Left;
Transfinite Surface {4} = {start, 2, down_end_corner, down_begin_corner} Left;

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

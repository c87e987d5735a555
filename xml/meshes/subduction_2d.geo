// A subduction zone: an oceanic plate that bends under a continent.
//
//   asperity-mesh convert subduction_2d.geo subduction_2d.h5 --set h=500
//
// The x axis lies along the surface, from the ocean at the left to the continent at the right, and y
// points upwards. The interface reaches the surface at the trench, x = y = 0, with `trench_dip` and
// steepens in proportion to its depth to `deep_dip` at `locked_depth`; below it is straight. The
// continent, above, is its plus side. Lengths in m, angles in degrees.
//
//   boundaries   surface, left, right, bottom
//   faults       megathrust, from the trench to locked_depth, and deep, from there to where the
//                model ends; splay, if there is one (splay_2d.geo)
//   regions      ocean, continent, and with a splay prism, between trench and splay
//
// Cells are h long on the megathrust and the splay, and grow by `growth` per length away from them.

DefineConstant[
  trench_dip = 8,
  deep_dip = 25,
  locked_depth = 40e3,
  h = 500,              // size of the cells on the megathrust
  left = 300e3,         // extent of the model to the left of the trench
  right = 500e3,        // to the right
  depth = 300e3,        // and in depth
  growth = 0.15,        // -
  largest = 30e3,       // size of a cell
  splay = 0,            // 1: there is a splay
  splay_depth = 12e3,   // where it branches off the megathrust
  splay_dip = 35        // it is straight
];

// Points along the megathrust, at distances of `step`. The last step before the branch and before
// the end is between half as long and 1.5 times as long, so that a point lies exactly there.
step = 1000;
px = 0;
py = 0;
angle = trench_dip * Pi / 180;
bend = (deep_dip - trench_dip) * Pi / 180 / locked_depth;
points[] = {};
branch = -1; // place of the branch among the points
p = newp;
Point(p) = {0, 0, 0};
points[] += p;
For i In {1 : 10000}
  If (-py < locked_depth - 1e-6)
    // Midpoint rule; `target` is the depth that the step may not pass.
    target = locked_depth;
    If (splay && branch < 0)
      target = splay_depth;
    EndIf
    middle = angle + bend * (-py + 0.5 * step * Sin(angle + bend * (-py)));
    length = step;
    // No piece is shorter than half a step.
    If (-py + 1.5 * step * Sin(middle) >= target)
      length = (target + py) / Sin(middle);
    EndIf
    px += length * Cos(middle);
    py -= length * Sin(middle);
    p = newp;
    Point(p) = {px, py, 0};
    points[] += p;
    If (splay && branch < 0 && -py >= splay_depth - 1e-6)
      branch = #points[] - 1;
      branch_x = px;
    EndIf
  EndIf
EndFor
n = #points[];

// Where the straight part leaves the model.
slope = Tan(deep_dip * Pi / 180);
through_bottom = (depth + py) / slope < right - px;
p_end = newp;
If (through_bottom)
  Point(p_end) = {px + (depth + py) / slope, -depth, 0};
Else
  Point(p_end) = {right, py - (right - px) * slope, 0};
EndIf
p_left = newp;
Point(p_left) = {-left, 0, 0};
p_low_left = newp;
Point(p_low_left) = {-left, -depth, 0};
p_low_right = newp;
Point(p_low_right) = {right, -depth, 0};
p_right = newp;
Point(p_right) = {right, 0, 0};

// The interface, downwards.
If (splay)
  thrust_1 = newl;
  Spline(thrust_1) = points[{0 : branch}];
  thrust_2 = newl;
  Spline(thrust_2) = points[{branch : n - 1}];
  thrust[] = {thrust_1, thrust_2};
Else
  thrust_1 = newl;
  Spline(thrust_1) = points[];
  thrust[] = {thrust_1};
EndIf
deep = newl;
Line(deep) = {points[n - 1], p_end};

// The surface, from the left to the right.
surface_ocean = newl;
Line(surface_ocean) = {p_left, points[0]};
If (splay)
  p_splay = newp;
  Point(p_splay) = {branch_x - splay_depth / Tan(splay_dip * Pi / 180), 0, 0};
  surface_prism = newl;
  Line(surface_prism) = {points[0], p_splay};
  surface_continent = newl;
  Line(surface_continent) = {p_splay, p_right};
  splay_line = newl;
  Line(splay_line) = {p_splay, points[branch]};
  surface[] = {surface_ocean, surface_prism, surface_continent};
Else
  surface_continent = newl;
  Line(surface_continent) = {points[0], p_right};
  surface[] = {surface_ocean, surface_continent};
EndIf

side_left = newl;
Line(side_left) = {p_left, p_low_left};
If (through_bottom)
  bottom_1 = newl;
  Line(bottom_1) = {p_low_left, p_end};
  bottom_2 = newl;
  Line(bottom_2) = {p_end, p_low_right};
  side_right = newl;
  Line(side_right) = {p_low_right, p_right};
  bottom[] = {bottom_1, bottom_2};
  sides[] = {side_right};
  below[] = {side_left, bottom_1};
  beyond[] = {bottom_2, side_right};
Else
  bottom_1 = newl;
  Line(bottom_1) = {p_low_left, p_low_right};
  side_1 = newl;
  Line(side_1) = {p_low_right, p_end};
  side_2 = newl;
  Line(side_2) = {p_end, p_right};
  bottom[] = {bottom_1};
  sides[] = {side_1, side_2};
  below[] = {side_left, bottom_1, side_1};
  beyond[] = {side_2};
EndIf

// Ocean: along the left and the bottom to where the interface ends, up the interface and back.
If (splay)
  Curve Loop(1) = {below[], -deep, -thrust_2, -thrust_1, -surface_ocean};
  Curve Loop(2) = {splay_line, thrust_2, deep, beyond[], -surface_continent};
  Curve Loop(3) = {thrust_1, -splay_line, -surface_prism};
  Plane Surface(3) = {3};
  Physical Surface("prism") = {3};
  Physical Curve("splay") = {splay_line};
Else
  Curve Loop(1) = {below[], -deep, -thrust_1, -surface_ocean};
  Curve Loop(2) = {thrust_1, deep, beyond[], -surface_continent};
EndIf
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Surface("ocean") = {1};
Physical Surface("continent") = {2};
Physical Curve("megathrust") = {thrust[]};
Physical Curve("deep") = {deep};
Physical Curve("surface") = {surface[]};
Physical Curve("left") = {side_left};
Physical Curve("right") = {sides[]};
Physical Curve("bottom") = {bottom[]};

// Distances are measured from points that are as close to each other as the vertices.
Field[1] = Distance;
fine[] = {thrust[]};
If (splay)
  fine[] += {splay_line};
EndIf
Field[1].CurvesList = {fine[]};
Field[1].NumPointsPerCurve = Ceil(2 * locked_depth / Sin(trench_dip * Pi / 180) / h);
Field[2] = MathEval;
Field[2].F = Sprintf("%.16g+%.16g*F1", h, growth);
Field[3] = MathEval;
Field[3].F = Sprintf("%.16g", largest);
Field[4] = Min;
Field[4].FieldsList = {2, 3};
Background Field = 4;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;

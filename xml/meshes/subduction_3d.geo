// A subduction zone with its coast: the section of subduction_2d.geo, `width` wide along z.
//
//   asperity-mesh convert subduction_3d.geo subduction_3d.h5 --set h=4e3
//
// The x axis points from the ocean to the continent, y upwards, and z along the trench. The interface
// reaches the surface at the trench, x = y = 0, with `trench_dip` and steepens in proportion to its
// depth to `deep_dip` at `locked_depth`; below it is straight. The continent, above, is its plus side.
// Lengths in m, angles in degrees.
//
//   boundaries   surface, left, right, bottom, front (z = 0), back (z = width)
//   faults       megathrust, from the trench to locked_depth, and deep, from there to where the
//                model ends
//   regions      ocean, continent
//
// Cells are h long on the megathrust and grow by `growth` per length away from it.

DefineConstant[
  trench_dip = 8,
  deep_dip = 25,
  locked_depth = 40e3,
  width = 200e3,
  h = 4e3,              // size of the cells on the megathrust
  left = 150e3,         // extent of the model to the left of the trench
  right = 350e3,        // to the right
  depth = 150e3,        // and in depth
  growth = 0.35,        // -
  largest = 40e3,       // size of a cell
  points = 40           // along the interface of the section
];

// Where the dip is p(Y) = p0 + b Y at the depth Y, dY/dx = tan p, so that sin p = sin p0 exp(b x).
start = trench_dip * Pi / 180;
finish = deep_dip * Pi / 180;
bend = (finish - start) / locked_depth;
end_x = Log(Sin(finish) / Sin(start)) / bend;

trench[] = {};
For i In {0 : points}
  x = end_x * i / points;
  p = newp;
  Point(p) = {x, -(Asin(Sin(start) * Exp(bend * x)) - start) / bend, 0};
  trench[] += p;
EndFor

// Where the straight part leaves the model.
through_bottom = (depth - locked_depth) / Tan(finish) < right - end_x;
p_end = newp;
If (through_bottom)
  Point(p_end) = {end_x + (depth - locked_depth) / Tan(finish), -depth, 0};
Else
  Point(p_end) = {right, -locked_depth - (right - end_x) * Tan(finish), 0};
EndIf
p_left = newp;
Point(p_left) = {-left, 0, 0};
p_low_left = newp;
Point(p_low_left) = {-left, -depth, 0};
p_low_right = newp;
Point(p_low_right) = {right, -depth, 0};
p_right = newp;
Point(p_right) = {right, 0, 0};

thrust = newl;
Spline(thrust) = trench[];
deep = newl;
Line(deep) = {trench[points], p_end};
surface_ocean = newl;
Line(surface_ocean) = {p_left, trench[0]};
surface_continent = newl;
Line(surface_continent) = {trench[0], p_right};
side_left = newl;
Line(side_left) = {p_left, p_low_left};
If (through_bottom)
  low_1 = newl;
  Line(low_1) = {p_low_left, p_end};
  low_2 = newl;
  Line(low_2) = {p_end, p_low_right};
  low_3 = newl;
  Line(low_3) = {p_low_right, p_right};
  below[] = {side_left, low_1};
  beyond[] = {low_2, low_3};
Else
  low_1 = newl;
  Line(low_1) = {p_low_left, p_low_right};
  low_2 = newl;
  Line(low_2) = {p_low_right, p_end};
  low_3 = newl;
  Line(low_3) = {p_end, p_right};
  below[] = {side_left, low_1, low_2};
  beyond[] = {low_3};
EndIf

// The section is the front.
Curve Loop(1) = {below[], -deep, -thrust, -surface_ocean};
Curve Loop(2) = {thrust, deep, beyond[], -surface_continent};
Plane Surface(1) = {1};
Plane Surface(2) = {2};

// An extruded surface gives the one at the back, the volume, and the sides in the order of the loop.
ocean[] = Extrude {0, 0, width} { Surface{1}; };
continent[] = Extrude {0, 0, width} { Surface{2}; };
n = #below[];
Physical Surface("front") = {1, 2};
Physical Surface("back") = {ocean[0], continent[0]};
Physical Surface("left") = {ocean[2]};
Physical Surface("deep") = {ocean[2 + n]};
Physical Surface("megathrust") = {ocean[3 + n]};
Physical Surface("surface") = {ocean[4 + n], continent[#continent[] - 1]};
If (through_bottom)
  Physical Surface("bottom") = {ocean[3], continent[4]};
  Physical Surface("right") = {continent[5]};
Else
  Physical Surface("bottom") = {ocean[3]};
  Physical Surface("right") = {ocean[4], continent[4]};
EndIf
Physical Volume("ocean") = {ocean[1]};
Physical Volume("continent") = {continent[1]};

// The point of the megathrust above or below, and the distance from there.
nearest = Sprintf("Min(Max(x,0),%.16g)", end_x);
interface = StrCat(Sprintf("(Asin(%.16g*Exp(%.16g*", Sin(start), bend), nearest,
                   Sprintf("))-%.16g)/%.16g", start, bend));
Field[1] = MathEval;
Field[1].F = StrCat(Sprintf("Min(%.16g,%.16g+%.16g*Sqrt((x-", largest, h, growth), nearest,
                    ")^2+(y+", interface, ")^2))");
Background Field = 1;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.Optimize = 1;

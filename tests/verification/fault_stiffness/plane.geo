// A half space of cells that grow from h on its bottom, z = 0, without order; with `layers`, four
// layers of prisms, cut into tetrahedra, lie beside the bottom.
DefineConstant[ h = 1, half = 15, growth = 0.1, layers = 0 ];
Point(1) = {-half, -half, 0};
Point(2) = {half, -half, 0};
Point(3) = {half, half, 0};
Point(4) = {-half, half, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
bodies[] = {};
top = 1;
from = 0;
If (layers)
  // 0.3, 0.45, 0.675 and 1 times h
  flat[] = Extrude {0, 0, 2.425 * h} {
    Surface{1};
    Layers{ {1, 1, 1, 1}, {0.3 / 2.425, 0.75 / 2.425, 1.425 / 2.425, 1} };
  };
  bodies[] += flat[1];
  top = flat[0];
  from = 2.425 * h;
EndIf
rest[] = Extrude {0, 0, 24 - from} { Surface{top}; };
bodies[] += rest[1];
Physical Surface("bottom") = {1};
Physical Surface("top") = {rest[0]};
Physical Volume("body") = {bodies[]};
Field[1] = MathEval;
Field[1].F = Sprintf("%g+%g*z", h, growth);
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6;
Mesh.Optimize = 1;

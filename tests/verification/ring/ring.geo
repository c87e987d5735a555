// A square with a circular fault around its middle, in two halves; h is the length of its cells.
DefineConstant[R = 3e3, W = 45e3, h = 120];
Point(1) = {0, 0, 0}; Point(2) = {R, 0, 0}; Point(3) = {0, R, 0};
Point(4) = {-R, 0, 0}; Point(5) = {0, -R, 0};
Circle(1) = {2, 1, 3}; Circle(2) = {3, 1, 4}; Circle(3) = {4, 1, 5}; Circle(4) = {5, 1, 2};
Transfinite Curve{1:4} = Round(R * Pi / 2 / h) + 1;
Point(6) = {-W, -W, 0}; Point(7) = {W, -W, 0}; Point(8) = {W, W, 0}; Point(9) = {-W, W, 0};
Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 9}; Line(9) = {9, 6};
Curve Loop(1) = {1:4}; Curve Loop(2) = {6:9};
Plane Surface(1) = {1}; Plane Surface(2) = {2, 1};
Field[1] = Distance; Field[1].CurvesList = {1:4};
Field[2] = Threshold; Field[2].InField = 1;
Field[2].SizeMin = h; Field[2].SizeMax = W / 5; Field[2].DistMin = 0; Field[2].DistMax = W;
Background Field = 2; Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0;
Physical Surface("rock") = {1, 2}; Physical Curve("outside") = {6:9};
Physical Curve("up") = {1, 2}; Physical Curve("down") = {3, 4};

// A quarter of the Taylor bar, 3.2 mm x 32.4 mm, in hexahedra: a core about the axis and two blocks around it, extruded.
//
//   gmsh -3 -format msh41 -setnumber cells 3 -setnumber layers 50 taylor.geo -o taylor.msh
DefineConstant[ cells = 3, layers = 50 ];  // along each edge of a block; along the bar
radius = 3.2;
length = 32.4;
side = 0.55 * radius;    // of the core, on the axes
corner = 0.42 * radius;  // of the core, on the diagonal

Point(1) = {0, 0, 0};
Point(2) = {side, 0, 0};
Point(3) = {corner, corner, 0};
Point(4) = {0, side, 0};
Point(5) = {radius, 0, 0};
Point(6) = {radius * Sqrt(0.5), radius * Sqrt(0.5), 0};
Point(7) = {0, radius, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {2, 5};
Line(6) = {3, 6};
Line(7) = {4, 7};
Circle(8) = {5, 1, 6};
Circle(9) = {6, 1, 7};

Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 8, -6, -2};
Curve Loop(3) = {6, 9, -7, -3};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Transfinite Curve{1:9} = cells + 1;
Transfinite Surface{1:3};
Recombine Surface{1:3};

core[] = Extrude{0, 0, length}{ Surface{1}; Layers{layers}; Recombine; };  // end, volume, sides in the order of the loop
right[] = Extrude{0, 0, length}{ Surface{2}; Layers{layers}; Recombine; };
left[] = Extrude{0, 0, length}{ Surface{3}; Layers{layers}; Recombine; };

Physical Volume("bar") = {core[1], right[1], left[1]};
Physical Surface("foot") = {1:3};
Physical Surface("x0") = {core[5], left[4]};
Physical Surface("y0") = {core[2], right[2]};
Mesh.SaveGroupsOfNodes = 1;  // sets of nodes in .inp and .key too

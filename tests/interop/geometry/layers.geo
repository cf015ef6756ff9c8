// SPDX-License-Identifier: MIT
// Hexahedra, prisms, and pyramids between hexahedra and tetrahedra.
Point(1) = {0, 0, 0, 0.34}; Point(2) = {1, 0, 0, 0.34}; Point(3) = {1, 1, 0, 0.34}; Point(4) = {0, 1, 0, 0.34};
Point(5) = {2, 0, 0, 0.34}; Point(6) = {2, 1, 0, 0.34};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3};
Transfinite Curve{1:4} = 4;
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Surface{1}; Recombine Surface{1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2};
hexes[] = Extrude {0, 0, 1} { Surface{1}; Layers{3}; Recombine; };
prisms[] = Extrude {0, 0, 1} { Surface{2}; Layers{3}; Recombine; };
Physical Volume("hexahedra", 1) = {hexes[1]};
Physical Volume("prisms", 2) = {prisms[1]};
Physical Surface("floor", 11) = {1, 2};
Physical Surface("ceiling", 12) = {hexes[0], prisms[0]};

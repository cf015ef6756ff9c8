// SPDX-License-Identifier: MIT
// Two regions, a hole whose loop turns the other way, a curve inside that keeps its elements.
h = 0.2;
Point(1) = {0, 0, 0, h}; Point(2) = {1, 0, 0, h}; Point(3) = {2, 0, 0, h};
Point(4) = {2, 1, 0, h}; Point(5) = {1, 1, 0, h}; Point(6) = {0, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1};
Line(7) = {2, 5};
Point(11) = {0.3, 0.3, 0, h}; Point(12) = {0.7, 0.3, 0, h}; Point(13) = {0.7, 0.7, 0, h}; Point(14) = {0.3, 0.7, 0, h};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 11};
Curve Loop(1) = {1, 7, 5, 6}; Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(1) = {1, 2};
Curve Loop(3) = {-4, -3, -2, 7};  // turns the other way
Plane Surface(2) = {3};
Physical Curve("wall", 21) = {1, 2, 4, 5};
Physical Curve("inflow", 22) = {6};
Physical Curve("outflow", 23) = {3};
Physical Curve("hole", 24) = {11, 12, 13, 14};
Physical Curve("between", 25) = {7};
Physical Surface("left part", 31) = {1};
Physical Surface("right", 32) = {2};

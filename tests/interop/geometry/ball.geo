// SPDX-License-Identifier: MIT
// A ball within a box: two regions and faces between them.
SetFactory("OpenCASCADE");
Mesh.CharacteristicLengthMin = 0.3; Mesh.CharacteristicLengthMax = 0.3;
Box(1) = {0, 0, 0, 1, 1, 1};
Sphere(2) = {0.5, 0.5, 0.5, 0.25};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Physical Volume("ball", 1) = {2};
Physical Volume("box", 2) = {3};
Physical Surface("outside", 11) = {Boundary{ Volume{2, 3}; }};

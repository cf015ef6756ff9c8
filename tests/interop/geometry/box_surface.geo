// SPDX-License-Identifier: MIT
// The surface of a cube, closed and turned outwards.
SetFactory("OpenCASCADE");
Mesh.CharacteristicLengthMin = 0.3; Mesh.CharacteristicLengthMax = 0.3;
Box(1) = {0, 0, 0, 1, 1, 1};

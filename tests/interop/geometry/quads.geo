// SPDX-License-Identifier: MIT
// Quadrilaterals beside triangles.
Include "plane.geo";
Recombine Surface{2};
Transfinite Curve{2, 4} = 6; Transfinite Curve{3, 7} = 6;
Transfinite Surface{2} = {2, 3, 4, 5};

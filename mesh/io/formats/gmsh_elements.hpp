// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The elements of Gmsh's files by their numbers (https://gmsh.info/doc/texinfo/gmsh.html, "MSH file format").
namespace leonhard::io::gmsh_elements {

/// Lists of elements by shape.
enum GmshList : std::size_t {
  lines,
  triangles,
  quadrilaterals,
  tetrahedra,
  hexahedra,
  prisms,
  pyramids,
  list_count
};

/// What Gmsh calls an element type: how many nodes, corners first, and which list it goes to (points: none).
struct ElementType {
  std::int32_t number;
  std::size_t nodes, list = list_count;
};

inline constexpr std::array<std::size_t, list_count> corners_in_list{2, 3, 4, 4, 8, 6, 5};
inline constexpr std::array<int, list_count> dimension_of_list{1, 2, 2, 3, 3, 3, 3};

inline constexpr std::array element_types{ElementType{1, 2, lines},
                                          ElementType{2, 3, triangles},
                                          ElementType{3, 4, quadrilaterals},
                                          ElementType{4, 4, tetrahedra},
                                          ElementType{5, 8, hexahedra},
                                          ElementType{6, 6, prisms},
                                          ElementType{7, 5, pyramids},
                                          ElementType{8, 3, lines},
                                          ElementType{9, 6, triangles},
                                          ElementType{10, 9, quadrilaterals},
                                          ElementType{11, 10, tetrahedra},
                                          ElementType{12, 27, hexahedra},
                                          ElementType{13, 18, prisms},
                                          ElementType{14, 14, pyramids},
                                          ElementType{15, 1},
                                          ElementType{16, 8, quadrilaterals},
                                          ElementType{17, 20, hexahedra},
                                          ElementType{18, 15, prisms},
                                          ElementType{19, 13, pyramids},
                                          ElementType{20, 9, triangles},
                                          ElementType{21, 10, triangles},
                                          ElementType{22, 12, triangles},
                                          ElementType{23, 15, triangles},
                                          ElementType{24, 15, triangles},
                                          ElementType{25, 21, triangles},
                                          ElementType{26, 4, lines},
                                          ElementType{27, 5, lines},
                                          ElementType{28, 6, lines},
                                          ElementType{29, 20, tetrahedra},
                                          ElementType{30, 35, tetrahedra},
                                          ElementType{31, 56, tetrahedra},
                                          ElementType{36, 16, quadrilaterals},
                                          ElementType{37, 25, quadrilaterals},
                                          ElementType{38, 36, quadrilaterals},
                                          ElementType{90, 40, prisms},
                                          ElementType{91, 75, prisms},
                                          ElementType{92, 64, hexahedra},
                                          ElementType{93, 125, hexahedra}};

}  // namespace leonhard::io::gmsh_elements

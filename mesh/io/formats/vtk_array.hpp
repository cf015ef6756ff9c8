// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/mesh/io/formats/vtk_blocks.hpp"
#include "leonhard/mesh/io/formats/xml.hpp"

namespace leonhard::io {

/// How the arrays of a VTK XML file are stored: the attributes of its root element and its appended data.
struct VtkEncoding {
  std::string source;                              ///< names the file in errors
  bool swapped = false;                            ///< numbers have the other byte order than this machine's
  std::size_t header_bytes = 4;                    ///< of the sizes before binary data: 4 or 8
  VtkCompressor compressor = VtkCompressor::none;  ///< of binary data
  bool appended_is_base64 = false;                 ///< else raw
  std::string_view appended;                       ///< after the underscore; empty if there is none
};

/// What the root element <VTKFile> says about its arrays.
/// throws InputError for another compressor than zlib, LZ4 and LZMA, or one without which Leonhard was built
[[nodiscard]] VtkEncoding vtk_encoding(const XmlElement& root, const std::string& source);

/// The numbers of a <DataArray>, any of VTK's number types in ascii, base64 or appended form.
///
/// count  how many numbers there must be, or nothing if the file alone says
/// throws InputError naming the array's line: no number, cut short, sizes that contradict each other, broken
/// base64 or
///        compressed data; floating-point numbers where integers are asked for
[[nodiscard]] std::vector<double> read_doubles(const XmlElement& array, const VtkEncoding& encoding,
                                               std::optional<std::size_t> count);
[[nodiscard]] std::vector<std::int64_t> read_integers(const XmlElement& array, const VtkEncoding& encoding,
                                                      std::optional<std::size_t> count);

/// As read_doubles, but NaN and infinities count as numbers in ascii too: nan, inf, -inf.
[[nodiscard]] std::vector<double> read_field_values(const XmlElement& array, const VtkEncoding& encoding,
                                                    std::size_t count);

/// Append an array's bytes with their header of 64-bit sizes, compressed where Leonhard was built with zlib.
void append_vtk_bytes(std::string& appended, std::string_view bytes);

/// "vtkZLibDataCompressor", or "" where Leonhard was built without zlib: what append_vtk_bytes uses.
[[nodiscard]] std::string_view vtk_compressor();

}  // namespace leonhard::io

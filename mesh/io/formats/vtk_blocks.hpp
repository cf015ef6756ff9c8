// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leonhard::io {

/// How a VTK XML file compresses the blocks of its arrays.
enum class VtkCompressor : std::uint8_t { none, zlib, lz4, lzma };

/// As the attribute `compressor` of a file names it ("": none). None if it is no compressor of VTK.
[[nodiscard]] std::optional<VtkCompressor> vtk_compressor_named(std::string_view name);

/// "zlib", "LZ4", "LZMA".
[[nodiscard]] const char* name_of(VtkCompressor compressor);

/// Whether Leonhard was built with its library.
[[nodiscard]] bool can_unpack(VtkCompressor compressor);

/// By how much it can shrink bytes at best, or a little more.
[[nodiscard]] std::uint64_t best_ratio(VtkCompressor compressor);

/// Fill `bytes` with what a block holds: zlib's format, LZ4's block format, xz. Whether it held exactly as many.
///
/// compressor  one that can_unpack
[[nodiscard]] bool unpack(VtkCompressor compressor, std::string_view block, std::span<char> bytes);

}  // namespace leonhard::io

// SPDX-License-Identifier: MIT
#include "leonhard/mesh/io/formats/vtk_blocks.hpp"

#ifdef LEONHARD_HAS_ZLIB
#include <zlib.h>
#endif
#ifdef LEONHARD_HAS_LZ4
#include <lz4.h>
#endif
#ifdef LEONHARD_HAS_LZMA
#include <lzma.h>
#endif

#include <algorithm>
#include <array>
#include <limits>

namespace leonhard::io {
namespace {

using Unpack = bool (*)(std::string_view block, std::span<char> bytes);

struct CompressorEntry {
  VtkCompressor compressor;
  std::string_view vtk_name;
  const char* name;
  std::uint64_t best_ratio;
  Unpack unpack;  ///< null: built without it
};

#ifdef LEONHARD_HAS_ZLIB
bool unpack_zlib(std::string_view block, std::span<char> bytes) {
  uLongf size = bytes.size();
  return ::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                      reinterpret_cast<const Bytef*>(block.data()), block.size()) == Z_OK &&
         size == bytes.size();
}
constexpr Unpack with_zlib = unpack_zlib;
#else
constexpr Unpack with_zlib = nullptr;
#endif

#ifdef LEONHARD_HAS_LZ4
bool unpack_lz4(std::string_view block, std::span<char> bytes) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  if (block.size() > most || bytes.size() > most) return false;
  return ::LZ4_decompress_safe(block.data(), bytes.data(), static_cast<int>(block.size()),
                               static_cast<int>(bytes.size())) == static_cast<int>(bytes.size());
}
constexpr Unpack with_lz4 = unpack_lz4;
#else
constexpr Unpack with_lz4 = nullptr;
#endif

#ifdef LEONHARD_HAS_LZMA
bool unpack_lzma(std::string_view block, std::span<char> bytes) {
  std::uint64_t memory = std::uint64_t{1} << 28;  // for the dictionary, which the block states
  std::size_t used = 0, made = 0;
  return ::lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(block.data()),
                                     &used, block.size(), reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     &made, bytes.size()) == LZMA_OK &&
         made == bytes.size();
}
constexpr Unpack with_lzma = unpack_lzma;
#else
constexpr Unpack with_lzma = nullptr;
#endif

constexpr std::array<CompressorEntry, 4> compressors{
    {{VtkCompressor::none, "", "nothing", 1, nullptr},
     {VtkCompressor::zlib, "vtkZLibDataCompressor", "zlib", 1040, with_zlib},
     {VtkCompressor::lz4, "vtkLZ4DataCompressor", "LZ4", 256, with_lz4},
     {VtkCompressor::lzma, "vtkLZMADataCompressor", "LZMA", 10000, with_lzma}}};

const CompressorEntry& entry_of(VtkCompressor compressor) {
  return compressors[static_cast<std::size_t>(compressor)];
}

}  // namespace

std::optional<VtkCompressor> vtk_compressor_named(std::string_view name) {
  const auto found = std::find_if(compressors.begin(), compressors.end(),
                                  [&](const auto& entry) { return entry.vtk_name == name; });
  if (found == compressors.end()) return std::nullopt;
  return found->compressor;
}

const char* name_of(VtkCompressor compressor) { return entry_of(compressor).name; }

bool can_unpack(VtkCompressor compressor) { return entry_of(compressor).unpack != nullptr; }

std::uint64_t best_ratio(VtkCompressor compressor) { return entry_of(compressor).best_ratio; }

bool unpack(VtkCompressor compressor, std::string_view block, std::span<char> bytes) {
  return entry_of(compressor).unpack(block, bytes);
}

}  // namespace leonhard::io

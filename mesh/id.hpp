// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "leonhard/kernel/input_error.hpp"

namespace leonhard {

#ifdef LEONHARD_64BIT_IDS
using IdRaw = std::uint64_t;
#else
using IdRaw = std::uint32_t;
#endif

namespace detail {
[[noreturn, gnu::cold, gnu::noinline]] inline void throw_no_such_id(std::size_t number) {
  throw InputError("id",
                   std::to_string(number) + " is beyond what an id of " + std::to_string(8 * sizeof(IdRaw)) +
                       " bits can number",
                   sizeof(IdRaw) < 8 ? "build with LEONHARD_64BIT_IDS" : "");
}
}  // namespace detail

/// A number that knows what it numbers: a VertexId cannot index triangles.
template <class Tag>
struct Id {
  IdRaw raw{};

  /// throws  InputError if an id cannot number it; where a loop's bound is known to fit, Id{static_cast<IdRaw>(index)} is
  ///         the same without a check
  [[nodiscard]] static constexpr Id from(std::size_t index) {
    if (index >= std::numeric_limits<IdRaw>::max()) [[unlikely]]
      detail::throw_no_such_id(index);
    return Id{static_cast<IdRaw>(index)};
  }
  [[nodiscard]] constexpr std::size_t index() const { return raw; }
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using TriangleId = Id<struct TriangleTag>;
using FaceId = Id<struct FaceTag>;  ///< a triangle between tetrahedra
using TetId = Id<struct TetTag>;
using CellId = Id<struct CellTag>;  ///< a cell of any kind, of a MixedMesh

/// An id or none ("no neighbour behind this edge"), in the space of an id. Never -1 in disguise: asking for
/// the id of none is a bug that assertions catch.
template <class IdT>
class MaybeId {
 public:
  constexpr MaybeId() = default;
  constexpr MaybeId(IdT id) : raw_(id.raw) { assert(id.raw != none_raw); }

  [[nodiscard]] constexpr bool has_value() const { return raw_ != none_raw; }
  [[nodiscard]] constexpr explicit operator bool() const { return has_value(); }
  [[nodiscard]] constexpr IdT operator*() const {
    assert(has_value());
    return IdT{raw_};
  }
  [[nodiscard]] constexpr IdT value_or(IdT fallback) const { return has_value() ? IdT{raw_} : fallback; }
  friend constexpr bool operator==(const MaybeId&, const MaybeId&) = default;

 private:
  static constexpr IdRaw none_raw = std::numeric_limits<IdRaw>::max();
  IdRaw raw_ = none_raw;
};

namespace detail {
std::ostream& write_id(std::ostream& out, IdRaw raw);
std::ostream& write_no_id(std::ostream& out);
}  // namespace detail

/// Writes the number, "17".
template <class Tag>
std::ostream& operator<<(std::ostream& out, Id<Tag> id) {
  return detail::write_id(out, id.raw);
}
/// Writes the number, or "none".
template <class IdT>
std::ostream& operator<<(std::ostream& out, MaybeId<IdT> id) {
  return id ? out << *id : detail::write_no_id(out);
}

/// The ids 0 .. count - 1 in order, a range to loop over or to hand to an algorithm. (std::views::iota would
/// do, but clang 14 cannot compile the one of GCC 12's library.)
template <class IdT>
class IdRange {
 public:
  class iterator {
   public:
    using iterator_category = std::input_iterator_tag;  // operator* yields a value
    using value_type = IdT;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = IdT;

    constexpr iterator() = default;
    constexpr explicit iterator(std::size_t index) : index_(index) {}
    [[nodiscard]] constexpr IdT operator*() const { return IdT{static_cast<IdRaw>(index_)}; }
    constexpr iterator& operator++() {
      ++index_;
      return *this;
    }
    constexpr iterator operator++(int) {
      const iterator old = *this;
      ++index_;
      return old;
    }
    friend constexpr bool operator==(const iterator&, const iterator&) = default;

   private:
    std::size_t index_{};
  };

  /// throws  InputError if ids cannot number so many
  constexpr explicit IdRange(std::size_t count) : count_(count) {
    if (count > std::numeric_limits<IdRaw>::max()) [[unlikely]]
      detail::throw_no_such_id(count - 1);
  }
  [[nodiscard]] constexpr iterator begin() const { return iterator(0); }
  [[nodiscard]] constexpr iterator end() const { return iterator(count_); }
  [[nodiscard]] constexpr std::size_t size() const { return count_; }

 private:
  std::size_t count_;
};

/// A flat array indexed by one kind of id only. That an id is within the array is a precondition, which assertions check:
/// this is what inner loops are made of; contains() says whether it is.
template <class IdT, class T>
class PerId {
 public:
  using value_type = T;
  PerId() = default;
  explicit PerId(std::size_t count, const T& value = T{}) : data_(count, value) {}
  explicit PerId(std::vector<T> data) : data_(std::move(data)) {}

  [[nodiscard]] decltype(auto) operator[](IdT id) {
    assert(id.index() < data_.size());
    return data_[id.index()];
  }
  [[nodiscard]] decltype(auto) operator[](IdT id) const {
    assert(id.index() < data_.size());
    return data_[id.index()];
  }
  IdT push_back(T value) {
    data_.push_back(std::move(value));
    return IdT::from(data_.size() - 1);
  }
  [[nodiscard]] std::size_t size() const { return data_.size(); }
  [[nodiscard]] bool empty() const { return data_.empty(); }
  [[nodiscard]] bool contains(IdT id) const { return id.index() < data_.size(); }
  void reserve(std::size_t count) { data_.reserve(count); }
  void resize(std::size_t count, const T& value = T{}) { data_.resize(count, value); }
  void clear() { data_.clear(); }

  [[nodiscard]] auto begin() { return data_.begin(); }
  [[nodiscard]] auto end() { return data_.end(); }
  [[nodiscard]] auto begin() const { return data_.begin(); }
  [[nodiscard]] auto end() const { return data_.end(); }

  /// All ids in order: for (VertexId v : points.ids())
  [[nodiscard]] IdRange<IdT> ids() const { return IdRange<IdT>(data_.size()); }
  /// The array itself, for code that wants a span or a raw pointer.
  [[nodiscard]] std::vector<T>& flat() { return data_; }
  [[nodiscard]] const std::vector<T>& flat() const { return data_; }

  friend bool operator==(const PerId&, const PerId&) = default;

 private:
  std::vector<T> data_;
};

}  // namespace leonhard

template <class Tag>
struct std::hash<leonhard::Id<Tag>> {
  [[nodiscard]] std::size_t operator()(leonhard::Id<Tag> id) const noexcept {
    return std::hash<leonhard::IdRaw>()(id.raw);
  }
};
template <class IdT>
struct std::hash<leonhard::MaybeId<IdT>> {
  [[nodiscard]] std::size_t operator()(leonhard::MaybeId<IdT> id) const noexcept {
    return id ? std::hash<IdT>()(*id) : ~std::size_t{0};
  }
};

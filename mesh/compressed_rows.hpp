// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace leonhard {

/// Rows of various lengths in two flat arrays, one after another: row r is links()[offsets()[r] .. offsets()[r + 1] - 1].
/// A graph's neighbours, the pattern of a sparse matrix, the vertices of each part.
///
/// Link    what a row holds, such as a vertex number
/// Offset  a number that counts all links; whoever makes the rows sees to it that they fit
template <class Link, class Offset = std::uint32_t>
class CompressedRows {
 public:
  /// No rows.
  CompressedRows() = default;

  /// offsets  one more than there are rows: from 0, not descending, to the number of links (asserted at both ends)
  CompressedRows(std::vector<Offset> offsets, std::vector<Link> links)
      : offsets_(std::move(offsets)), links_(std::move(links)) {
    assert(!offsets_.empty() && offsets_.front() == 0 && std::cmp_equal(offsets_.back(), links_.size()));
  }

  /// Rows.
  [[nodiscard]] std::size_t size() const { return offsets_.size() - 1; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::size_t link_count() const { return links_.size(); }

  /// A row, valid until rows are added. row is below size(): a precondition, asserted only.
  [[nodiscard]] std::span<const Link> operator[](std::size_t row) const {
    assert(row < size());
    return {links_.data() + offsets_[row], links_.data() + offsets_[row + 1]};
  }
  [[nodiscard]] std::span<Link> operator[](std::size_t row) {
    assert(row < size());
    return {links_.data() + offsets_[row], links_.data() + offsets_[row + 1]};
  }
  [[nodiscard]] std::span<const Offset> offsets() const { return offsets_; }  ///< size() + 1 numbers
  [[nodiscard]] std::span<const Link> links() const { return links_; }
  [[nodiscard]] std::span<Link> links() { return links_; }

  // Rows may be added one after another: the links of the new row, then end_row().
  void reserve(std::size_t rows, std::size_t links) {
    offsets_.reserve(rows + 1);
    links_.reserve(links);
  }
  void add_link(const Link& link) { links_.push_back(link); }
  void end_row() {
    assert(std::cmp_less_equal(links_.size(), std::numeric_limits<Offset>::max()));
    offsets_.push_back(static_cast<Offset>(links_.size()));
  }

  friend bool operator==(const CompressedRows&, const CompressedRows&) = default;

 private:
  std::vector<Offset> offsets_{0};
  std::vector<Link> links_;
};

/// Links collected row by row, each row in the sequence in which they are named.
///
/// rows     number of rows
/// for_all  is called twice, with something to call as add(row, link) for each link; must name the same both times
/// Cost O(rows + links). Method: counting sort.
template <class Link, class Offset = std::uint32_t, class ForAll>
[[nodiscard]] CompressedRows<Link, Offset> collect_rows(std::size_t rows, const ForAll& for_all) {
  std::vector<Offset> offsets(rows + 1, 0);
  for_all([&](std::size_t row, const Link&) { ++offsets[row + 1]; });
  for (std::size_t row = 0; row < rows; ++row) offsets[row + 1] += offsets[row];
  std::vector<Link> links(offsets.back());
  std::vector<Offset> next(offsets.begin(), offsets.end() - 1);
  for_all([&](std::size_t row, const Link& link) { links[next[row]++] = link; });
  return {std::move(offsets), std::move(links)};
}

}  // namespace leonhard

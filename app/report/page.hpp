// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "leonhard/app/solve/run.hpp"

/// Pieces of a report page that flows of the plane and of space share. HTML in and out, but for `escaped`.
namespace leonhard::app {

/// A picture of the report: its PNG bytes go into the page.
struct ReportPicture {
  std::string title;
  std::string caption;
  std::string file;  ///< name beside the page, for the link to the full size
  std::string png;
};

/// Plain text as HTML.
[[nodiscard]] std::string escaped(std::string_view text);

/// A number as the page shows it: with the given digits, or a count in groups of three.
[[nodiscard]] std::string shown(double x, int digits);
[[nodiscard]] std::string shown(std::int64_t n);
[[nodiscard]] std::string shown(std::uint64_t n);
template <std::integral Count>
[[nodiscard]] std::string shown(Count n) {
  if constexpr (std::signed_integral<Count>)
    return shown(std::int64_t{n});
  else
    return shown(std::uint64_t{n});
}

[[nodiscard]] std::string card(const std::string& value, std::string_view name);
[[nodiscard]] std::string row(const std::vector<std::string>& cells);
[[nodiscard]] std::string head_row(const std::vector<std::string>& cells);
/// One of two words, green or red.
[[nodiscard]] std::string mark(bool good, std::string_view yes, std::string_view no);

/// Title, conditions, verdict, and cards with the coefficients, the caller's about the mesh among them.
template <int dim>
[[nodiscard]] std::string head_section(const FlowRun<dim>& run, const std::string& cell_cards);
[[nodiscard]] std::string warnings_section(const RunCommon& run);
/// The first one wide.
[[nodiscard]] std::string pictures_section(const std::vector<ReportPicture>& pictures);
/// Of each body and of all, by pressure and friction where there is friction.
template <int dim>
[[nodiscard]] std::string forces_section(const FlowRun<dim>& run);
[[nodiscard]] std::string numberings_table(const RunCommon& run);
[[nodiscard]] std::string time_section(const RunCommon& run, std::uint64_t peak_memory_bytes);

/// The sections with head, style, the case's text and links to the files beside the page.
[[nodiscard]] std::string whole_page(const RunCommon& run, const std::string& sections,
                                     const std::set<std::string>& files);

}  // namespace leonhard::app

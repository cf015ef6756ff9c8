// SPDX-License-Identifier: MIT
#include "leonhard/app/report/surface_report.hpp"

#include <fmt/core.h>

#include <iterator>
#include <string_view>

#include "leonhard/app/console.hpp"

namespace leonhard::app {

Json to_json(const SurfaceAccount& account) {
  return {{"vertices", account.vertices},
          {"edges", account.edges},
          {"polygons", account.polygons},
          {"triangles", account.triangles},
          {"quadrilaterals", account.quadrilaterals},
          {"closed", account.is_closed()},
          {"manifold", account.is_manifold()},
          {"oriented", account.is_oriented()},
          {"components", account.components},
          {"open_edges", account.open_edges},
          {"crowded_edges", account.crowded_edges},
          {"unlike_edges", account.unlike_edges},
          {"degenerate_polygons", account.degenerate},
          {"unused_vertices", account.unused_vertices},
          {"repeated_places", account.repeated_places},
          {"contacts", account.contacts},
          {"area", account.area},
          {"volume", account.is_closed() && account.is_oriented() ? Json(account.volume) : Json()}};
}

std::string text_of(const SurfaceAccount& account) {
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<14}{}\n", name, value);
  };
  const auto verdict = [](bool good, std::size_t count, std::string_view fault) {
    return good ? std::string("yes") : fmt::format("NO: {} {}", grouped(count), fault);
  };
  line("vertices", grouped(account.vertices));
  line("edges", grouped(account.edges));
  line("polygons", fmt::format("{}: {} triangles, {} quadrilaterals", grouped(account.polygons),
                               grouped(account.triangles), grouped(account.quadrilaterals)));
  line("closed", verdict(account.is_closed(), account.open_edges, "edges have one polygon only"));
  line("manifold",
       verdict(account.is_manifold(), account.crowded_edges, "edges have more than two polygons"));
  line("oriented",
       verdict(account.is_oriented(), account.unlike_edges, "edges have polygons that turn unlike"));
  line("contacts", account.contacts == 0
                       ? std::string("none: it does not cross or touch itself")
                       : fmt::format("{} pairs of triangles meet beyond common corners and edges",
                                     grouped(account.contacts)));
  line("components", grouped(account.components));
  if (account.degenerate > 0)
    line("degenerate", fmt::format("{} polygons without area", grouped(account.degenerate)));
  if (account.unused_vertices > 0)
    line("unused", fmt::format("{} vertices", grouped(account.unused_vertices)));
  if (account.repeated_places > 0)
    line("repeated", fmt::format("{} vertices at the place of another one; --weld 0 joins them",
                                 grouped(account.repeated_places)));
  line("area", fmt::format("{:.15g}", account.area));
  if (account.is_closed() && account.is_oriented())
    line("volume",
         fmt::format("{:.15g}{}", account.volume, account.volume < 0 ? ": its polygons turn inwards" : ""));
  return text;
}

}  // namespace leonhard::app

// SPDX-License-Identifier: MIT
#include "leonhard/app/report/album.hpp"

#include <cmath>
#include <fstream>
#include <iterator>

#include "leonhard/mesh/draw/curves.hpp"

namespace leonhard::app {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void Album::add(std::string title, std::string caption) {
  pictures_.push_back({std::move(title), std::move(caption), last_, bytes_of(folder_ / last_)});
}

void Album::add_history(const std::vector<Iteration>& history) {
  draw::Curve residual{.name = "residual", .x = {}, .y = {}}, cl{.name = "CL", .x = {}, .y = {}},
      cd{.name = "CD", .x = {}, .y = {}};
  for (const Iteration& iteration : history) {
    for (draw::Curve* curve : {&residual, &cl, &cd}) curve->x.push_back(iteration.number);
    residual.y.push_back(std::pow(10.0, -iteration.residual_drop_orders));
    cl.y.push_back(iteration.cl);
    cd.y.push_back(iteration.cd);
  }
  const std::vector<draw::CurvePanel> panels{
      {{residual},
       {.title = {}, .x_label = "iteration", .y_label = "residual / first residual", .log_y = true}},
      {{cl}, {.title = {}, .x_label = "iteration", .y_label = "CL"}},
      {{cd}, {.title = {}, .x_label = "iteration", .y_label = "CD"}}};
  draw::draw_panels(path("history.png"), panels, "Convergence", 1, {.width = 1600, .height = 1200});
  add("Convergence", "The residual against its first value, and the coefficients of lift and drag.");
}

}  // namespace leonhard::app

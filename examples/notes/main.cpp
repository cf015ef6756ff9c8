// SPDX-License-Identifier: MIT
// Draws the figures of Barth's notes that belong to triangulation and graphs: notes_figures FOLDER [FIGURE...]
#include <algorithm>
#include <cstdio>
#include <exception>

#include "figures.hpp"

namespace {

using leonhard::notes::Figure;

std::vector<Figure> all_figures() {
  std::vector<Figure> all;
  for (const auto& part : {leonhard::notes::polyhedron_figures(), leonhard::notes::dual_figures(), leonhard::notes::orientation_figures(),
                           leonhard::notes::ordering_figures(), leonhard::notes::communication_figures(),
                           leonhard::notes::partition_figures(), leonhard::notes::property_figures(),
                           leonhard::notes::algorithm_figures()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

void draw(const Figure& figure, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / ("figure-" + figure.number + ".png");
  const std::string title = "Figure " + figure.number + "  " + figure.title;
  std::printf("%s  %s\n", file.c_str(), figure.title.c_str());
  if (figure.draw != nullptr) return figure.draw(file, title);
  const std::vector<leonhard::draw::Diagram> panels = figure.make();
  const int rows = (static_cast<int>(panels.size()) + figure.columns - 1) / figure.columns;
  const leonhard::draw::PictureSize size{figure.columns == 1 ? 1200 : 700 * figure.columns,
                                         (figure.columns == 1 && rows == 1 ? 860 : 660 * rows) + 60};
  leonhard::draw::draw_diagrams(file, panels, figure.columns, title, size);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: notes_figures FOLDER [FIGURE...], a figure being a number such as 3.3.5\n");
    return 1;
  }
  const std::vector<std::string> wanted(argv + 2, argv + argc);
  const std::vector<Figure> all = all_figures();
  for (const std::string& number : wanted)
    if (std::none_of(all.begin(), all.end(), [&](const Figure& f) { return f.number == number; })) {
      std::fprintf(stderr, "notes_figures: there is no figure %s; there are", number.c_str());
      for (const Figure& figure : all) std::fprintf(stderr, " %s", figure.number.c_str());
      std::fprintf(stderr, "\n");
      return 1;
    }
  std::filesystem::create_directories(argv[1]);
  for (const Figure& figure : all)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), figure.number) != wanted.end())
      draw(figure, argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "notes_figures: %s\n", error.what());
  return 2;
}

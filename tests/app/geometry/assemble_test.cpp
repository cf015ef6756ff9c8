// SPDX-License-Identifier: MIT
#include "leonhard/app/geometry/assemble.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "leonhard/app/geometry/dyadic_grid.hpp"
#include "leonhard/app/geometry/outline_checks.hpp"
#include "tests/app/input_error_of.hpp"

using namespace leonhard;
using namespace leonhard::app;

namespace {

const std::string flow = "[flow]\nmach = 0.5\n";

Case case_of(const std::string& rest) { return parse_case(flow + rest, "c.toml"); }
DomainGeometry domain_of(const std::string& rest) { return make_domain(case_of(rest)); }
std::string refusal(const std::string& rest) {
  return input_error_of([&] { return domain_of(rest); });
}

bool has(const std::string& message, const std::string& part) {
  INFO("message: ", message);
  CHECK(message.find(part) != std::string::npos);
  return message.find(part) != std::string::npos;
}

const std::string two_bodies =
    "[[body]]\nname = \"main\"\nnaca = \"2412\"\n"
    "[[body]]\nname = \"flap\"\nnaca = \"0012\"\nscale = 0.3\nrotation_deg = -30\ntranslation = [1.02, "
    "-0.02]\n";

bool on_grid(double x, double step) {
  return std::nearbyint(x / step) * step == x && std::abs(x / step) < 0x1p47;
}

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "leonhard_geometry_test") {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("bodies_and_far_field_become_marked_closed_loops") {
  const DomainGeometry domain = domain_of(two_bodies);
  CHECK(domain.pslg.marker_names == std::map<Marker, std::string>{{1, "main"}, {2, "flap"}, {3, "farfield"}});
  CHECK(domain.body_names == std::vector<std::string>{"main", "flap"});
  REQUIRE(domain.pslg.segments.size() == domain.pslg.points.size());
  std::vector<int> starts(domain.pslg.points.size()), ends(domain.pslg.points.size());
  for (const auto& segment : domain.pslg.segments) {
    ++starts[segment.from];
    ++ends[segment.to];
    CHECK(domain.pslg.point_markers[segment.from] == segment.marker);
    CHECK(domain.pslg.point_markers[segment.to] == segment.marker);
  }
  CHECK(std::ranges::all_of(starts, [](int n) { return n == 1; }));
  CHECK(std::ranges::all_of(ends, [](int n) { return n == 1; }));
}

TEST_CASE("each_hole_seed_lies_strictly_inside_its_body_and_no_other") {
  const DomainGeometry domain = domain_of(two_bodies);
  REQUIRE(domain.pslg.holes.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      CHECK((locate_in_polygon(domain.outlines[i], domain.pslg.holes[j]) == PointPlace::inside) == (i == j));
}

TEST_CASE("every_coordinate_is_on_the_dyadic_grid_and_midpoints_are_exact_six_times_over") {
  for (const auto* distance : {"10", "50", "1000"}) {
    const DomainGeometry domain = domain_of(two_bodies + "[farfield]\ndistance = " + distance + "\n");
    const double largest = std::stod(distance) + 1;
    const double step = DyadicGrid(domain.body_extent, largest).step();
    for (const Point2 p : domain.pslg.points) {
      CHECK(on_grid(p.x, step));
      CHECK(on_grid(p.y, step));
    }
    for (const auto& segment : domain.pslg.segments) {
      Point2 a = domain.pslg.points[segment.from], b = domain.pslg.points[segment.to];
      for (int halving = 0; halving < 6; ++halving) {
        const Point2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        REQUIRE(middle.x - a.x ==
                b.x - middle.x);  // exact differences: all are multiples of the same small step
        REQUIRE(middle.y - a.y == b.y - middle.y);
        (halving % 2 ? a : b) = middle;
      }
    }
  }
}

TEST_CASE("snapping_moves_points_by_less_than_a_hundred_billionth_of_the_chord") {
  const DyadicGrid grid(1, 50);
  for (const double x : {0.1, 1.0 / 3, 0.99999, -0.7}) CHECK(std::abs(grid(x) - x) < 1e-11);
  CHECK(grid(-1e-20) == 0);
  CHECK_FALSE(std::signbit(grid(-1e-20)));
}

TEST_CASE("sizes_start_at_the_bodies'_edges_and_end_at_the_far_field's") {
  const DomainGeometry domain = domain_of(two_bodies + "[mesher]\ngrowth = 0.06\n");
  CHECK(domain.growth == 0.06);
  CHECK(domain.max_size == 3);
  std::size_t body_points = 0;
  for (const auto& outline : domain.outlines) body_points += outline.size();
  CHECK(domain.sources.size() == body_points);
  for (const SizeSource& source : domain.sources) {
    CHECK(source.spacing > 0.0003);
    CHECK(source.spacing < 0.0101);
  }
}

TEST_CASE("the_far_field_is_a_circle_about_the_bodies_in_chords_of_the_reference_length") {
  const DomainGeometry domain =
      domain_of("[[body]]\nnaca = \"0012\"\nscale = 2\n[reference]\nlength = 2\n[farfield]\ndistance = 10\n");
  std::size_t far_points = 0;
  for (std::size_t i = 0; i < domain.pslg.points.size(); ++i) {
    if (domain.pslg.point_markers[i] != 2) continue;
    ++far_points;
    CHECK(distance(domain.pslg.points[i], {1, 0}) == doctest::Approx(20).scale(0));
  }
  CHECK(far_points == 79);  // 2 pi 10 / (10 * 0.08), rounded up
}

TEST_CASE("bodies_that_do_not_fit_are_refused_by_name_and_place") {
  const std::string second =
      "[[body]]\nname = \"main\"\nnaca = \"0012\"\n[[body]]\nname = \"flap\"\nnaca = \"0012\"\n";
  has(refusal(second), "bodies \"main\" and \"flap\" overlap or touch");
  has(refusal(second + "translation = [0.5, 0.01]\n"),
      "bodies \"main\" and \"flap\" overlap or touch: the edge from (");
  has(refusal(second + "translation = [1, 0]\n"), "overlap or touch");
  has(refusal(second + "scale = 0.1\ntranslation = [0.3, 0]\n"),
      "c.toml:7: body \"flap\" lies inside body \"main\"");
  const std::string one = "[[body]]\nname = \"main\"\nnaca = \"0012\"\n";
  has(refusal(one + "[farfield]\ndistance = 0.4\n"), "the far field is smaller than body \"main\"");
  has(refusal(one + "[farfield]\ndistance = 5\ncentre = [8, 0]\n"),
      "body \"main\" is not inside the far field: its point (1, 0) is out");
  has(refusal(one + "[farfield]\nspacing = 1e-9\n"), "farfield.spacing");
  has(refusal("[[body]]\nnaca = \"2012\"\n"), "c.toml:3: NACA 2012");
}

TEST_CASE("an_airfoil_file_is_resampled_and_its_faults_are_named") {
  const TemporaryFolder folder;
  std::string diamond =
      "diamond\n1 0\n0.75 0.025\n0.5 0.05\n0.25 0.025\n0 0\n0.25 -0.025\n0.5 -0.05\n0.75 -0.025\n1 0\n";
  folder.write("good.dat", diamond);
  const auto make = [&](const std::string& name, const std::string& more) {
    const auto file =
        folder.write("c.toml", flow + "[[body]]\nname = \"wing\"\nfile = \"" + name + "\"\n" + more);
    return make_domain(read_case(file));
  };
  const DomainGeometry domain = make("good.dat", "corner_angle_deg = 5\n");
  CHECK(domain.outlines[0].size() > 200);
  CHECK(rounded_area2(domain.outlines[0]) == doctest::Approx(0.1).scale(0).epsilon(1e-9));
  folder.write("twice.dat", diamond + "1 0\n");
  REQUIRE(make("twice.dat", "").warnings.size() == 1);
  has(make("twice.dat", "").warnings[0], "twice.dat");
  CHECK(domain.warnings.empty());
  folder.write("crossed.dat", "crossed\n1 0\n0.5 0.05\n0.2 -0.04\n0 0\n0.2 0.04\n0.5 -0.05\n1 0\n");
  has(input_error_of([&] { return make("crossed.dat", ""); }), "crossed.dat");
  folder.write("few.dat", "few\n1 0\n0 0.1\n1 0\n");
  has(input_error_of([&] { return make("few.dat", ""); }), "few.dat");
}

TEST_CASE("a_domain_file_keeps_its_segments_and_gets_names_and_a_size") {
  const TemporaryFolder folder;
  folder.write("box.poly",
               "4 2 0 0\n1 0 0\n2 1 0\n3 1 0.7\n4 0 0.7\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 1\n4 4 1 3\n0\n");
  const std::string head =
      "domain = \"box.poly\"\n[flow]\nmach = 2\n[boundary.1]\nname = \"wall\"\nkind = "
      "\"slip-wall\"\n[boundary.2]\nkind = \"supersonic-outflow\"\n";
  const auto make = [&](const std::string& text) {
    const Case c = read_case(folder.write("c.toml", text));
    DomainGeometry domain = make_domain(c);
    name_markers(c, domain.pslg);
    return domain;
  };
  const DomainGeometry domain =
      make(head + "[boundary.3]\nname = \"inlet\"\nkind = \"supersonic-inflow\"\n[mesher]\nsize = 0.1\n");
  CHECK(domain.pslg.points.size() == 4);
  CHECK(domain.pslg.marker_names.at(1) == "wall");
  CHECK(domain.pslg.marker_names.at(3) == "inlet");
  CHECK(domain.sources.empty());
  CHECK(domain.max_size == 0.1);
  CHECK(domain.pslg.points[2] == Point2{1, 0.7});  // as the file has it
  has(input_error_of([&] { return make(head); }), "the boundary marker \"3\"");
  has(input_error_of([&] { return make(head + "[boundary.4]\nkind = \"slip-wall\"\n"); }),
      "no boundary marker \"4\"");
}

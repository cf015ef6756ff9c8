// SPDX-License-Identifier: MIT
#include "leonhard/app/case/case.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "tests/app/input_error_of.hpp"

using namespace leonhard::app;
using leonhard::BoundaryKind;
using leonhard::FluxKind;
using leonhard::LimiterKind;

namespace {

const std::string minimal = "[flow]\nmach = 0.8\n[[body]]\nnaca = \"0012\"\n";

Case parse(const std::string& text) { return parse_case(text, "dir/x.toml"); }

std::string refusal(const std::string& text) {
  return input_error_of([&] { return parse(text); });
}

bool says(const std::string& message, const std::string& part) {
  INFO("message: ", message);
  CHECK(message.find(part) != std::string::npos);
  return message.find(part) != std::string::npos;
}

/// A folder that goes away with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "leonhard_case_test") {
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

TEST_CASE("the_shortest_case_gets_the_documented_defaults") {
  const Case c = parse(minimal);
  CHECK(c.flow.mach == 0.8);
  CHECK(c.flow.gamma == 1.4);
  CHECK(c.title == "x");
  REQUIRE(c.bodies.size() == 1);
  CHECK(c.bodies[0].name == "body1");
  CHECK(c.bodies[0].spacing == 0.01);
  CHECK(c.bodies[0].leading_edge_spacing == 0.01 / 3);
  CHECK(c.bodies[0].trailing_edge_spacing == 0.01 / 3);
  CHECK(c.farfield.spacing == 50 * 0.08);
  CHECK(c.boundary.at("body1").kind == BoundaryKind::slip_wall);
  CHECK(c.boundary.at("farfield").kind == BoundaryKind::far_field);
  CHECK(c.solver.max_iterations == 500);
  CHECK(c.output.folder == "runs/x");
  CHECK(c.text == minimal);
}

TEST_CASE("defaults_follow_the_keys_they_depend_on") {
  const Case c = parse(minimal +
                       "spacing = 0.03\n[mesher]\ngrowth = 0.5\n[farfield]\ndistance = "
                       "10\n[solver]\nmarching = \"explicit\"\n");
  CHECK(c.bodies[0].leading_edge_spacing == 0.03 / 3);
  CHECK(c.farfield.spacing == doctest::Approx(10 * 2 * 3.14159265358979 / 48).scale(0));
  CHECK(c.solver.max_iterations == 50'000);
}

TEST_CASE("every_value_of_a_full_case_arrives") {
  const Case c = parse(R"(title = "two"
[flow]
mach = 2
alpha_deg = -3.5
gamma = 1.3
[[body]]
name = "main"
naca = "2412"
trailing_edge = "closed"
scale = 2
rotation_deg = -10
translation = [1, -0.5]
spacing = 0.02
leading_edge_spacing = 0.001
trailing_edge_spacing = 0.004
[[body]]
naca = "0015"
[farfield]
distance = 20
spacing = 2
centre = [1, 2]
vortex_correction = false
[mesher]
min_angle_deg = 20
growth = 0.1
size = 1.5
max_vertices = 5000
[boundary.farfield]
kind = "supersonic_inflow"
[reference]
length = 3
moment_centre = [0.5, 0.1]
[solver]
order = 1
flux = "kep_matrix"
limiter = "barth-jespersen"
cfl_start = 3
cfl_max = 30
[order]
method = "none"
[partition]
method = "coordinate"
parts = 3
[output]
folder = "out"
close_up = [0, 1, 2, 3]
)");
  CHECK(c.title == "two");
  CHECK(c.flow.alpha_deg == -3.5);
  CHECK(c.bodies[0].trailing_edge == TrailingEdge::closed);
  CHECK(c.bodies[0].translation == leonhard::Vec2{1, -0.5});
  CHECK(c.bodies[0].leading_edge_spacing == 0.001);
  CHECK(c.bodies[1].name == "body2");
  CHECK(c.farfield.centre == leonhard::Point2{1, 2});
  CHECK_FALSE(c.farfield.vortex_correction);
  CHECK(c.mesher.size == 1.5);
  CHECK(c.mesher.max_vertices == 5000);
  CHECK(c.boundary.at("farfield").kind == BoundaryKind::supersonic_inflow);
  CHECK(c.boundary.at("main").kind == BoundaryKind::slip_wall);
  CHECK(c.reference.moment_centre == std::vector<double>{0.5, 0.1});
  CHECK(c.solver.order == 1);
  CHECK(c.solver.flux == FluxKind::kep_matrix);
  CHECK(c.solver.limiter == LimiterKind::barth_jespersen);
  CHECK(c.solver.cfl_max == 30.0);
  CHECK(c.ordering == OrderChoice::none);
  CHECK(c.partitioning == leonhard::graph::PartitionMethod::coordinate);
  CHECK(c.parts == 3);
  CHECK(c.output.close_up.value()[3] == 3);
}

TEST_CASE("a_viscous_case_has_its_gas_its_walls_and_its_inflow") {
  const std::string text = R"(domain = "d.poly"
[flow]
mach = 0.2
reynolds = 5000
prandtl = 0.7
viscosity = "constant"
[boundary.hot]
kind = "no-slip-wall"
temperature = 1.5
[boundary.belt]
kind = "no_slip_wall"
velocity = [1, 0]
[boundary.inlet]
kind = "subsonic-inflow"
total_pressure = 1.1
total_temperature = 1.02
direction = [1, 0.5]
[boundary.outlet]
kind = "pressure-outflow"
pressure = 0.9
)";
  const TemporaryFolder folder;
  folder.write("d.poly", "");
  const Case c = read_case(folder.write("viscous.toml", text));
  CHECK(c.flow.reynolds == 5000.0);
  CHECK(c.flow.prandtl == 0.7);
  CHECK(c.flow.viscosity == ViscosityLaw::constant);
  CHECK(c.boundary.at("hot").kind == BoundaryKind::no_slip_wall);
  CHECK(c.boundary.at("hot").temperature == 1.5);
  CHECK_FALSE(c.boundary.at("belt").temperature.has_value());
  CHECK(c.boundary.at("belt").velocity == std::vector<PlaceValue>{1, 0});
  CHECK(c.boundary.at("inlet").kind == BoundaryKind::subsonic_inflow);
  CHECK(c.boundary.at("inlet").total_pressure == 1.1);
  CHECK(c.boundary.at("inlet").total_temperature == 1.02);
  CHECK(c.boundary.at("inlet").direction == std::vector<PlaceValue>{1, 0.5});
  CHECK(c.boundary.at("outlet").kind == BoundaryKind::pressure_outflow);
  CHECK(c.boundary.at("outlet").pressure == 0.9);
}

TEST_CASE("bodies_in_viscous_flow_are_no_slip_walls_unless_they_say_otherwise") {
  const std::string viscous = "[flow]\nmach = 0.5\nreynolds = 5e3\n[[body]]\nnaca = \"0012\"\n";
  const Case c = parse(viscous);
  CHECK(c.boundary.at("body1").kind == BoundaryKind::no_slip_wall);
  CHECK(c.flow.viscosity == ViscosityLaw::sutherland);
  CHECK(c.flow.temperature == 288.15);
  says(describe(c), "= \"no-slip-wall\"   (default)");
  CHECK(parse(viscous + "[boundary.body1]\nkind = \"slip-wall\"\n").boundary.at("body1").kind ==
        BoundaryKind::slip_wall);
}

TEST_CASE("viscous_keys_that_contradict_each_other_are_refused") {
  const std::string viscous = "[flow]\nmach = 0.5\nreynolds = 5e3\n", body = "[[body]]\nnaca = \"0012\"\n";
  says(refusal("[flow]\nmach = 0.5\nprandtl = 0.7\n" + body),
       "x.toml:3: flow.prandtl is given but without flow.reynolds the flow is inviscid");
  says(refusal("[flow]\nmach = 0.5\nviscosity = \"constant\"\n" + body), "x.toml:3: flow.viscosity is given but");
  says(refusal(viscous + "viscosity = \"constant\"\ntemperature = 300\n" + body),
       "x.toml:5: flow.temperature is given but the viscosity is constant");
  says(refusal("[flow]\nmach = 0.5\nreynolds = 0\n" + body), "flow.reynolds = 0 is not a finite number above 0");
  says(refusal(viscous + "prandtl = -1\n" + body), "flow.prandtl = -1 is not");
  says(refusal(minimal + "[boundary.body1]\nkind = \"no-slip-wall\"\n"),
       "x.toml:6: boundary.body1 is a no-slip wall but the flow is inviscid; give flow.reynolds");
  const auto boundary = [&](const std::string& keys) { return refusal(viscous + body + "[boundary.body1]\n" + keys); };
  says(boundary("kind = \"slip-wall\"\ntemperature = 1\n"),
       "x.toml:8: boundary.body1.temperature is given but only a no-slip-wall, far-field or supersonic-inflow has one");
  says(boundary("kind = \"slip-wall\"\nvelocity = [1, 0]\n"), "boundary.body1.velocity is given but");
  says(boundary("kind = \"no-slip-wall\"\npressure = 1\n"), "only a pressure-outflow, far-field or supersonic-inflow has one");
  says(boundary("kind = \"no-slip-wall\"\ntotal_pressure = 1\n"), "only a subsonic-inflow has one");
  says(boundary("kind = \"no-slip-wall\"\ntotal_temperature = 1\n"), "only a subsonic-inflow has one");
  says(boundary("kind = \"no-slip-wall\"\ndirection = [1, 0]\n"), "only a subsonic-inflow has one");
  says(boundary("kind = \"no-slip-wall\"\ntemperature = 0\n"), "is not a finite number above 0");
  says(boundary("kind = \"no-slip-wall\"\nvelocity = [1]\n"), "is not 2 finite numbers in brackets, in space 3");
  says(boundary("kind = \"subsonic-inflow\"\ndirection = [0, 0]\n"), "x.toml:8: the direction of the inflow is 0");
}

TEST_CASE("a_value_of_the_place_is_a_number_a_formula_or_a_table_and_tells_where_it_is_out_of_range") {
  const std::string head = "domain = \"d.poly\"\n[flow]\nmach = 2\n[boundary.in]\nkind = \"supersonic-inflow\"\n";
  const TemporaryFolder folder;
  folder.write("d.poly", "");
  const auto read = [&](const std::string& keys) { return read_case(folder.write("x.toml", head + keys)).boundary.at("in"); };
  const auto refused = [&](const std::string& keys) { return input_error_of([&] { return read(keys), 0; }); };
  const BoundaryCase in = read("pressure = \"1 + y^2 - min(x, z)*sin(pi/2)\"\nvelocity = [\"x > 1 ? 2 : exp(0)\", 0]\n"
                               "temperature = { along = \"2*y\", at = [0, 1, 3], values = [1, 2, 1] }\n");
  CHECK((*in.pressure)({1, 3, 2}) == doctest::Approx(9));
  CHECK(in.velocity[0]({2, 0, 0}) == 2);
  CHECK(in.velocity[0]({0, 0, 0}) == 1);
  CHECK_FALSE(in.velocity[1].varies());
  for (const auto& [y, value] : {std::pair{-5.0, 1.0}, {0.25, 1.5}, {0.5, 2.0}, {1.0, 1.5}, {9.0, 1.0}})
    CHECK((*in.temperature)({7, y, 0}) == doctest::Approx(value));
  says(input_error_of([&] { return (*in.pressure)({3, 1, 4}) > 0; }),
       "x.toml:6: boundary.in.pressure is -1 at (3, 1, 4); it takes a finite number above 0 at every place");
  says(refused("pressure = \"1 + q*y\"\n"), "x.toml:6: boundary.in.pressure = \"1 + q*y\": ");
  says(refused("pressure = \"1 + q*y\"\n"), "column 5 of the formula; give a formula of x, y and z");
  says(refused("pressure = \"1, 2\"\n"), "it has 2 values");
  says(refused("pressure = \"(1\"\n"), "x.toml:6: boundary.in.pressure");
  says(refused("pressure = \"\"\n"), "x.toml:6: boundary.in.pressure");
  says(refused("velocity = [\"x +\", 0]\n"), "x.toml:6: boundary.in.velocity");
  says(refused("pressure = true\n"), "boundary.in.pressure = true is not a finite number above 0, or of the place");
  says(refused("pressure = { along = \"y\", at = [0, 1] }\n"), "x.toml:6: boundary.in.pressure: the table has no list \"values\"");
  says(refused("pressure = { along = \"y\", at = [0, 1], values = [1] }\n"), "the table has 2 places and 1 values");
  says(refused("pressure = { along = \"y\", at = [0, 0], values = [1, 1] }\n"), "the table's places do not ascend");
  says(refused("pressure = { along = \"y\", at = [0, 1], values = [1, -1] }\n"), "is not a finite number above 0");
  says(refused("pressure = { at = [0, 1], values = [1, 1] }\n"), "does not say along which coordinate");
  says(refused("pressure = { along = \"y\", from = 0 }\n"), "a table has no \"from\"");
}

TEST_CASE("keys_of_space_are_refused_in_the_plane_and_those_of_the_plane_in_space") {
  says(refusal("[flow]\nmach = 1\nbeta_deg = 2\n[[body]]\nnaca = \"0012\"\n"),
       "x.toml:3: flow.beta_deg is given but the flow is one of the plane; remove it");
  says(refusal(minimal + "[reference]\narea = 2\n"), "x.toml:6: reference.area is given but the flow is one of the plane");
  says(refusal(minimal + "[output]\nstations = [0.5]\n"), "x.toml:6: output.stations is given but the flow is one of the plane");
  says(refusal(minimal + "[output]\nstations = []\n"), "is not 1 to 12 finite numbers in brackets");
  says(refusal(minimal + "[reference]\nmoment_centre = [0, 0, 0]\n"),
       "x.toml:6: reference.moment_centre = [0, 0, 0] in a flow of the plane; give 2 numbers");

  const TemporaryFolder folder;
  folder.write("a.su2", "");
  const std::string head = "mesh = \"a.su2\"\n[flow]\nmach = 0.5\n";
  const auto of_space = [&](const std::string& more) {
    const Case c = read_case(folder.write("space.toml", head + more));
    return input_error_of([&] { return require_dimension(c, 3), 0; });
  };
  says(of_space("[farfield]\nvortex_correction = true\n"),
       "space.toml:5: farfield.vortex_correction is given but the flow is one of space");
  says(of_space("[output]\nclose_up = [0, 0, 1, 1]\n"), "space.toml:5: output.close_up is given but");
  says(of_space("[boundary.in]\nkind = \"subsonic-inflow\"\ndirection = [1, 0]\n"),
       "space.toml:6: boundary.in.direction = [1, 0] in a flow of space; give 3 numbers");
  const Case c = read_case(folder.write(
      "space.toml", head + "beta_deg = 3\n[reference]\narea = 2\nmoment_centre = [1, 2, 3]\n"));
  CHECK_NOTHROW(require_dimension(c, 3));
  CHECK(c.flow.beta_deg == 3);
  CHECK(c.reference.area == 2);
  CHECK(c.reference.moment_centre[2] == 3);
}

TEST_CASE("the_initial_field_is_a_vtu_that_exists") {
  const TemporaryFolder folder;
  folder.write("field.vtu", "");
  folder.write("field.su2", "");
  const auto with = [&](const std::string& name) {
    return folder.write("start.toml", minimal + "[initial]\nfield = \"" + name + "\"\n");
  };
  CHECK(read_case(with("field.vtu")).initial.field == folder.write("field.vtu", ""));
  says(input_error_of([&] { return read_case(with("none.vtu")); }), "start.toml:6: initial.field = \"none.vtu\": there is no file");
  says(input_error_of([&] { return read_case(with("field.su2")); }), "is no .vtu; give a field.vtu that solve wrote");
}

TEST_CASE("unknown_keys_and_sections_name_the_line_and_the_nearest_known_one") {
  says(refusal("[flow]\nmahc = 0.8\n"), "dir/x.toml:2: unknown key \"flow.mahc\"; did you mean \"mach\"?");
  says(refusal("[flwo]\nmach = 0.8\n"), "dir/x.toml:1: unknown section \"flwo\"; did you mean \"flow\"?");
  says(refusal("mach = 0.8\n" + minimal), "dir/x.toml:1: unknown key \"mach\"; did you mean \"flow.mach\"?");
  says(refusal(minimal + "spacng = 0.1\n"),
       "dir/x.toml:5: unknown key \"body.body1.spacng\"; did you mean \"spacing\"?");
  says(refusal(minimal + "[boundary.farfield]\nkin = 1\n"),
       "x.toml:6: unknown key \"boundary.farfield.kin\"");
  says(refusal("[[boddy]]\nnaca = \"0012\"\n[flow]\nmach = 1\n"),
       "unknown section \"boddy\"; did you mean \"body\"?");
}

TEST_CASE("a_required_key_that_is_missing_is_named_with_its_section's_line") {
  says(refusal("\n[flow]\nalpha_deg = 1\n[[body]]\nnaca = \"0012\"\n"),
       "dir/x.toml:2: the key \"flow.mach\" is missing");
  says(refusal("[[body]]\nnaca = \"0012\"\n"), "the key \"flow.mach\" is missing");
  says(refusal(minimal + "[boundary.farfield]\n"),
       "dir/x.toml:5: the key \"boundary.farfield.kind\" is missing");
}

TEST_CASE("wrong_types_and_values_out_of_range_are_refused_with_line_key_and_range") {
  struct Bad {
    std::string text, message;
  };
  const std::vector<Bad> bad = {
      {"[flow]\nmach = -0.8\n", "dir/x.toml:2: flow.mach = -0.8 is not a finite number above 0"},
      {"[flow]\nmach = 0\n", "flow.mach = 0 is not a finite number above 0"},
      {"[flow]\nmach = \"0.8\"\n", "flow.mach = \"0.8\" is not a finite number"},
      {"[flow]\nmach = nan\n", "flow.mach = nan is not a finite number"},
      {"[flow]\nmach = inf\n", "flow.mach = inf is not a finite number"},
      {"[flow]\nmach = true\n", "flow.mach = true is not a finite number"},
      {"[flow]\nmach = 1\ngamma = 1\n", "x.toml:3: flow.gamma = 1 is not a finite number above 1"},
      {minimal + "[mesher]\nmin_angle_deg = 34\n",
       "x.toml:6: mesher.min_angle_deg = 34 is not a finite number from 0 below 34"},
      {minimal + "[mesher]\ngrowth = -1\n", "mesher.growth = -1 is not"},
      {minimal + "[mesher]\nmax_vertices = 1.5\n", "mesher.max_vertices = 1.5 is not an integer"},
      {minimal + "[farfield]\ndistance = 0\n", "farfield.distance = 0 is not a finite number above 0"},
      {minimal + "[farfield]\nvortex_correction = 1\n", "is not true or false"},
      {minimal + "translation = [1]\n", "body.body1.translation = [ 1 ] is not 2 finite numbers in brackets"},
      {minimal + "translation = [1, nan]\n", "is not 2 finite numbers"},
      {minimal + "scale = -1\n", "body.body1.scale = -1 is not a finite number above 0"},
      {minimal + "[solver]\norder = 3\n", "solver.order = 3 is not an integer from 1 to 2"},
      {minimal + "[solver]\nflux = \"roe-low-mac\"\n", "did you mean \"roe-low-mach\"?"},
      {minimal + "[solver]\nlimiter = \"venkatakrishan\"\n", "did you mean \"venkatakrishnan\"?"},
      {minimal + "[solver]\nmarching = 1\n", "solver.marching = 1 is not one of \"implicit\", \"explicit\""},
      {minimal + "[solver]\ncfl_start = 9\ncfl_max = 3\n",
       "solver.cfl_start = 9 is above solver.cfl_max = 3"},
      {minimal + "[output]\nclose_up = [1, 0, 0, 1]\n", "is no box"},
      {"flow = 3\n", "dir/x.toml:1: flow = 3 is not a section"},
      {"[flow]\nmach = 1\n[body]\nnaca = \"0012\"\n",
       "dir/x.toml:3: body is not a list of sections; write [[body]]"},
      {"[mesh]\nsize = 1\n",
       "dir/x.toml:1: mesh must be the name of a mesh file in quotes; the mesher's settings go in the "
       "section [mesher]"},
      {minimal + "[boundary]\nfarfield = \"far-field\"\n",
       "dir/x.toml:6: boundary.farfield is not a section"}};
  for (const Bad& entry : bad) says(refusal(entry.text), entry.message);
}

TEST_CASE("keys_that_contradict_each_other_are_refused") {
  says(refusal("[flow]\nmach = 1\n"), "nothing to compute the flow about");
  says(refusal("mesh = \"a.su2\"\n" + minimal), "dir/x.toml:4: \"mesh\" and \"body\" cannot both be given");
  says(refusal("[flow]\nmach = 1\n[[body]]\n"), "body \"body1\" has no shape");
  says(refusal(minimal + "[boundary.farfield]\nkind = \"supersonic-inflow\"\n"),
       "x.toml:6: boundary.farfield is a supersonic inflow but flow.mach is 0.8");
  says(refusal(minimal + "[boundary.farfeld]\nkind = \"far-field\"\n"),
       "dir/x.toml:5: the case has no boundary \"farfeld\"; did you mean \"farfield\"?");
  says(refusal(minimal + "[boundary.farfield]\nkind = \"far-field\"\nname = \"a\"\n"),
       "boundary.farfield.name is given but");
  says(refusal(minimal + "corner_angle_deg = 10\n"), "body.body1.corner_angle_deg is given but");
  says(refusal("[flow]\nmach = 1\n[[body]]\nname = \"a\"\nnaca = \"0012\"\n[[body]]\nname = \"a\"\nnaca = "
               "\"0012\"\n"),
       "dir/x.toml:7: two bodies are named \"a\" (the other: dir/x.toml:4)");
  says(refusal("[flow]\nmach = 1\n[[body]]\nname = \"farfield\"\nnaca = \"0012\"\n"),
       "cannot be a body's name");
  says(refusal("[flow]\nmach = 1\n[[body]]\nnaca = \"012\"\n"),
       "dir/x.toml:4: naca = \"012\" is not a four-digit section");
}

TEST_CASE("files_are_sought_beside_the_case_file_and_must_exist") {
  const TemporaryFolder folder;
  folder.write("a.su2", "");
  folder.write("a.dat", "");
  const auto mesh_case = folder.write("mesh.toml", "mesh = \"a.su2\"\n[flow]\nmach = 0.5\n");
  CHECK(read_case(mesh_case).mesh_file == mesh_case.parent_path() / "a.su2");
  const auto body_case = folder.write("body.toml", "[flow]\nmach = 0.5\n[[body]]\nfile = \"a.dat\"\n");
  CHECK(read_case(body_case).bodies[0].file == body_case.parent_path() / "a.dat");

  const auto no_file = folder.write("no.toml", "[flow]\nmach = 0.5\n[[body]]\nfile = \"b.dat\"\n");
  says(input_error_of([&] { return read_case(no_file); }),
       no_file.string() + ":4: body.body1.file = \"b.dat\": there is no file");
  const auto a_folder = folder.write("folder.toml", "mesh = \".\"\n[flow]\nmach = 0.5\n");
  says(input_error_of([&] { return read_case(a_folder); }), "is not a file");
  const auto idle =
      folder.write("idle.toml", "mesh = \"a.su2\"\n[flow]\nmach = 0.5\n[mesher]\ngrowth = 0.1\n");
  says(input_error_of([&] { return read_case(idle); }),
       "idle.toml:5: mesher.growth is given but the case gives a ready mesh");
  const auto idle_circle =
      folder.write("circle.toml", "mesh = \"a.su2\"\n[flow]\nmach = 0.5\n[farfield]\ndistance = 9\n");
  says(input_error_of([&] { return read_case(idle_circle); }), "farfield.distance is given but");
  const auto both =
      folder.write("both.toml", "[flow]\nmach = 0.5\n[[body]]\nfile = \"a.dat\"\nnaca = \"0012\"\n");
  says(input_error_of([&] { return read_case(both); }), "body \"body1\" has both file and naca");
  const auto edge = folder.write(
      "edge.toml", "[flow]\nmach = 0.5\n[[body]]\nfile = \"a.dat\"\ntrailing_edge = \"sharp\"\n");
  says(input_error_of([&] { return read_case(edge); }), "edge.toml:5: body.body1.trailing_edge is given but");
}

TEST_CASE("unreadable_empty_and_malformed_files_are_refused") {
  says(input_error_of([] { return read_case("nowhere/none.toml"); }),
       "nowhere/none.toml: cannot be read: No such file or directory");
  says(input_error_of([] { return read_case("."); }), "cannot be read: Is a directory");
  says(refusal(" \n\n"), "dir/x.toml: the case file is empty");
  says(refusal("[flow\nmach = 1\n"), "dir/x.toml:1: ");
  says(refusal("[flow]\nmach = 1\nmach = 2\n"), "dir/x.toml:3: ");
  says(refusal("[flow]\nmach = \n"), "dir/x.toml:2: ");
  says(refusal("\xff\xfe"), "dir/x.toml:1: ");
}

TEST_CASE("describe_lists_every_key_once_and_marks_defaults") {
  const std::string text = describe(parse(minimal + "[solver]\norder = 1\n"));
  says(text, "flow.mach ");
  says(text, "= 0.8\n");
  CHECK(text.find("= 0.8   (default)") == std::string::npos);
  for (const KnownKey& known : known_keys()) {
    if (known.key.starts_with("boundary.NAME")) continue;
    const bool of_body = known.key.starts_with("body.") && known.key != "body.name";
    const std::string shown = of_body ? "body.body1" + known.key.substr(4) : known.key;
    std::size_t count = 0;
    for (std::size_t at = text.find("\n" + shown + " "); at != std::string::npos;
         at = text.find("\n" + shown + " ", at + 1))
      ++count;
    if (text.starts_with(shown + " ")) ++count;
    INFO("key: ", shown);
    CHECK(count == 1);
  }
  says(text, "boundary.body1.kind");
}

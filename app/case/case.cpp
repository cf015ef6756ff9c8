// SPDX-License-Identifier: MIT
#include "leonhard/app/case/case.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

#include "leonhard/app/case/section_reader.hpp"
#include "leonhard/app/case/spelling.hpp"
#include "leonhard/kernel/input_error.hpp"

namespace leonhard::app {
namespace {

constexpr std::pair<std::string_view, BoundaryKind> condition_words[] = {
    {"slip-wall", BoundaryKind::slip_wall},
    {"no-slip-wall", BoundaryKind::no_slip_wall},
    {"far-field", BoundaryKind::far_field},
    {"supersonic-inflow", BoundaryKind::supersonic_inflow},
    {"supersonic-outflow", BoundaryKind::supersonic_outflow},
    {"subsonic-inflow", BoundaryKind::subsonic_inflow},
    {"pressure-outflow", BoundaryKind::pressure_outflow},
    {"symmetry", BoundaryKind::symmetry},
    {"periodic", BoundaryKind::periodic}};
constexpr std::pair<std::string_view, ViscosityLaw> viscosity_words[] = {
    {"sutherland", ViscosityLaw::sutherland}, {"constant", ViscosityLaw::constant}};
constexpr std::pair<std::string_view, TrailingEdge> trailing_edge_words[] = {
    {"sharp", TrailingEdge::sharp}, {"open", TrailingEdge::open}, {"closed", TrailingEdge::closed}};
constexpr std::pair<std::string_view, Marching> marching_words[] = {
    {"implicit", Marching::implicit_ptc}, {"explicit", Marching::explicit_multistage}};
constexpr std::pair<std::string_view, FluxKind> flux_words[] = {{"roe", FluxKind::roe},
                                                                {"roe-low-mach", FluxKind::roe_low_mach},
                                                                {"hllc", FluxKind::hllc},
                                                                {"hllc-low-mach", FluxKind::hllc_low_mach},
                                                                {"ausm-plus-up", FluxKind::ausm_plus_up},
                                                                {"rusanov", FluxKind::rusanov},
                                                                {"van-leer", FluxKind::van_leer},
                                                                {"kep-scalar", FluxKind::kep_scalar},
                                                                {"kep-matrix", FluxKind::kep_matrix}};
constexpr std::pair<std::string_view, LimiterKind> limiter_words[] = {
    {"r3", LimiterKind::nishikawa_r3},
    {"venkatakrishnan", LimiterKind::venkatakrishnan},
    {"barth-jespersen", LimiterKind::barth_jespersen},
    {"none", LimiterKind::none}};
constexpr std::pair<std::string_view, GradientKind> gradient_words[] = {
    {"least-squares", GradientKind::least_squares}, {"green-gauss", GradientKind::green_gauss}};
constexpr std::pair<std::string_view, OrderChoice> order_words[] = {
    {"reverse-cuthill-mckee", OrderChoice::reverse_cuthill_mckee}, {"none", OrderChoice::none}};

constexpr auto ready_mesh_reason = "the case gives a ready mesh, which is taken as it is";
constexpr auto domain_reason = "the case gives the whole domain in a file";

FlowCase read_flow(SectionReader flow) {
  FlowCase c;
  c.mach = flow.required_number("mach", {0, 100, true, false});
  c.alpha_deg = flow.number("alpha_deg", c.alpha_deg, between(-180, 180));
  c.beta_deg = flow.number("beta_deg", c.beta_deg, between(-90, 90));
  c.gamma = flow.number("gamma", c.gamma, {1, 10, true, false});
  c.reynolds = flow.optional_number("reynolds", above(0), "none");
  c.prandtl = flow.number("prandtl", c.prandtl, above(0));
  c.viscosity =
      flow.choice("viscosity", std::optional(c.viscosity), SectionReader::Words<ViscosityLaw>(viscosity_words));
  c.temperature = flow.number("temperature", c.temperature, above(0));
  if (!c.reynolds)
    for (const auto key : {"prandtl", "viscosity", "temperature"})
      flow.refuse(key, "without flow.reynolds the flow is inviscid");
  if (c.viscosity == ViscosityLaw::constant) flow.refuse("temperature", "the viscosity is constant");
  return c;
}

/// A section comes from a file or from four digits; the other kind's keys are refused.
void read_shape(SectionReader& reader, BodyCase& body, bool listing) {
  body.file = reader.existing_file("file");
  body.naca = reader.text("naca", "", "none");
  body.trailing_edge = reader.choice("trailing_edge", std::optional(body.trailing_edge),
                                     SectionReader::Words<TrailingEdge>(trailing_edge_words));
  body.corner_angle_deg =
      reader.optional_number("corner_angle_deg", {0, 180, true, true}, "40, at the nose 120");
  if (listing) return;
  if (reader.has("file") == reader.has("naca"))
    throw InputError(
        body.where,
        fmt::format("body \"{}\" has {}", body.name, reader.has("file") ? "both file and naca" : "no shape"),
        "give it either file = \"points.dat\" or naca = \"0012\"");
  if (reader.has("file")) reader.refuse("trailing_edge", "the trailing edge is as the file's points have it");
  if (reader.has("naca")) {
    reader.refuse("corner_angle_deg", "a NACA section has no corner but its trailing edge");
    const bool digits = body.naca.size() == 4 &&
                        std::ranges::all_of(body.naca, [](unsigned char c) { return std::isdigit(c); });
    if (!digits)
      throw InputError(reader.where("naca"),
                       fmt::format("naca = \"{}\" is not a four-digit section", body.naca),
                       "give four digits such as \"0012\"");
  }
}

BodyCase read_body(SectionReader reader, std::size_t number, bool listing) {
  BodyCase body;
  body.where = reader.where("name");
  body.name = reader.text("name", fmt::format("body{}", number), "body1, body2, ...");
  if (body.name.empty() || body.name == "farfield")
    throw InputError(body.where, fmt::format("\"{}\" cannot be a body's name", body.name),
                     "choose another name");
  reader.show_as("body." + body.name);
  read_shape(reader, body, listing);
  body.scale = reader.number("scale", body.scale, above(0));
  body.rotation_deg = reader.number("rotation_deg", body.rotation_deg, between(-360, 360));
  if (const auto move = reader.numbers("translation", 2, "[0, 0]"); !move.empty())
    body.translation = {move[0], move[1]};
  body.spacing = reader.number("spacing", body.spacing, inside(0, 1));
  body.leading_edge_spacing =
      reader.number("leading_edge_spacing", body.spacing / 3, inside(0, 1), "spacing / 3");
  body.trailing_edge_spacing =
      reader.number("trailing_edge_spacing", body.spacing / 3, inside(0, 1), "spacing / 3");
  return body;
}

std::vector<BodyCase> read_bodies(SectionReader& top, CaseLog& log) {
  std::vector<BodyCase> bodies;
  for (const auto& [name, table, where] : top.array_of_sections("body")) {
    bodies.push_back(read_body({log, table, "body", where}, bodies.size() + 1, log.listing));
    for (std::size_t i = 0; i + 1 < bodies.size(); ++i)
      if (bodies[i].name == bodies.back().name)
        throw InputError(
            bodies.back().where,
            fmt::format("two bodies are named \"{}\" (the other: {})", bodies[i].name, bodies[i].where),
            "give each its own name");
  }
  return bodies;
}

MesherCase read_mesher(SectionReader mesher, const Case& c) {
  MesherCase m;
  m.min_angle_deg = mesher.number("min_angle_deg", m.min_angle_deg, {0, 34, false, true});
  m.growth = mesher.number("growth", m.growth, {0, 1, true, false});
  m.size = mesher.optional_number("size", above(0), "no bound");
  m.max_vertices = static_cast<std::size_t>(
      mesher.integer("max_vertices", static_cast<std::int64_t>(m.max_vertices), 3, 4'000'000'000));
  m.crossings = mesher.choice("crossings", std::optional(m.crossings),
                              SectionReader::Words<delaunay::Crossings>(delaunay::named_crossings));
  if (!c.mesh_file.empty())
    for (const auto key : {"min_angle_deg", "growth", "size", "max_vertices", "crossings"})
      mesher.refuse(key, ready_mesh_reason);
  if (!c.domain_file.empty()) mesher.refuse("growth", "without bodies there is nothing to grow from");
  if (c.domain_file.empty()) mesher.refuse("crossings", "bodies must not cross");
  return m;
}

/// The default spacing continues the bodies' growth up to the circle, which gets at least 48 edges.
FarFieldCase read_farfield(SectionReader farfield, const Case& c) {
  FarFieldCase f;
  f.distance = farfield.number("distance", f.distance, above(0));
  f.spacing = farfield.number("spacing", f.distance * std::min(c.mesher.growth, 2 * std::numbers::pi / 48),
                              above(0), "distance * min(growth, 2 pi / 48)");
  if (const auto centre = farfield.numbers("centre", 2, "middle of the bodies"); !centre.empty())
    f.centre = Point2{centre[0], centre[1]};
  f.vortex_correction = farfield.flag("vortex_correction", f.vortex_correction);
  for (const auto key : {"distance", "spacing", "centre"}) {
    if (!c.mesh_file.empty()) farfield.refuse(key, ready_mesh_reason);
    if (!c.domain_file.empty()) farfield.refuse(key, domain_reason);
  }
  return f;
}

/// For bodies the boundaries are known by name, and those that are not mentioned get their default.
void complete_boundaries(Case& c, CaseLog& log) {
  std::vector<std::string> names;
  for (const BodyCase& body : c.bodies) names.push_back(body.name);
  names.push_back("farfield");
  for (const auto& [name, boundary] : c.boundary)
    if (std::ranges::find(names, name) == names.end())
      throw InputError(boundary.where, fmt::format("the case has no boundary \"{}\"", name),
                       suggestion(name, names));
  for (const std::string& name : names) {
    const BoundaryKind fallback = name == "farfield" ? BoundaryKind::far_field
                                  : c.flow.reynolds  ? BoundaryKind::no_slip_wall
                                                     : BoundaryKind::slip_wall;
    const auto word = std::ranges::find(condition_words, fallback, &std::pair<std::string_view, BoundaryKind>::second);
    if (c.boundary.try_emplace(name, BoundaryCase{fallback, name, c.file.string()}).second)
      log.in_force.push_back({"boundary." + name + ".kind", as_toml(word->first), true, c.file.string()});
  }
}

/// What goes with the kind of a boundary; values of other kinds are refused.
void read_boundary_values(SectionReader& reader, BoundaryCase& boundary, bool listing) {
  const auto has = [&](std::initializer_list<BoundaryKind> kinds, std::string_view words, std::initializer_list<std::string_view> keys) {
    if (listing || std::ranges::find(kinds, boundary.kind) != kinds.end()) return true;
    for (const std::string_view key : keys) reader.refuse(key, fmt::format("only a {} has one", words));
    return false;
  };
  const auto value = [&](std::string_view key) { return reader.place_value(key, above(0), "1").value_or(1); };
  if (has({BoundaryKind::no_slip_wall, BoundaryKind::far_field, BoundaryKind::supersonic_inflow},
          "no-slip-wall, far-field or supersonic-inflow", {"temperature", "velocity"})) {
    boundary.temperature = reader.place_value("temperature", above(0), "wall: none, adiabatic; else 1");
    boundary.velocity = reader.place_vector("velocity", "wall: at rest; else that of the free stream");
  }
  if (has({BoundaryKind::subsonic_inflow}, "subsonic-inflow", {"total_pressure", "total_temperature", "direction"})) {
    boundary.total_pressure = value("total_pressure");
    boundary.total_temperature = value("total_temperature");
    boundary.direction = reader.place_vector("direction", "normal to the boundary");
    if (!boundary.direction.empty() && std::ranges::all_of(boundary.direction, [](const PlaceValue& x) { return x == 0; }))
      throw InputError(reader.where("direction"), "the direction of the inflow is 0", "give a vector into the mesh");
  }
  if (has({BoundaryKind::pressure_outflow, BoundaryKind::far_field, BoundaryKind::supersonic_inflow},
          "pressure-outflow, far-field or supersonic-inflow", {"pressure"}))
    boundary.pressure = reader.place_value("pressure", above(0), "1");
  if (has({BoundaryKind::periodic}, "periodic", {"partner", "translation"})) {
    boundary.partner = reader.text("partner", "", "required");
    boundary.translation = reader.vector("translation", "found from the mesh");
    if (boundary.partner.empty() && !listing)
      throw InputError(reader.where("partner"), fmt::format("boundary.{} is periodic but names no partner", boundary.section),
                       "give partner = \"NAME\", the section of the opposite side");
  }
}

/// Two periodic sides name each other.
void check_partners(const Case& c) {
  for (const auto& [name, boundary] : c.boundary) {
    if (boundary.kind != BoundaryKind::periodic) continue;
    const auto partner = c.boundary.find(boundary.partner);
    if (partner == c.boundary.end())
      throw InputError(boundary.where, fmt::format("there is no boundary.{}, which boundary.{} has as its partner", boundary.partner, name),
                       "correct the name, or add the section");
    if (partner->second.kind != BoundaryKind::periodic || partner->second.partner != name || partner->first == name)
      throw InputError(boundary.where,
                       fmt::format("boundary.{} has boundary.{} as its partner, but not the other way round", name, boundary.partner),
                       "make two different sides periodic and each other's partners");
    if (!boundary.translation.empty() && !partner->second.translation.empty())
      throw InputError(boundary.where, fmt::format("boundary.{} and its partner both give a translation", name),
                       "give it for one of them");
  }
}

void read_boundaries(SectionReader& top, Case& c, CaseLog& log) {
  for (const auto& [name, table, where] : top.named_sections("boundary")) {
    SectionReader reader(log, table, "boundary.NAME", where);
    reader.show_as("boundary." + name);
    BoundaryCase boundary;
    boundary.where = where, boundary.section = name;
    boundary.kind =
        reader.choice("kind", std::optional<BoundaryKind>(), SectionReader::Words<BoundaryKind>(condition_words));
    boundary.name = reader.text("name", name, "NAME");
    const bool by_number =
        std::ranges::all_of(name, [](unsigned char ch) { return std::isdigit(ch) || ch == '-'; });
    if (!by_number) reader.refuse("name", "only a marker given by its number needs a name");
    if (boundary.kind == BoundaryKind::supersonic_inflow && c.flow.mach <= 1)
      throw InputError(
          reader.where("kind"),
          fmt::format("boundary.{} is a supersonic inflow but flow.mach is {}", name, c.flow.mach),
          "use \"far-field\"");
    if (boundary.kind == BoundaryKind::no_slip_wall && !c.flow.reynolds && !log.listing)
      throw InputError(reader.where("kind"),
                       fmt::format("boundary.{} is a no-slip wall but the flow is inviscid", name),
                       "give flow.reynolds or use \"slip-wall\"");
    read_boundary_values(reader, boundary, log.listing);
    c.boundary.emplace(name, boundary);
  }
  if (!log.listing) check_partners(c);
  if (!c.bodies.empty() && !log.listing) complete_boundaries(c, log);
}

ReferenceCase read_reference(SectionReader reference) {
  ReferenceCase r;
  r.length = reference.number("length", r.length, above(0));
  r.area = reference.number("area", r.area, above(0));
  if (auto centre = reference.vector("moment_centre", "[0.25, 0]"); !centre.empty()) r.moment_centre = std::move(centre);
  return r;
}

InitialCase read_initial(SectionReader initial) {
  InitialCase i;
  i.field = initial.existing_file("field");
  if (!i.field.empty() && i.field.extension() != ".vtu")
    throw InputError(initial.where("field"), fmt::format("initial.field = \"{}\" is no .vtu", i.field.string()),
                     "give a field.vtu that solve wrote");
  i.pressure = initial.place_value("pressure", above(0), "1");
  i.temperature = initial.place_value("temperature", above(0), "1");
  i.velocity = initial.place_vector("velocity", "that of the free stream");
  if (!i.field.empty())
    for (const auto key : {"pressure", "temperature", "velocity"}) initial.refuse(key, "initial.field has it");
  return i;
}

SolverCase read_solver(SectionReader solver, const FlowCase& flow) {
  SolverCase s;
  s.marching = solver.choice("marching", std::optional(s.marching),
                             SectionReader::Words<Marching>(marching_words));
  s.order = static_cast<int>(solver.integer("order", s.order, 1, 2));
  s.flux = solver.choice("flux", std::optional(s.flux), SectionReader::Words<FluxKind>(flux_words));
  s.limiter =
      solver.choice("limiter", std::optional(usual_limiter(flow.mach, flow.reynolds.has_value())),
                    SectionReader::Words<LimiterKind>(limiter_words));
  s.gradient =
      solver.choice("gradient", std::optional(s.gradient), SectionReader::Words<GradientKind>(gradient_words));
  s.r3_k = solver.number("r3_k", s.r3_k, at_least(0));
  s.venkatakrishnan_k = solver.number("venkatakrishnan_k", s.venkatakrishnan_k, at_least(0));
  s.entropy_fix = solver.number("entropy_fix", s.entropy_fix, between(0, 1));
  s.residual_drop_orders =
      solver.number("residual_drop_orders", s.residual_drop_orders, {0, 16, true, false});
  s.max_iterations = static_cast<int>(
      solver.integer("max_iterations", usual_max_iterations(s.marching), 1, 1'000'000'000, "500 implicit, 50000 explicit"));
  s.cfl_start = solver.optional_number("cfl_start", above(0), "chosen by the marching");
  s.cfl_max = solver.optional_number("cfl_max", above(0), "chosen by the marching");
  if (s.cfl_start && s.cfl_max && *s.cfl_start > *s.cfl_max)
    throw InputError(
        solver.where("cfl_start"),
        fmt::format("solver.cfl_start = {} is above solver.cfl_max = {}", *s.cfl_start, *s.cfl_max),
        "raise cfl_max or lower cfl_start");
  s.settle_tolerance = solver.number("settle_tolerance", s.settle_tolerance, at_least(0));
  s.settle_window = static_cast<int>(
      solver.integer("settle_window", usual_settle_window(s.marching), 0, 1'000'000'000, "100 implicit, 1000 explicit"));
  s.residual_smoothing = solver.number("residual_smoothing", s.residual_smoothing, at_least(0));
  if (s.marching == Marching::implicit_ptc) solver.refuse("residual_smoothing", "only the explicit march smooths its residual");
  return s;
}

OutputCase read_output(SectionReader output, const Case& c) {
  OutputCase o;
  o.folder = output.text("folder", "runs/" + c.file.stem().string(), "runs/ and the case file's name");
  if (o.folder.empty()) throw InputError(output.where("folder"), "output.folder is empty", "name a folder");
  if (const auto box = output.numbers("close_up", 4, "around the bodies"); !box.empty()) {
    if (!(box[0] < box[2] && box[1] < box[3]))
      throw InputError(
          output.where("close_up"),
          fmt::format("output.close_up = [{}, {}, {}, {}] is no box", box[0], box[1], box[2], box[3]),
          "give [xmin, ymin, xmax, ymax] with xmin < xmax and ymin < ymax");
    o.close_up = {box[0], box[1], box[2], box[3]};
  }
  o.stations = output.list("stations", 12, "the middle of the walls");
  return o;
}

/// At most one of mesh, domain and [[body]] may be there; `mesh` is a file's name, the mesher's section is [mesher].
void check_sources(const SectionReader& top, const toml::table* root) {
  if (root && root->get("mesh") && !root->get("mesh")->is_string())
    throw InputError(top.where("mesh"), "mesh must be the name of a mesh file in quotes",
                     "the mesher's settings go in the section [mesher]");
  std::vector<std::string> given;
  for (const auto key : {"mesh", "domain", "body"})
    if (top.has(key)) given.push_back(key);
  if (given.size() > 1)
    throw InputError(top.where(given[1]),
                     fmt::format("\"{}\" and \"{}\" cannot both be given", given[0], given[1]),
                     "keep one of mesh, domain and [[body]]");
}

Case read_sections(CaseLog& log, const toml::table* root) {
  Case c;
  c.file = log.file;
  SectionReader top(log, root, "", log.file.string());
  check_sources(top, root);
  c.title = top.text("title", log.file.stem().string(), "the case file's name");
  c.mesh_file = top.existing_file("mesh");
  c.domain_file = top.existing_file("domain");
  c.flow = read_flow(top.section("flow"));
  c.bodies = read_bodies(top, log);
  c.mesher = read_mesher(top.section("mesher"), c);
  c.farfield = read_farfield(top.section("farfield"), c);
  read_boundaries(top, c, log);
  c.reference = read_reference(top.section("reference"));
  c.initial = read_initial(top.section("initial"));
  c.solver = read_solver(top.section("solver"), c.flow);
  c.ordering = top.section("order").choice("method", std::optional(c.ordering),
                                           SectionReader::Words<OrderChoice>(order_words));
  SectionReader partition = top.section("partition");
  c.partitioning =
      partition.choice("method", std::optional(c.partitioning),
                       SectionReader::Words<graph::PartitionMethod>(graph::named_partition_methods));
  c.parts =
      static_cast<std::size_t>(partition.integer("parts", static_cast<std::int64_t>(c.parts), 1, 1'000'000));
  c.output = read_output(top.section("output"), c);
  return c;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (in && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (!in.is_open() || in.bad() || std::filesystem::is_directory(file))
    throw InputError(file.string(),
                     fmt::format("cannot be read: {}",
                                 std::strerror(std::filesystem::is_directory(file) ? EISDIR : errno)),
                     "give the path of a case file, e.g. examples/naca0012/transonic.toml");
  return std::move(text).str();
}

}  // namespace

Case parse_case(std::string text, const std::filesystem::path& file) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError(file.string(), "the case file is empty", "see docs/case-file.md for what it holds");
  toml::table root;
  try {
    root = toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(at_line(file.string(), error.source().begin.line), std::string(error.description()),
                     "correct the line; TOML's rules are at https://toml.io");
  }
  CaseLog log(file);
  Case c = read_sections(log, &root);
  log.raise();
  if (c.mesh_file.empty() && c.domain_file.empty() && c.bodies.empty())
    throw InputError(file.string(), "nothing to compute the flow about",
                     "add [[body]] sections, or domain = \"file.poly\", or mesh = \"file.su2\"");
  c.text = std::move(text);
  c.keys = std::move(log.in_force);
  if (c.mesh_file.empty()) require_dimension(c, 2);
  return c;
}

Case read_case(const std::filesystem::path& file) { return parse_case(read_text(file), file); }

std::vector<KnownKey> known_keys() {
  CaseLog log("CASE.toml", true);
  (void)read_sections(log, nullptr);
  return std::move(log.known);
}

void require_dimension(const Case& c, int dimension) {
  const std::set<std::string_view> of_plane{"farfield.vortex_correction", "partition.method", "partition.parts", "output.close_up"},
      of_space{"flow.beta_deg", "reference.area", "output.stations"};
  for (const KeyInForce& entry : c.keys) {
    if (entry.by_default) continue;
    if ((dimension == 2 ? of_space : of_plane).contains(entry.key))
      throw InputError(entry.where,
                       fmt::format("{} is given but the flow is one of {}", entry.key, dimension == 2 ? "the plane" : "space"),
                       "remove it");
    const bool is_vector = entry.key == "reference.moment_centre" || entry.key == "initial.velocity" ||
                           (entry.key.starts_with("boundary.") && entry.elements > 0);
    if (is_vector && std::cmp_not_equal(entry.elements, dimension))
      throw InputError(entry.where, fmt::format("{} = {} in a flow of {}", entry.key, entry.value, dimension == 2 ? "the plane" : "space"),
                       fmt::format("give {} numbers", dimension));
  }
}

std::string describe(const Case& c) {
  std::size_t width = 0;
  for (const KeyInForce& entry : c.keys) width = std::max(width, entry.key.size());
  std::string text;
  for (const KeyInForce& entry : c.keys)
    text +=
        fmt::format("{:<{}} = {}{}\n", entry.key, width, entry.value, entry.by_default ? "   (default)" : "");
  return text;
}

}  // namespace leonhard::app

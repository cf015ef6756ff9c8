// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "leonhard/app/case/keys.hpp"
#include "leonhard/delaunay/crossings.hpp"
#include "leonhard/app/case/place_value.hpp"
#include "leonhard/graph/partition.hpp"
#include "leonhard/kernel/point.hpp"
#include "leonhard/solver/steady_options.hpp"

namespace leonhard::app {

enum class TrailingEdge { sharp, open, closed };         ///< body.trailing_edge, see geometry/naca4.hpp
enum class ViscosityLaw { sutherland, constant };        ///< flow.viscosity
enum class OrderChoice { reverse_cuthill_mckee, none };  ///< order.method

/// One [[body]]. Lengths called "chords" are multiples of [reference] length.
struct BodyCase {
  std::string name;            ///< unique in the case; "body1", "body2" ... if not given
  std::filesystem::path file;  ///< airfoil coordinates; empty for a NACA section
  std::size_t element = 0;     ///< of a file of several, from 1; 0: the only one
  std::string naca;            ///< four digits; empty for a file
  TrailingEdge trailing_edge = TrailingEdge::sharp;  ///< NACA sections only
  std::optional<double> corner_angle_deg;  ///< files only: where the outline turns by more it keeps a corner
  double scale = 1;                        ///< first step of the placement, about the origin
  double rotation_deg = 0;                 ///< second step, counter-clockwise about the origin
  Vec2 translation;                        ///< third step
  double spacing = 0.01;                   ///< target edge length on the body, chords
  double leading_edge_spacing = 0.01 / 3;  ///< at the leading edge, chords; default spacing / 3
  double trailing_edge_spacing =
      0.01 / 3;       ///< at the trailing edge and other corners, chords; default spacing / 3
  std::string where;  ///< "case.toml:12", for messages
};

struct FlowCase {
  double mach = 0;       ///< free-stream Mach number, > 0
  double alpha_deg = 0;  ///< angle of attack, degrees, counter-clockwise free stream
  double beta_deg = 0;   ///< sideslip, degrees; space only
  double gamma = 1.4;    ///< ratio of specific heats, > 1
  std::optional<double> reynolds;  ///< of the free stream and reference.length; none: inviscid
  double prandtl = 0.72;
  ViscosityLaw viscosity = ViscosityLaw::sutherland;
  double temperature = 288.15;  ///< of the free stream, kelvin: what Sutherland's law refers to
};

struct FarFieldCase {
  double distance = 50;           ///< radius of the far-field circle, chords
  double spacing = 4;             ///< edge length on it, chords; see read_case for the default
  std::optional<Point2> centre;   ///< default: the middle of the bodies' common box
  bool vortex_correction = true;  ///< point-vortex correction of the far-field state
};

struct MesherCase {
  double min_angle_deg = 28;
  double growth = 0.08;        ///< growth of the edge length per unit of distance from the bodies
  std::optional<double> size;  ///< largest edge length anywhere, chords
  std::size_t max_vertices = 1'000'000;
  delaunay::Crossings crossings = delaunay::Crossings::split;  ///< of a domain's segments
};

/// [boundary.NAME]: NAME is a body's name, "farfield", a marker's name in a mesh file, or a marker's number.
struct BoundaryCase {
  BoundaryKind kind = BoundaryKind::slip_wall;
  std::string name;   ///< for a marker given by its number: what to call it; else NAME itself
  std::string where;  ///< "case.toml:12"
  // Values of the kinds that have them; over those of the free stream.
  std::optional<PlaceValue> temperature{};  ///< no_slip_wall: none: adiabatic; far_field, supersonic_inflow: none: 1
  /// In free-stream speeds. no_slip_wall: empty: at rest; far_field, supersonic_inflow: empty: that of the free stream.
  std::vector<PlaceValue> velocity{};
  PlaceValue total_pressure = 1, total_temperature = 1;  ///< subsonic_inflow
  std::vector<PlaceValue> direction{};                   ///< subsonic_inflow; empty: normal to the boundary
  std::optional<PlaceValue> pressure{};                  ///< pressure_outflow, far_field, supersonic_inflow; none: 1
  std::string partner{};              ///< periodic: the other side's NAME
  std::string section{};              ///< NAME
  std::vector<double> translation{};  ///< periodic: from this side to its partner; empty: found from the mesh
};

struct ReferenceCase {
  double length = 1;  ///< chord: unit of every length in "chords" and of the coefficients
  double area = 1;    ///< space only
  std::vector<double> moment_centre{0.25, 0, 0};  ///< three numbers where it is not given
};

struct InitialCase {
  std::filesystem::path field;  ///< a field.vtu of another run; empty: what follows
  std::optional<PlaceValue> pressure{}, temperature{};  ///< over those of the free stream; none: 1
  std::vector<PlaceValue> velocity{};                   ///< in free-stream speeds; empty: that of the free stream

  [[nodiscard]] bool has_values() const { return pressure || temperature || !velocity.empty(); }
};

struct SolverCase {
  Marching marching = SteadyOptions{}.marching;
  int order = 2;
  FluxKind flux = SteadyOptions{}.flux;
  LimiterKind limiter = usual_limiter(0, false);
  GradientKind gradient = SteadyOptions{}.gradient;
  double r3_k = SteadyOptions{}.r3_k;
  double venkatakrishnan_k = SteadyOptions{}.venkatakrishnan_k;
  double residual_drop_orders = 8;
  double entropy_fix = 0.05;
  int max_iterations = 500;         ///< default 500 implicit, 50,000 explicit
  std::optional<double> cfl_start;  ///< none: chosen by the marching kind
  std::optional<double> cfl_max;
  double settle_tolerance = 1e-6;
  int settle_window = 100;  ///< default 100 implicit, 1000 explicit
  double residual_smoothing = 0;  ///< explicit only
};

struct OutputCase {
  std::filesystem::path folder;                   ///< relative to the current folder
  std::optional<std::array<double, 4>> close_up;  ///< xmin, ymin, xmax, ymax of the close-up pictures
  std::vector<double> stations;                   ///< y of the planes on which Cp is drawn, space only; empty: the middle of the walls
};

/// A case: plain data, read and checked by read_case. Either mesh_file, or domain_file, or bodies is set.
struct Case {
  std::filesystem::path file;  ///< as given
  std::string text;            ///< the file's text as read
  std::string title;           ///< default: the file's stem

  std::filesystem::path mesh_file;    ///< a ready mesh; empty if none
  std::filesystem::path domain_file;  ///< a planar straight-line graph; empty if none
  std::vector<BodyCase> bodies;

  FlowCase flow;
  FarFieldCase farfield;
  MesherCase mesher;
  std::map<std::string, BoundaryCase> boundary;  ///< by NAME; for bodies, complete with the defaults
  ReferenceCase reference;
  InitialCase initial;
  SolverCase solver;
  OrderChoice ordering = OrderChoice::reverse_cuthill_mckee;
  graph::PartitionMethod partitioning = graph::PartitionMethod::spectral;
  std::size_t parts = 8;
  OutputCase output;

  std::vector<KeyInForce> keys;  ///< every key with the value in force, in the order of docs/case-file.md
};

/// Read a case file and check every key before any work: its name, type and range, required keys, keys that
/// contradict each other, and that the files it names exist. Paths in it are relative to the case file.
///
/// throws InputError naming file, line and key; an unknown key comes with the nearest known one.
[[nodiscard]] Case read_case(const std::filesystem::path& file);

/// As read_case, from text already in memory; `file` names it in messages and anchors relative paths.
[[nodiscard]] Case parse_case(std::string text, const std::filesystem::path& file);

/// Refuse the keys that are given but have no meaning in a flow of the plane (2) or of space (3), and vectors of the
/// other dimension. read_case does so itself where the case names no mesh.
/// throws  InputError naming file, line and key
void require_dimension(const Case&, int dimension);

/// Every key with the value in force, one a line, defaults marked as such.
[[nodiscard]] std::string describe(const Case&);

/// All keys, in the order in which they are read.
[[nodiscard]] std::vector<KnownKey> known_keys();

}  // namespace leonhard::app

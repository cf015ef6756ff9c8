// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/constrained/refiner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "leonhard/delaunay/constrained/split_points.hpp"
#include "leonhard/kernel/predicates.hpp"
#include "leonhard/mesh/quality.hpp"

namespace leonhard::delaunay {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

bool Refiner::PieceTask::operator<(const PieceTask& other) const {
  if (length2 != other.length2) return length2 < other.length2;
  return std::tie(other.low, other.high) < std::tie(low, high);
}

bool Refiner::TriangleTaskOrder::operator()(const TriangleTask& a, const TriangleTask& b) const {
  if (a.shortest2 != b.shortest2) return b.shortest2 < a.shortest2;
  const auto sorted = [this](const TriangleTask& task) {
    std::array<Point2, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = cells->point(task.corners[i]);
    std::sort(at.begin(), at.end());
    return at;
  };
  return sorted(b) < sorted(a);
}

Refiner::Refiner(ConstrainedTriangulation& cells, const RefineOptions& options,
                 std::vector<double> region_areas)
    : cells_(cells),
      topology_(cells.topology()),
      options_(options),
      bounds_(options.min_angle_deg, options.size, options.max_area),
      angles_(cells),
      region_areas_(std::move(region_areas)),
      angle_reach_(options.min_angle_deg > 0 ? off_centre_reach(options.min_angle_deg) : infinity),
      chain_of_vertex_(cells.points().size(), no_chain),
      triangle_tasks_(TriangleTaskOrder{&cells}),
      piece_excuse_(cells.pieces().size(), Excuse::none),
      triangle_excuse_(topology_.triangle_count(), Excuse::none) {
  // With a lens of angle 180 - 2 bound, a vertex outside makes no angle below the bound with the piece.
  const double lens = std::cos(2 * std::clamp(options.min_angle_deg, 20.0, 40.0) * std::numbers::pi / 180);
  lens_cosine2_ = lens * lens;
  for (const Piece& piece : cells.pieces()) {
    chain_of_piece_.push_back(static_cast<std::uint32_t>(chains_.size()));
    chains_.push_back({piece.from, piece.to});
  }
  std::vector<bool> used(cells.points().size(), false);
  for (std::size_t i = 0; i < topology_.triangle_count(); ++i)
    for (unsigned k = 0; k < 3; ++k)
      if (const VertexId v = topology_.corner(AnyTriangleId::from(i), k); v != GhostTriangulation::ghost)
        used[v.index()] = true;
  vertex_count_ = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

void Refiner::run(RefineReport& report) {
  enqueue_all();
  constexpr std::size_t poll = 64;
  report.outcome = RefineOutcome::achieved;
  for (std::size_t task = 0; !piece_tasks_.empty() || !triangle_tasks_.empty(); ++task) {
    if (vertex_count_ >= options_.max_vertices) {
      report.outcome = RefineOutcome::vertex_budget_spent;
      break;
    }
    if (task % poll == 0) {
      if (options_.progress.stop_requested()) {
        report.outcome = RefineOutcome::stopped;
        break;
      }
      const auto done = static_cast<double>(task);
      options_.progress("refine", done / (done + static_cast<double>(triangle_tasks_.size())));
    }
    if (!piece_tasks_.empty()) {
      const PieceTask next = piece_tasks_.top();
      piece_tasks_.pop();
      split(next);
    } else {
      const TriangleTask next = triangle_tasks_.top();
      triangle_tasks_.pop();
      treat(next);
    }
  }
  account(report);
}

// ---- queues ----

CornerPoints Refiner::corners_of(AnyTriangleId t) const {
  return canonical(cells_.point(topology_.corner(t, 0)), cells_.point(topology_.corner(t, 1)),
                   cells_.point(topology_.corner(t, 2)));
}

double Refiner::region_area(AnyTriangleId t) const {
  if (cells_.region_of().empty()) return -1;
  const std::uint32_t region = cells_.region_of()[t.index()];
  return region == 0 ? -1 : region_areas_[region - 1];
}

void Refiner::enqueue_all() {
  for (const PieceId p : cells_.pieces().ids()) enqueue_if_needed(p);
  for (std::size_t i = 0; i < topology_.triangle_count(); ++i)
    if (!topology_.is_ghost(AnyTriangleId::from(i))) enqueue(AnyTriangleId::from(i));
}

void Refiner::enqueue(AnyTriangleId t) {
  const CornerPoints corners = corners_of(t);
  const Shape shape = shape_of(corners);
  const TriangleBounds::Miss miss = bounds_.miss(corners, shape, region_area(t));
  if (!miss) return;
  triangle_tasks_.push(
      {shape.shortest2, miss, t, {topology_.corner(t, 0), topology_.corner(t, 1), topology_.corner(t, 2)}});
}

void Refiner::enqueue(PieceId p) {
  const Piece& piece = cells_.piece(p);
  const Point2 a = cells_.point(piece.from), b = cells_.point(piece.to);
  piece_tasks_.push({dot(b - a, b - a), std::min(a, b), std::max(a, b), p, piece.from, piece.to});
}

void Refiner::enqueue_if_needed(PieceId p) {
  const Piece& piece = cells_.piece(p);
  bool needed = too_long(piece);
  for (const SideId s : {piece.side, topology_.twin(piece.side)})
    needed = needed || (is_real(s) && encroaches(cells_.point(topology_.apex(s)), piece));
  if (needed) enqueue(p);
}

/// Whether v, which sees the piece, lies in its diametral lens.
bool Refiner::encroaches(Point2 v, const Piece& piece) const {
  const Point2 a = cells_.point(piece.from), b = cells_.point(piece.to);
  if (kernel::in_diametral_circle(v, a, b) != Sign::positive) return false;
  const Vec2 to_a = a - v, to_b = b - v;
  const double cosine = dot(to_a, to_b);
  return cosine * cosine >= lens_cosine2_ * dot(to_a, to_a) * dot(to_b, to_b);
}

bool Refiner::too_long(const Piece& piece) const {
  if (!bounds_.has_size()) return false;
  const Point2 a = cells_.point(piece.from), b = cells_.point(piece.to);
  const double bound = TriangleBounds::longest_in_targets * bounds_.size_at(middle(a, b));
  return dot(b - a, b - a) > bound * bound;
}

// ---- triangles ----

void Refiner::treat(const TriangleTask& task) {
  for (unsigned i = 0; i < 3; ++i)
    if (topology_.corner(task.triangle, i) != task.corners[i]) return;  // it is gone
  triangle_excuse_[task.triangle.index()] = try_to_remove(task);
}

/// Insert a vertex that removes the triangle; or queue pieces that must be split before, and then the triangle
/// again; or say why neither can be done.
Refiner::Excuse Refiner::try_to_remove(const TriangleTask& task) {
  const CornerPoints corners = corners_of(task.triangle);
  const Shape shape = shape_of(corners);
  if (!task.miss.size && spans_equal_shells(task.triangle, corners, shape)) return Excuse::small_input_angle;
  const Point2 p = off_centre(corners, shape, reach(corners, shape, task.miss));
  if (!is_finite(p)) return Excuse::rounding;

  std::vector<PieceId> in_the_way;
  const Site site = find_site(task.triangle, p);
  if (site.kind == Site::Kind::taken) return Excuse::rounding;
  if (site.kind == Site::Kind::blocked) {
    in_the_way.push_back(*cells_.piece_of(site.side));
  } else {
    site.kind == Site::Kind::on_side ? cavity_.start(topology_, site.side)
                                     : cavity_.start(topology_, topology_.triangle(site.side));
    grow_cavity(p);
    const std::vector<AnyTriangleId>& destroyed = cavity_.triangles();
    if (std::find(destroyed.begin(), destroyed.end(), task.triangle) == destroyed.end())
      return Excuse::rounding;
    if (too_close(p)) return Excuse::min_edge;
    for (const Cavity::Border& b : cavity_.border())
      if (const MaybeId<PieceId> piece = cells_.piece_of(b.inner);
          piece && encroaches(p, cells_.piece(*piece)))
        in_the_way.push_back(*piece);
  }
  if (!in_the_way.empty()) {
    Excuse excuse = piece_excuse_[in_the_way.front()];
    for (const PieceId piece : in_the_way)
      if (piece_excuse_[piece] == Excuse::none) {
        enqueue(piece);
        excuse = Excuse::none;
      }
    if (excuse == Excuse::none) triangle_tasks_.push(task);
    return excuse;
  }
  const VertexId v = cells_.add_point(p);
  chain_of_vertex_.push_back(no_chain);
  cells_.fill(cavity_, v);
  ++vertex_count_;
  ++inserted_;
  enqueue_fan(v);
  return triangle_excuse_[task.triangle.index()];
}

/// Whether the shortest edge joins two segments that meet at a small angle, at equal distance from where they
/// meet: then splitting would only make it shorter (Miller, Pav and Walkington 2003).
bool Refiner::spans_equal_shells(AnyTriangleId t, const CornerPoints& corners, const Shape& shape) const {
  const auto vertex = [&](unsigned i) {
    return topology_.corner(t, (corners.first + shape.shortest + i) % 3);
  };
  const VertexId p = vertex(1), q = vertex(2);
  if (chain_of_vertex_[p] == no_chain || chain_of_vertex_[q] == no_chain) return false;
  const Chain& c = chains_[chain_of_vertex_[p]];
  const Chain& d = chains_[chain_of_vertex_[q]];
  for (const VertexId w : {c.from, c.to}) {
    if (chain_of_vertex_[p] == chain_of_vertex_[q] || (w != d.from && w != d.to) || !angles_.is_acute(w))
      continue;
    const Vec2 to_p = cells_.point(p) - cells_.point(w), to_q = cells_.point(q) - cells_.point(w);
    const double a = norm(to_p), b = norm(to_q);
    const double tolerance = std::max(1e-3, 4 * angles_.shell_tolerance(w));
    if (dot(to_p, to_q) > 0.5 * a * b && std::abs(a - b) <= tolerance * std::max(a, b)) return true;
  }
  return false;
}

/// How far from the shortest edge, in its lengths, the new vertex may lie.
///
/// Where the triangle is too large and its shortest edge is not: as far as makes the new triangle's other edges one
/// target length long, as an advancing front would (Rebay 1993), so that sizes grow evenly from the boundary.
double Refiner::reach(const CornerPoints& t, const Shape& shape, const TriangleBounds::Miss& miss) const {
  if (!miss.size || !bounds_.has_size()) return miss.angle ? angle_reach_ : infinity;
  constexpr double equilateral = 0.8660254037844386;
  const double target2 = std::pow(bounds_.size_at(off_centre(t, shape, equilateral)), 2);
  constexpr double longest2 = TriangleBounds::longest_in_targets * TriangleBounds::longest_in_targets;
  if (shape.shortest2 > longest2 * target2) return infinity;
  return std::sqrt(std::max(target2 / shape.shortest2 - 0.25, 0.25));
}

/// Walk towards p. Crossing an edge that is locally Delaunay brings the circle nearer to p (its power falls), so the
/// walk ends; where p lies beyond two sides, coordinates decide, not numbers.
Refiner::Site Refiner::find_site(AnyTriangleId from, Point2 p) const {
  const auto side_of_p = [&](SideId s) {
    return kernel::orient2d(cells_.point(topology_.origin(s)), cells_.point(topology_.destination(s)), p);
  };
  AnyTriangleId t = from;
  while (true) {
    MaybeId<SideId> open, closed, through;
    std::size_t zeros = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const SideId s = topology_.side(t, i);
      const Sign sign = side_of_p(s);
      if (sign == Sign::zero) {
        ++zeros;
        through = s;
      }
      if (sign != Sign::negative) continue;
      MaybeId<SideId>& beyond = cells_.is_constrained(s) ? closed : open;
      if (!beyond || lexicographically_first(s, *beyond)) beyond = s;
    }
    if (open) {
      t = topology_.triangle(topology_.twin(*open));
      continue;
    }
    if (closed) return {Site::Kind::blocked, *closed};
    if (zeros == 2) return {Site::Kind::taken, *through};
    if (zeros == 0) return {Site::Kind::in_triangle, topology_.side(t, 0)};
    return {cells_.is_constrained(*through) ? Site::Kind::blocked : Site::Kind::on_side, *through};
  }
}

bool Refiner::lexicographically_first(SideId s, SideId t) const {
  return cells_.point(topology_.origin(s)) < cells_.point(topology_.origin(t));
}

/// Grow the cavity, already started, to all that a vertex at p destroys: over no piece. It stays star-shaped, since
/// a triangle behind a side that p sees from within, whose circle holds p, makes a convex quadrilateral with it.
void Refiner::grow_cavity(Point2 p) {
  cavity_.grow(topology_, [&](SideId inner) {
    if (cells_.is_constrained(inner)) return false;
    const AnyTriangleId behind = topology_.triangle(topology_.twin(inner));
    if (topology_.is_ghost(behind)) return false;
    return kernel::incircle_perturbed(cells_.point(topology_.corner(behind, 0)),
                                      cells_.point(topology_.corner(behind, 1)),
                                      cells_.point(topology_.corner(behind, 2)), p) == Sign::positive;
  });
}

/// Whether p is nearer than min_edge to a vertex that it would share an edge with.
bool Refiner::too_close(Point2 p) const {
  if (!(options_.min_edge > 0)) return false;
  return std::any_of(cavity_.border().begin(), cavity_.border().end(), [&](const Cavity::Border& b) {
    return b.from != GhostTriangulation::ghost && distance(p, cells_.point(b.from)) < options_.min_edge;
  });
}

// ---- pieces ----

void Refiner::split(const PieceTask& task) {
  const PieceId first = task.piece;
  const Piece& piece = cells_.piece(first);
  if (piece.from != task.from || piece.to != task.to || piece_excuse_[first] != Excuse::none) return;
  Point2 m = split_site(piece);
  if (!can_split_at(piece, m)) m = middle(cells_.point(piece.from), cells_.point(piece.to));
  if (!can_split_at(piece, m)) {
    piece_excuse_[first] = Excuse::rounding;
    return;
  }
  cavity_.start(topology_, piece.side);
  cells_.release(first);
  grow_cavity(m);
  if (too_close(m)) {
    cells_.restore(first);
    piece_excuse_[first] = Excuse::min_edge;
    return;
  }
  const std::uint32_t chain = chain_of_piece_[first];
  const Chain ends = chains_[chain];
  if (kernel::orient2d(cells_.point(ends.from), cells_.point(ends.to), m) != Sign::zero) ++rounded_splits_;

  const VertexId v = cells_.add_point(m);
  chain_of_vertex_.push_back(chain);
  cells_.fill(cavity_, v);
  const PieceId second = cells_.split_piece(first, v, cavity_);
  chain_of_piece_.push_back(chain);
  piece_excuse_.push_back(Excuse::none);
  ++vertex_count_;
  ++inserted_;
  ++segment_splits_;
  enqueue_fan(v);
  enqueue_if_needed(first);
  enqueue_if_needed(second);
}

/// The middle, or a shell about the one end at which segments meet at a small angle.
Point2 Refiner::split_site(const Piece& piece) const {
  const Point2 a = cells_.point(piece.from), b = cells_.point(piece.to);
  const bool acute_from = angles_.is_acute(piece.from), acute_to = angles_.is_acute(piece.to);
  if (acute_from == acute_to) return middle(a, b);
  return acute_from ? shell_point(a, b, angles_.shell_tolerance(piece.from))
                    : shell_point(b, a, angles_.shell_tolerance(piece.to));
}

/// Whether the piece can be bent to m, which need not be exactly on it: all triangles stay positive, and the two
/// beside the piece are rightly destroyed.
bool Refiner::can_split_at(const Piece& piece, Point2 m) const {
  if (!is_finite(m)) return false;
  for (const SideId s : {piece.side, topology_.twin(piece.side)}) {
    if (!is_real(s)) continue;
    const Point2 from = cells_.point(topology_.origin(s)), to = cells_.point(topology_.destination(s)),
                 apex = cells_.point(topology_.apex(s));
    if (kernel::orient2d(apex, from, m) != Sign::positive ||
        kernel::orient2d(to, apex, m) != Sign::positive ||
        kernel::incircle_perturbed(from, to, apex, m) != Sign::positive)
      return false;
  }
  return true;
}

// ---- after each vertex, and at the end ----

/// Queue what the fan about the new vertex v made necessary.
void Refiner::enqueue_fan(VertexId v) {
  triangle_excuse_.resize(topology_.triangle_count());
  for (const AnyTriangleId t : cavity_.triangles()) {
    triangle_excuse_[t.index()] = Excuse::none;
    if (!topology_.is_ghost(t)) enqueue(t);
  }
  for (const Cavity::Border& b : cavity_.border()) {
    const MaybeId<PieceId> piece = cells_.piece_of(b.inner);
    if (piece && is_real(b.inner) && encroaches(cells_.point(v), cells_.piece(*piece))) enqueue(*piece);
  }
}

void Refiner::account(RefineReport& report) const {
  report.inserted = inserted_;
  report.segment_splits = segment_splits_;
  report.rounded_splits = rounded_splits_;
  report.min_angle_deg = 180;
  for (std::size_t i = 0; i < topology_.triangle_count(); ++i) {
    const AnyTriangleId t = AnyTriangleId::from(i);
    if (topology_.is_ghost(t)) continue;
    const CornerPoints corners = corners_of(t);
    const TriangleQuality quality = mesh::triangle_quality(corners.at[0], corners.at[1], corners.at[2]);
    report.min_angle_deg = std::min(report.min_angle_deg, quality.min_angle_deg);
    report.max_angle_deg = std::max(report.max_angle_deg, quality.max_angle_deg);
    const TriangleBounds::Miss miss = bounds_.miss(corners, shape_of(corners), region_area(t));
    if (!miss) continue;
    report.below_angle += miss.angle ? 1 : 0;
    report.above_size += miss.size ? 1 : 0;
    switch (triangle_excuse_[i]) {
      case Excuse::none:
        break;  // work left undone: the outcome says so
      case Excuse::small_input_angle:
        ++report.excused_small_input_angle;
        break;
      case Excuse::min_edge:
        ++report.excused_min_edge;
        break;
      case Excuse::rounding:
        ++report.excused_rounding;
        break;
    }
  }
  if (report.outcome == RefineOutcome::achieved && report.below_angle + report.above_size > 0)
    report.outcome = RefineOutcome::small_angles_left;
}

}  // namespace leonhard::delaunay

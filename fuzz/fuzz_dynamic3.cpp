// SPDX-License-Identifier: MIT
// Sequences of insertions, removals and queries in space from bytes, on small integer grids, nearly tenths and raw
// doubles: every invariant after each step, queries against a look at all vertices, and at the end the tetrahedra from
// scratch by every algorithm.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "fuzz/fuzz_input.hpp"
#include "leonhard/delaunay/dynamic_tetrahedralization.hpp"
#include "leonhard/delaunay/tetrahedralize.hpp"
#include "leonhard/kernel/stages/exact.hpp"
#include "leonhard/mesh/fingerprint.hpp"
#include "leonhard/mesh/validate.hpp"

namespace {

using namespace leonhard;
using delaunay::DynamicTetrahedralization;
using delaunay::SpaceExtent;
using Kind = delaunay::SpaceLocation::Kind;

/// The tetrahedralisation, what it must know, and how it came to be.
class Sequence {
 public:
  void insert(const Point3& p, MaybeId<VertexId> hint) {
    note("insert", p);
    const auto [v, is_new] = sites_.insert(p, hint);
    const auto known = ids_.find(p);
    require(is_new == (known == ids_.end()), "insert tells new from known wrongly");
    require(is_new || known->second == v, "an id has changed");
    ids_.emplace(p, v);
    check();
  }
  void insert(const std::vector<Point3>& points) {
    for (const Point3& p : points) note("insert", p);
    const std::vector<VertexId> vertices = sites_.insert(points);
    for (std::size_t i = 0; i < points.size(); ++i) ids_.emplace(points[i], vertices[i]);
    check();
  }
  void remove(std::size_t which) {
    if (ids_.empty()) return;
    auto chosen = ids_.begin();
    std::advance(chosen, which % ids_.size());
    note("remove", chosen->first);
    sites_.remove(chosen->second);
    ids_.erase(chosen);
    check();
  }
  void ask(const Point3& p, MaybeId<VertexId> hint) {
    note("ask", p);
    const delaunay::SpaceLocation at = sites_.locate(p, hint);
    require((at.kind == Kind::on_vertex) == (ids_.find(p) != ids_.end()), "locate finds a vertex wrongly");
    require(at.kind == Kind::on_vertex || at.kind == Kind::outside ||
                (at.kind == Kind::in_span) == (sites_.extent() != SpaceExtent::space),
            "locate gives an answer that the extent rules out");
    require(sites_.locate(p) == at, "the hint changes the location");
    check_nearest(p, sites_.nearest_vertex(p, hint));
  }
  void check_from_scratch() const {
    std::vector<Point3> points;
    for (const auto& [p, v] : ids_) points.push_back(p);
    const TetMesh mesh = sites_.to_mesh().mesh;
    if (sites_.extent() == SpaceExtent::space) {
      const auto broken = mesh::validate(mesh);
      require(!broken, broken.value_or(""));
    }
    const Fingerprint mine = mesh::fingerprint(mesh);
    for (const auto& named : delaunay::named_tet_algorithms) {
      delaunay::TetrahedralizeOptions options;
      options.algorithm = named.algorithm;
      require(mine == mesh::fingerprint(delaunay::tetrahedralize(points, options).mesh),
              "tetrahedralize() gives other tetrahedra by " + std::string(named.name));
    }
  }
  [[nodiscard]] MaybeId<VertexId> hint(std::uint8_t byte) const {
    return byte % 4 == 0 ? MaybeId<VertexId>{} : MaybeId<VertexId>(VertexId{byte});
  }

 private:
  void note(const char* what, const Point3& p) {
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%s({%a, %a, %a});\n", what, p.x, p.y, p.z);
    history_ += line.data();
  }
  /// Ends the program after printing the sequence; remove names the vertex by its place.
  void require(bool holds, const std::string& words) const {
    if (holds) return;
    std::fprintf(stderr, "\n%s// %s\n", history_.c_str(), words.c_str());
    std::abort();
  }
  void check() const {
    const auto broken = sites_.validate();
    require(!broken, broken.value_or(""));
    require(sites_.size() == ids_.size(), "the number of vertices is wrong");
    for (const auto& [p, v] : ids_) require(sites_.contains(v) && sites_.point(v) == p, "an id is lost");
  }
  void check_nearest(const Point3& p, MaybeId<VertexId> found) const {
    require(found.has_value() == !ids_.empty(), "no nearest vertex");
    for (const auto& [q, v] : ids_) {
      const Sign sign = kernel::exact::compare_distance(p, q, sites_.point(*found));
      require(sign == Sign::positive || (sign == Sign::zero && !(q < sites_.point(*found))),
              "another vertex is nearer");
    }
  }

  DynamicTetrahedralization sites_;
  std::map<Point3, VertexId, std::less<>> ids_;
  std::string history_;
};

Point3 point_from(fuzzing::Input& in, unsigned kind) {
  if (kind < 3) return in.point3(kind);
  const unsigned place = in.take<std::uint16_t>();  // on a small grid
  return {static_cast<double>(place % kind), static_cast<double>(place / kind % kind),
          static_cast<double>(place / (kind * kind) % kind)};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input in(data, size);
  const unsigned kind = in.take<std::uint8_t>() % 7;
  Sequence sequence;
  std::vector<Point3> first;
  for (unsigned i = in.take<std::uint8_t>() % 20; i > 0; --i) first.push_back(point_from(in, kind));
  if (!first.empty()) sequence.insert(first);
  for (int steps = 0; steps < 60 && !in.empty(); ++steps) {
    const auto action = in.take<std::uint8_t>();
    const MaybeId<VertexId> hint = sequence.hint(in.take<std::uint8_t>());
    if (action % 8 < 4)
      sequence.insert(point_from(in, kind), hint);
    else if (action % 8 < 7)
      sequence.remove(action / 8);
    else
      sequence.ask(point_from(in, kind), hint);
  }
  sequence.check_from_scratch();
  return 0;
}

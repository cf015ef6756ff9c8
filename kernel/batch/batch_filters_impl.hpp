// SPDX-License-Identifier: MIT
// The filters declared in batch_filters.hpp. Included once by each batch_*.cpp, which sets LEONHARD_BATCH_NAME and the
// instruction set. Everything has internal linkage.
//
// Determinants are taken about the first point, whose vectors to the others are U, V, W, T in their order, so that
// what depends on the points common to many calls is computed once. filtered_sign.hpp has the notation of the error
// bounds; they hold with and without fused multiply-add here too.

#include <utility>

#include "leonhard/kernel/batch/batch_filters.hpp"
#include "leonhard/kernel/batch/batch_lanes.hpp"

#ifdef __FAST_MATH__
#error "leonhard: exact predicates cannot be compiled with -ffast-math"
#endif

namespace leonhard::kernel {
namespace {

/// Determinants, and where their signs are certain.
struct Filtered {
  Lanes determinant;
  LanesMask certain;
};

LEONHARD_INLINE Lanes dot(const Lanes2& u, const Lanes2& v) { return u.x * v.x + u.y * v.y; }
LEONHARD_INLINE Lanes dot(const Lanes3& u, const Lanes3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
LEONHARD_INLINE Lanes3 cross(const Lanes3& u, const Lanes3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

struct Orient2dFilter {
  using Point = Point2;
  static constexpr std::size_t points = 3;

  /// Each product has 3 roundings, so the error of their difference, but for its own rounding, is at most
  /// (3u + O(u^2)) (|l| + |r|) + 2^-1074. 3.3307e-16 is 3u and a hundred-thousandth of it. An overflow makes the bound
  /// infinite or NaN.
  LEONHARD_INLINE Filtered filter(const Lanes2& u, const Lanes2& v) {
    const Lanes l = u.x * v.y, r = u.y * v.x, determinant = l - r;
    return {determinant, magnitude(determinant) > 3.3307e-16 * (magnitude(l) + magnitude(r)) + 0x1p-1000};
  }
};

struct IncircleFilter {
  using Point = Point2;
  static constexpr std::size_t points = 4;

  /// N.W - |W|^2 [U V] with N = |U|^2 V' - |V|^2 U', the primes for the turn (x, y) -> (y, -x).
  ///
  /// Error bound. A product in N.W has 4 roundings in its differences, 2 in the square, 2 in N's product and
  /// difference, 1 in the product with W, 2 in the sums: 11u, and in |W|^2 [U V] less. The products are those of
  /// incircle_filter, and so is the bound 11u/3 L^2 < 4u L^2, L = |U|^2 + |V|^2 + |W|^2. What underflows adds less
  /// than 2^-1069 (1 + L). No term exceeds L^2, so nothing overflows unless L^2 does.
  LEONHARD_INLINE Filtered filter(const Lanes2& u, const Lanes2& v, const Lanes2& w) {
    const Lanes uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), uv = u.x * v.y - u.y * v.x;
    const Lanes2 n{uu * v.y - vv * u.y, vv * u.x - uu * v.x};
    const Lanes determinant = dot(n, w) - ww * uv, size = uu + vv + ww;
    return {determinant, magnitude(determinant) > 0x1p-51 * (size * size) + 0x1p-1000};
  }
};

struct Orient3dFilter {
  using Point = Point3;
  static constexpr std::size_t points = 4;

  /// |U|^2, and so little more that it never comes out smaller, not even where it underflows.
  LEONHARD_INLINE Lanes square(const Lanes3& u) { return u.x * u.x + (u.y * u.y + (u.z * u.z + 0x1p-1000)); }

  /// Error bound. A term has 3 roundings in its differences, 2 in the minor, 1 in the product with W, 2 in the sum: at
  /// most (8u + O(u^2)) times the permanent of absolute values, which is at most (2 / sqrt 3) |U| |V| |W| (insphere
  /// in predicates3.hpp). Squared, (256/3 u^2 + O(u^3)) |U|^2 |V|^2 |W|^2; 86 instead of 256/3 is more than enough for
  /// the rest. Both sides are taken 2^600 times.
  ///
  /// Underflow. As |W|^2 is finite, |W| < 2^512, and minors that underflow add less than 2^-560: next to nothing
  /// against the guard, which lets the determinant be 2^-320 at least. The bound's first product, if it underflows, is
  /// wrong by 2^-1075, so the bound by less than 2^-51, and the guard is above that too. Overflow: if the bound is
  /// finite, then |U| |V|, |W| and their product are below 2^512, and the determinant is finite.
  LEONHARD_INLINE Filtered filter(const Lanes3& u, const Lanes3& v, const Lanes3& w) {
    const Lanes3 uv = cross(u, v);
    const Lanes determinant = dot(uv, w), bound = 0x56p494 * square(u) * square(v);
    return {determinant, determinant * (determinant * 0x1p600) > bound * square(w) + 0x1p-40};
  }
};

struct InsphereFilter {
  using Point = Point3;
  static constexpr std::size_t points = 5;

  /// N.T - |T|^2 [U V W] with N = |U|^2 (V x W) + |V|^2 (W x U) + |W|^2 (U x V).
  ///
  /// Error bound. A product in N.T has 5 roundings in its differences, 3 in the square, 2 in the vector product, 3 in
  /// N's product and sum, 1 in the product with T, 3 in the sums: 17u, and in |T|^2 [U V W] less. The products are
  /// those of insphere_filter, so with its inequalities the error is at most 17 * 0.1444 u S^2 sqrt S < 2.46u S^2
  /// sqrt S, S = |U|^2 + |V|^2 + |W|^2 + |T|^2; squared, 6.1 u^2 S^5, and 9 leaves a third for the rest.
  ///
  /// Underflow adds less than 2^-1068 (1 + S^2 sqrt S), and to the bound less than 2^-1070; the determinant must be
  /// 2^-500 at least. No term exceeds S^2 sqrt S, so nothing overflows unless S^5 does; the determinant's square may,
  /// when it is larger than any bound.
  LEONHARD_INLINE Filtered filter(const Lanes3& u, const Lanes3& v, const Lanes3& w, const Lanes3& t) {
    const Lanes uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), tt = dot(t, t);
    const Lanes3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
    const Lanes3 n{uu * vw.x + vv * wu.x + ww * uv.x, uu * vw.y + vv * wu.y + ww * uv.y,
                   uu * vw.z + vv * wu.z + ww * uv.z};
    const Lanes determinant = dot(n, t) - tt * dot(uv, w);
    const Lanes s = uu + vv + ww + tt, s_2 = s * s, s_5 = s_2 * s_2 * s;
    return {determinant, determinant * determinant > 0x9p-106 * s_5 + 0x1p-1000};
  }
};

template <class Filter, std::size_t... i>
LEONHARD_INLINE Filtered filter_lanes(const typename Filter::Point* points, const std::uint32_t* ids,
                                      std::index_sequence<i...>) {
  const auto first = rows<Filter::points>(points, ids);
  return Filter::filter(columns(rows<Filter::points>(points, ids + 1 + i) - first)...);
}

/// Asks filter_these(ids of as many calls as there are lanes) -> Filtered about all calls; `stride` ids make a call. Calls
/// of too few for the lanes are filled up with point 0.
///
/// Signs are stored only when the next ones have been computed: the table lookup and the store end a long chain, and loads
/// begun after it would fill the processor's queue of loads. So orient2d and incircle take a fifth less time.
template <std::size_t stride, class FilterThese>
LEONHARD_INLINE void filter_all(const std::uint32_t* ids, std::size_t count, Sign* signs,
                                FilterThese filter_these) {
  std::size_t done = 0;
  if (count >= lane_count) {
    Filtered now = filter_these(ids);
    for (; count - done >= 2 * lane_count; done += lane_count) {
      const Filtered next = filter_these(ids + stride * (done + lane_count));
      store_signs(signs + done, now.certain, now.determinant);
      now = next;
    }
    store_signs(signs + done, now.certain, now.determinant);
    done += lane_count;
  }
  if (done == count) return;
  std::uint32_t last_ids[stride * lane_count] = {};
  Sign last_signs[lane_count];
  std::memcpy(last_ids, ids + stride * done, stride * (count - done) * sizeof *ids);
  const Filtered last = filter_these(last_ids);
  store_signs(last_signs, last.certain, last.determinant);
  std::memcpy(signs + done, last_signs, count - done);
}

template <class Filter>
void filter_calls(const typename Filter::Point* points, const std::uint32_t* ids, std::size_t count,
                  Sign* signs) {
  filter_all<Filter::points>(ids, count, signs, [=](const std::uint32_t* these) LEONHARD_INLINE_LAMBDA {
    return filter_lanes<Filter>(points, these, std::make_index_sequence<Filter::points - 1>());
  });
}

/// `common` is a copy, which no storing of signs can change: what depends on it alone is computed once.
template <class Filter, class... Common>
LEONHARD_INLINE void filter_many(const typename Filter::Point& first, const typename Filter::Point* points,
                                 const std::uint32_t* ids, std::size_t count, Sign* signs, Common... common) {
  const auto firsts = equal_rows(first);
  filter_all<1>(ids, count, signs, [=](const std::uint32_t* these) LEONHARD_INLINE_LAMBDA {
    return Filter::filter(common..., columns(rows<1>(points, these) - firsts));
  });
}

template <class Filter, std::size_t... i>
LEONHARD_INLINE void filter_against_one(const typename Filter::Point* one,
                                        const typename Filter::Point* points, const std::uint32_t* ids,
                                        std::size_t count, Sign* signs, std::index_sequence<i...>) {
  filter_many<Filter>(one[0], points, ids, count, signs, in_every_lane(one[0], one[1 + i])...);
}

template <class Filter>
void filter_one_against_many(const typename Filter::Point* one, const typename Filter::Point* points,
                             const std::uint32_t* ids, std::size_t count, Sign* signs) {
  filter_against_one<Filter>(one, points, ids, count, signs, std::make_index_sequence<Filter::points - 2>());
}

/// The vectors from p to a, b, c, d take the place of those from the first point: to put p first is an even permutation.
void filter_spheres(const Point3& p, const void* records, const std::uint32_t* ids, std::size_t count,
                    Sign* signs) {
  const auto* const points = static_cast<const PointRecord*>(records);
  const Rows3 from = equal_rows(p);
  filter_all<4>(ids, count, signs, [=](const std::uint32_t* these) LEONHARD_INLINE_LAMBDA {
    return InsphereFilter::filter(
        columns(rows<4>(points, these) - from), columns(rows<4>(points, these + 1) - from),
        columns(rows<4>(points, these + 2) - from), columns(rows<4>(points, these + 3) - from));
  });
}

}  // namespace

namespace detail {

const BatchFilters LEONHARD_BATCH_NAME{
    LEONHARD_BATCH_LABEL,
    {filter_calls<Orient2dFilter>, filter_one_against_many<Orient2dFilter>},
    {filter_calls<IncircleFilter>, filter_one_against_many<IncircleFilter>},
    {filter_calls<Orient3dFilter>, filter_one_against_many<Orient3dFilter>},
    {filter_calls<InsphereFilter>, filter_one_against_many<InsphereFilter>},
    filter_spheres};

}  // namespace detail
}  // namespace leonhard::kernel

// SPDX-License-Identifier: MIT
#include "leonhard/delaunay/algorithm.hpp"

#include <cstddef>
#include <string>

#include "leonhard/delaunay/lawson.hpp"
#include "leonhard/delaunay/plane/bowyer.hpp"
#include "leonhard/delaunay/plane/divide_and_conquer.hpp"
#include "leonhard/delaunay/plane/fast.hpp"
#include "leonhard/delaunay/plane/green_sibson.hpp"
#include "leonhard/delaunay/plane/randomized.hpp"
#include "leonhard/delaunay/plane/watson.hpp"
#include "leonhard/kernel/input_error.hpp"
#include "leonhard/mesh/words.hpp"

namespace leonhard::delaunay {

std::optional<Algorithm> algorithm_named(std::string_view name) {
  for (const NamedAlgorithm& known : named_algorithms)
    if (known.name == name) return known.algorithm;
  return std::nullopt;
}

PointTriangulation triangulate_distinct(std::span<const Point2> points, Algorithm algorithm,
                                        const AlgorithmOptions& options) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw InputError("point " + std::to_string(i), "is at " + mesh::words(points[i]),
                       "give finite coordinates");
  switch (algorithm) {
    case Algorithm::fast:
      return triangulate_fast(points, options);
    case Algorithm::divide_and_conquer:
      return triangulate_divide_and_conquer(points, options);
    case Algorithm::bowyer:
      return triangulate_bowyer(points, options);
    case Algorithm::watson:
      return triangulate_watson(points, options);
    case Algorithm::green_sibson:
      return triangulate_green_sibson(points, options);
    case Algorithm::randomized:
      return triangulate_randomized(points, options);
    case Algorithm::lawson:
      return triangulate_lawson(points, options);
  }
  return {};
}

}  // namespace leonhard::delaunay

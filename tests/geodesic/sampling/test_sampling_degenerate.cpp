// Samplings on faces without area and on needles.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/samples.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_sampling_degenerate {

using test::all_distinct;
using test::cover;
using test::error_of;
using test::kCounted;
using test::sample;

TEST_CASE("a face without area has farthest points, and random ones are refused with a reason") {
  const Mesh flat({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  for (const int count : {1, 3, 20}) {
    const auto points = sample(flat, Sampling::farthest, count);
    CHECK(points.size() == static_cast<std::size_t>(count));
    CHECK(all_distinct(flat, points));
  }
  for (const Sampling kind : {Sampling::random, Sampling::poisson}) {
    SamplingOptions options;
    options.kind = kind;
    CHECK(error_of(flat, options) == ErrorCode::precondition);
  }
}

TEST_CASE("a march terminates on faces without area that are folded on each other") {
  // After a mesh of the field whose points 1, 3 to 6 lie on a line, in faces that overlap there.
  std::vector<std::array<VertexId, 3>> faces;
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{
           {0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {2, 1, 6}, {2, 6, 4}, {4, 6, 5}, {5, 6, 7}, {4, 5, 7}}) {
    faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  }
  const Mesh mesh({{4, -2, 0}, {6, 0, 0}, {4, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}, {3, 2, 0}}, faces);
  for (const Sampling kind : kCounted) {
    for (const int count : {1, 8, 18, 300}) {
      const auto points = sample(mesh, kind, count);
      CHECK(points.size() == static_cast<std::size_t>(count));
      CHECK(all_distinct(mesh, points));
    }
  }
  CHECK(!cover(mesh, 0.5).empty());
}

TEST_CASE("farthest points do not coincide across needles, whatever a march finds there") {
  // A disc with a strip of two needles, 1.9e-15 high, through its middle.
  const double e = 1.9e-15;
  const Mesh disc = test::make_mesh({{-4.5, e, 0}, {-7.5, 0, 0}, {4.5, e, 0}, {7.5, 0, 0}, {0, 8, 0}, {0, -8, 0}},
                                    {{0, 1, 2}, {2, 1, 3}, {0, 2, 4}, {1, 0, 4}, {2, 3, 4}, {3, 1, 5}});
  for (const int count : {10, 30, 100}) {
    for (const std::uint64_t seed : {0, 1, 2, 3}) {
      CAPTURE(count, seed);
      const auto points = sample(disc, Sampling::farthest, count, seed);
      CHECK(std::ssize(points) == count);
      CHECK(all_distinct(disc, points));
    }
  }
  CHECK(all_distinct(disc, cover(disc, 1)));
}

TEST_CASE("a march terminates on a disc made of a fan of needles") {
  // The needles of a polygon's first corner, each cut into rows of equal triangles: row l has l pieces a needle.
  constexpr int kNeedles = 126, kRows = 16;
  std::vector<Vec3> points;
  std::vector<int> row_start;
  for (int row = 0; row <= kRows; ++row) {
    row_start.push_back(static_cast<int>(points.size()));
    for (int k = 0; k <= kNeedles * row; ++k) {
      const int needle = row > 0 ? std::min(k / row, kNeedles - 1) : 0;
      const auto corner = [](int i) -> Vec3 {
        const double angle = 2 * std::numbers::pi * (i + 1) / (kNeedles + 2);
        return {std::cos(angle) - 1, std::sin(angle), 0};
      };
      const double fraction = row > 0 ? double(k - needle * row) / row : 0;
      points.push_back(double(row) / kRows * ((1 - fraction) * corner(needle) + fraction * corner(needle + 1)));
    }
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (int row = 0; row < kRows; ++row) {
    for (int needle = 0; needle < kNeedles; ++needle) {
      for (int k = 0; k <= row; ++k) {
        const int above = row_start[row] + needle * row + k, below = row_start[row + 1] + needle * (row + 1) + k;
        faces.push_back({VertexId(above), VertexId(below), VertexId(below + 1)});
        if (k < row) faces.push_back({VertexId(above), VertexId(below + 1), VertexId(above + 1)});
      }
    }
  }
  const Mesh mesh(points, faces);
  const auto chosen = sample(mesh, Sampling::farthest, 20);
  CHECK(chosen.size() == 20);
  CHECK(all_distinct(mesh, chosen));
}

}  // namespace gvd::test_sampling_degenerate

#include <cmath>

#include "base/barycentric.hpp"
#include "support/catch.hpp"
#include "support/tiny_meshes.hpp"
#include "weighted_face.hpp"

namespace gvd::test_weighted_face {

using namespace paper;

/// A source that sees the whole face, as if it were a corner: at p, with an offset.
FaceSource source_at(const Vec2& p, int generator, double offset = 0) {
  return FaceSource::corner(p, offset, GeneratorId(generator), Mesh::halfedge(FaceId(0), generator % 3));
}

BoundaryCrossing crossing(int corner, double t, int previous, int next) {
  return {CrossingId(0), corner, t, GeneratorId(previous), GeneratorId(next)};
}

double total_share(const WeightedFace::Cut& cut) {
  double sum = 0;
  for (const BoundaryRun& run : cut.polygons) sum += area_share(run.points);
  return sum;
}

TEST_CASE("runs go from crossing to crossing round the whole boundary") {
  const auto runs = make_runs({crossing(0, 0.5, 0, 1), crossing(1, 0.25, 1, 2), crossing(1, 0.75, 2, 0)});
  REQUIRE(runs.size() == 3);
  CHECK(runs[0].points.size() == 3);  // past corner 1
  CHECK(runs[1].points.size() == 2);
  CHECK(runs[2].points.size() == 4);  // past corners 2 and 0
  CHECK(runs[0].generator == GeneratorId(1));
  CHECK(runs[2].points[1] == Bary{0, 0, 1});
  CHECK(runs[2].points.back() == Bary{0.5, 0.5, 0});
}

TEST_CASE("two crossings are joined by a segment") {
  const Mesh mesh = test::make_triangle();
  const FaceLayout layout(mesh, FaceId(0));
  const std::vector<FaceSource> sources{source_at(layout.corner[0], 0), source_at(layout.corner[1], 1)};
  const WeightedFace face(layout, sources);
  const auto cut = face.cut(make_runs({crossing(0, 0.5, 0, 1), crossing(2, 0.5, 1, 0)}));
  REQUIRE(cut.polygons.size() == 2);
  CHECK_FALSE(cut.forced);
  CHECK(total_share(cut) == Approx(1));
  CHECK(area_share(cut.polygons[1].points) == Approx(0.25));
}

TEST_CASE("three runs end in the point that is equally far from their generators, with their offsets") {
  const Mesh mesh = test::make_triangle();
  const FaceLayout layout(mesh, FaceId(0));
  const std::vector<FaceSource> sources{source_at(layout.corner[0], 0), source_at(layout.corner[1], 1, 0.1),
                                        source_at(layout.corner[2], 2, 0.2)};
  const WeightedFace face(layout, sources);
  const auto cut = face.cut(make_runs({crossing(0, 0.525, 0, 1), crossing(1, 0.52, 1, 2), crossing(2, 0.4, 2, 0)}));
  REQUIRE(cut.polygons.size() == 3);
  CHECK_FALSE(cut.forced);
  CHECK(total_share(cut) == Approx(1));
  const Vec2 p = layout.at(cut.polygons[0].points.back());
  const double first = (p - layout.corner[0]).norm(), second = 0.1 + (p - layout.corner[1]).norm();
  CHECK(first == Approx(second));
  CHECK(first == Approx(0.2 + (p - layout.corner[2]).norm()));
}

TEST_CASE("a point that a fourth generator is nearer to is no branch point, and the face is forced") {
  const Mesh mesh = test::make_triangle();
  const FaceLayout layout(mesh, FaceId(0));
  const std::vector<FaceSource> sources{source_at(layout.corner[0], 0), source_at(layout.corner[1], 1),
                                        source_at(layout.corner[2], 2), source_at(layout.at({0.3, 0.3, 0.4}), 3)};
  const WeightedFace face(layout, sources);
  const auto cut = face.cut(make_runs({crossing(0, 0.5, 0, 1), crossing(1, 0.5, 1, 2), crossing(2, 0.5, 2, 0)}));
  CHECK(cut.forced);
  CHECK(total_share(cut) == Approx(1));
}

TEST_CASE("a run between two of one generator is cut off, and the rest goes on") {
  const Mesh mesh = test::make_triangle();
  const FaceLayout layout(mesh, FaceId(0));
  const std::vector<FaceSource> sources{source_at(layout.corner[0], 0), source_at(layout.corner[1], 1)};
  const WeightedFace face(layout, sources);
  const auto cut = face.cut(
      make_runs({crossing(0, 0.2, 0, 1), crossing(0, 0.4, 1, 0), crossing(1, 0.5, 0, 1), crossing(2, 0.5, 1, 0)}));
  CHECK(cut.polygons.size() == 3);
  CHECK_FALSE(cut.forced);
  CHECK(total_share(cut) == Approx(1));
}

TEST_CASE("a thousand sources of each generator, as beside needles, give the point of the nearest ones") {
  const Mesh mesh = test::make_triangle();
  const FaceLayout layout(mesh, FaceId(0));
  std::vector<FaceSource> few, many;
  for (int g = 0; g < 3; ++g) {
    const Vec2& corner = layout.corner[std::size_t(g)];
    few.push_back(source_at(corner, g, 0.1 * g));
    many.push_back(few.back());
    // Farther than the first one by more than it is displaced.
    for (int k = 1; k < 1000; ++k) many.push_back(source_at(corner + Vec2(1e-4 * k, 0), g, 0.1 * g + 2e-4 * k));
  }
  const std::vector<BoundaryCrossing> crossings{crossing(0, 0.525, 0, 1), crossing(1, 0.52, 1, 2),
                                                crossing(2, 0.4, 2, 0)};
  const auto expected = WeightedFace(layout, few).cut(make_runs(crossings));
  const auto cut = WeightedFace(layout, many).cut(make_runs(crossings));
  CHECK_FALSE(expected.forced);
  CHECK_FALSE(cut.forced);
  REQUIRE(cut.polygons.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(area_share(cut.polygons[i].points) == Approx(area_share(expected.polygons[i].points)).epsilon(1e-9));
  }
}

}  // namespace gvd::test_weighted_face

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geodesic/windows/face_frames.hpp"
#include "support/catch.hpp"

namespace gvd::test_face_frames {

/// An even number of equal triangles round vertex 0 with the given total angle; their outer vertices alternate up and
/// down. In an open fan the last triangle is not joined to the first one, and the vertex lies on the boundary.
Mesh make_fan(int corners, double total, bool closed) {
  // Outer neighbours are 2 pi / corners apart seen from above, one up and one down.
  const double step = 2 * std::numbers::pi / corners;
  const double across = std::sqrt((1 + std::cos(total / corners)) / (1 + std::cos(step)));
  const double up = std::sqrt(1 - across * across);
  std::vector<Vec3> positions{{0, 0, 0}};
  for (int i = 0; i < corners; ++i) {
    positions.emplace_back(across * std::cos(i * step), across * std::sin(i * step), i % 2 == 0 ? up : -up);
  }
  // An open fan ends in a copy of the first outer vertex.
  if (!closed) positions.push_back(positions[1]);
  std::vector<std::array<VertexId, 3>> faces;
  for (int i = 1; i <= corners; ++i) {
    const int next = closed && i == corners ? 1 : i + 1;
    faces.push_back({VertexId(0), VertexId(i), VertexId(next)});
  }
  return Mesh(std::move(positions), std::move(faces));
}

VertexKind kind_in_fan(int corners, double half_turns, bool closed) {
  return FaceFrames(make_fan(corners, half_turns * std::numbers::pi, closed), ParallelChunks(1, {}))
      .kind[VertexCopyId(0)];
}

// Rounding decides on which side of a multiple of pi the sum of the angles falls, so each case tries many fans.

TEST_CASE("an inner vertex is flat at two pi only") {
  for (int corners = 8; corners <= 60; corners += 2) {
    INFO(corners << " corners");
    CHECK(kind_in_fan(corners, 2 + 1e-6, true) == VertexKind::saddle);
    CHECK(kind_in_fan(corners, 3, true) == VertexKind::saddle);
  }
}

TEST_CASE("an inner vertex with an angle of four pi is a saddle, although its sine is zero") {
  for (int corners = 8; corners <= 60; corners += 2) {
    INFO(corners << " corners");
    CHECK(kind_in_fan(corners, 4, true) == VertexKind::saddle);
  }
}

TEST_CASE("a boundary vertex with an angle of three pi is reflex") {
  for (int corners = 8; corners <= 60; corners += 2) {
    INFO(corners << " corners");
    CHECK(kind_in_fan(corners, 3, false) == VertexKind::reflex);
    CHECK(kind_in_fan(corners, 2.5, false) == VertexKind::reflex);
  }
}

TEST_CASE("a vertex is flat in a closed flat fan, and plain on a straight boundary") {
  for (int corners = 4; corners <= 60; ++corners) {
    const double step = 2 * std::numbers::pi / corners;
    std::vector<Vec3> positions{{0, 0, 0}};
    for (int i = 0; i < corners; ++i) positions.emplace_back(std::cos(i * step), std::sin(i * step), 0);
    std::vector<std::array<VertexId, 3>> faces;
    for (int i = 1; i <= corners; ++i) faces.push_back({VertexId(0), VertexId(i), VertexId(i % corners + 1)});
    INFO(corners << " corners");
    CHECK(FaceFrames(Mesh(positions, faces), ParallelChunks(1, {})).kind[VertexCopyId(0)] == VertexKind::flat);
    if (corners % 2 != 0) continue;
    faces.resize(static_cast<std::size_t>(corners / 2));
    positions.resize(static_cast<std::size_t>(corners / 2 + 2));
    CHECK(FaceFrames(Mesh(positions, faces), ParallelChunks(1, {})).kind[VertexCopyId(0)] == VertexKind::plain);
  }
}

TEST_CASE("a needle keeps the digits of its angles, whichever corner comes first") {
  // A right angle at the short side, in a direction where every coordinate is rounded.
  const Vec3 along = Vec3(0.3, 0.5, 0.7).normalized(), across = Vec3(0.7, 0, -0.3).normalized();
  for (const double width : {1e-6, 1e-9, 1e-12}) {
    for (int turn = 0; turn < 3; ++turn) {
      INFO(width << " " << turn);
      const std::array<Vec3, 3> corner{Vec3(0, 0, 0), width * across, width * across + along};
      std::vector<Vec3> positions;
      for (int i = 0; i < 3; ++i) positions.push_back(corner[(i + turn) % 3]);
      const FaceFrames frames(Mesh(positions, {std::array{VertexId(0), VertexId(1), VertexId(2)}}),
                              ParallelChunks(1, {}));
      const FaceFrame& f = frames.frame[FaceId(0)];
      const auto at = [&](int i) { return static_cast<std::size_t>((i - turn + 3) % 3); };
      CHECK(frames.has_needles);
      CHECK(f.sine[at(1)] == Approx(1).epsilon(1e-13));
      CHECK(f.sine[at(2)] / width == Approx(1).epsilon(3e-4));  // the width of the corner itself is rounded
      for (int i = 0; i < 3; ++i) {
        CHECK(f.sine[at(i)] * f.sine[at(i)] + f.cosine[at(i)] * f.cosine[at(i)] == Approx(1).epsilon(1e-13));
      }
    }
  }
}

TEST_CASE("a face without area has angles with a sine above zero, however short its sides are") {
  for (const double step : {0.5, 1e-3, 1e-9, 1e-13}) {
    const FaceFrames frames(
        Mesh({{0, 0, 0}, {step, 0, 0}, {1, 0, 0}}, {std::array{VertexId(0), VertexId(1), VertexId(2)}}),
        ParallelChunks(1, {}));
    const FaceFrame& f = frames.frame[FaceId(0)];
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(f.sine[i] > 0);
      CHECK(f.sine[i] <= 1e-12);
    }
  }
}

}  // namespace gvd::test_face_frames

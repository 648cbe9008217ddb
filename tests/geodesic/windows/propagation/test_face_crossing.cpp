#include <cmath>

#include "geodesic/windows/propagation/face_crossing.hpp"
#include "support/catch.hpp"
#include "support/recording_target.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_crossing {

constexpr std::uint32_t kAtBegin = WindowHistory::kAtBegin, kAtEnd = WindowHistory::kAtEnd;

/// A face whose halfedge 0 leads from (0, 0) to (1, 0), with the apex at (0.5, height). All distances are known at
/// first, and large.
struct Setup {
  explicit Setup(double height = 1)
      : mesh(test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}, {{0, 1, 2}})),
        frames(mesh, ParallelChunks(1, {})),
        labels(3),
        apex_path(3),
        crossing(frames, labels, apex_path, angles, starts) {
    for (int v = 0; v < 3; ++v) {
      labels.distance[VertexCopyId(v)] = 100;
      labels.label[VertexCopyId(v)] = GeneratorId(9);
    }
  }

  test::RecordingTarget cross(double begin, double end, double x, const WindowHistory& history = {1, 0, FaceId(5)}) {
    test::RecordingTarget target;
    const Window w{begin, end, x, 1, 2, GeneratorId(3), HalfedgeId(0)};
    crossing.cross({w, history}, FaceEntry(frames, HalfedgeId(0)), target);
    return target;
  }

  Mesh mesh;
  FaceFrames frames;
  DistanceLabels labels;
  IdVector<HalfedgeId, ApexPath> apex_path;
  CornerAngles angles;  // no departures
  StartDistances starts;
  FaceCrossing crossing;
};

const VertexCopyId kApex(2);

TEST_CASE("a window that covers the apex offers it a path, and continues on both sides") {
  Setup setup;
  const test::RecordingTarget found = setup.cross(0.25, 0.75, 0.5);
  REQUIRE(found.paths.size() == 1);
  CHECK(found.paths[0].vertex == kApex);
  CHECK(found.paths[0].path.distance == Approx(2 + 2));
  CHECK(found.paths[0].path.generator == GeneratorId(3));
  // Straight down from the apex, in the middle of its corner.
  CHECK(found.paths[0].path.back.halfedge == Mesh::halfedge(FaceId(0), 2));
  CHECK(found.paths[0].path.back.angle.sine == Approx(0.5 / std::sqrt(1.25)));
  REQUIRE(found.windows.size() == 2);
  const auto& left = found.windows[0];
  CHECK(left.window.end == setup.frames.frame[FaceId(0)].length[2]);
  CHECK(left.window.offset == 2);
  CHECK(left.window.generator == GeneratorId(3));
  CHECK_FALSE(left.window.halfedge.valid());  // the boundary
  CHECK(left.edge.start == VertexCopyId(0));
  CHECK(left.edge.end == kApex);
  CHECK(left.edge.behind == Mesh::halfedge(FaceId(0), 2));
  CHECK(left.edge.length == setup.frames.frame[FaceId(0)].length[2]);
  const auto& right = found.windows[1];
  CHECK(right.window.begin == 0);
  CHECK(right.edge.start == kApex);
  CHECK(right.edge.end == VertexCopyId(1));
  CHECK(right.edge.behind == Mesh::halfedge(FaceId(0), 1));
}

TEST_CASE("a window beside the apex continues on one side, and offers no path") {
  Setup setup;
  const test::RecordingTarget left = setup.cross(0.1, 0.3, 0.2), right = setup.cross(0.7, 0.9, 0.8);
  CHECK(left.paths.empty());
  REQUIRE(left.windows.size() == 1);
  CHECK(left.windows[0].edge.end == kApex);
  CHECK(right.paths.empty());
  REQUIRE(right.windows.size() == 1);
  CHECK(right.windows[0].edge.start == kApex);
}

TEST_CASE("no path is offered to an apex that has a better one") {
  Setup setup;
  setup.labels.distance[kApex] = 4 - 1e-6;
  CHECK(setup.cross(0.25, 0.75, 0.5).paths.empty());
  setup.labels.distance[kApex] = 4 + 1e-6;
  CHECK(setup.cross(0.25, 0.75, 0.5).paths.size() == 1);
}

TEST_CASE("an apex without a path is offered those along the sides") {
  Setup setup;
  setup.labels.distance[kApex] = std::numeric_limits<double>::infinity();
  setup.labels.label[kApex] = GeneratorId();
  setup.labels.distance[VertexCopyId(1)] = 50;
  const test::RecordingTarget found = setup.cross(0.1, 0.3, 0.2);
  REQUIRE(found.paths.size() == 2);
  const double side = std::sqrt(1.25);
  CHECK(found.paths[0].path.distance == Approx(100 + side));
  CHECK(found.paths[1].path.distance == Approx(50 + side));
  for (const auto& path : found.paths) CHECK(path.path.generator == GeneratorId(9));
}

TEST_CASE("ends of a window stay joinable, and become so at a flat apex") {
  Setup setup;
  const auto ends = [&](double begin, double end, std::uint32_t joinable) {
    std::vector<std::uint32_t> found;
    for (const auto& sent : setup.cross(begin, end, 0.5, {1, joinable & 3u, FaceId()}).windows) {
      found.push_back(sent.history.joinable_ends);
    }
    return found;
  };
  using Ends = std::vector<std::uint32_t>;
  CHECK(ends(0.25, 0.75, kAtBegin | kAtEnd) == Ends{kAtBegin, kAtEnd});
  CHECK(ends(0.1, 0.2, kAtBegin | kAtEnd) == Ends{kAtBegin | kAtEnd});
  CHECK(ends(0.1, 0.2, kAtEnd) == Ends{kAtEnd});
  setup.frames.kind[kApex] = VertexKind::flat;
  CHECK(ends(0.25, 0.75, 0) == Ends{kAtEnd, kAtBegin});
  CHECK(ends(0.1, 0.2, 0) == Ends{0});
}

TEST_CASE("faces are counted, and checked for cycles, on meshes with thin faces only") {
  const WindowHistory history{3, 0, FaceId(5)};
  Setup ordinary;
  CHECK(ordinary.cross(0.25, 0.75, 0.5, history).windows[0].history.crossed_faces == 3);
  Setup thin(0.01);
  REQUIRE(thin.frames.has_thin_faces);
  const test::RecordingTarget found = thin.cross(0.25, 0.75, 0.5, history);
  CHECK(found.windows[0].history.crossed_faces == 4);
  CHECK(found.windows[0].history.cycle_check_face == FaceId(0));  // 4 is a power of two
  const test::RecordingTarget next = thin.cross(0.25, 0.75, 0.5, {4, 0, FaceId(5)});
  CHECK(next.windows[0].history.crossed_faces == 5);
  CHECK(next.windows[0].history.cycle_check_face == FaceId(5));
}

TEST_CASE("on meshes with needles, only the window with the shortest path to the apex splits there") {
  Setup setup(1e-7);
  REQUIRE(setup.frames.has_needles);
  CHECK(setup.cross(0, 1, 0.5).windows.size() == 2);
  CHECK(setup.cross(0, 1, 0.2).windows.size() == 1);
  CHECK(setup.cross(0, 1, 0.5).windows.size() == 2);  // the same path again
}

}  // namespace gvd::test_face_crossing

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geodesic/windows/propagation/pseudo_sources.hpp"
#include "support/catch.hpp"
#include "support/recording_target.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_pseudo_sources {

/// `count` equilateral triangles round vertex 0, which has the total angle count * pi / 3. A closed fan, of 6 triangles
/// or more, has outer vertices that alternate up and down; an open one, of 5 or fewer, is flat. Vertex 0 is corner 2 of
/// each face.
Mesh make_fan(int count, bool closed) {
  const double step = closed ? 2 * std::numbers::pi / count : std::numbers::pi / 3;
  const double across = closed ? std::sqrt(1.5 / (1 + std::cos(step))) : 1;
  const double up = std::sqrt(std::max(0.0, 1 - across * across));
  std::vector<Vec3> positions{{0, 0, 0}};
  for (int i = 0; i < count + (closed ? 0 : 1); ++i) {
    positions.emplace_back(across * std::cos(i * step), across * std::sin(i * step), i % 2 == 0 ? up : -up);
  }
  std::vector<std::array<int, 3>> faces;
  for (int i = 1; i <= count; ++i) faces.push_back({i, closed && i == count ? 1 : i + 1, 0});
  return test::make_mesh(std::move(positions), faces);
}

struct Setup {
  Setup(int count, bool closed, std::int32_t partition_faces = 1000)
      : mesh(make_fan(count, closed)), frames(mesh, ParallelChunks(1, {})), partitions(mesh, partition_faces, frames) {}

  test::RecordingTarget send(const VertexEvent& event, PartitionId own = PartitionId(0)) const {
    test::RecordingTarget target;
    PseudoSources(mesh, frames, partitions, angles, own).send(event, target);
    return target;
  }

  Mesh mesh;
  FaceFrames frames;
  MeshPartitions partitions;
  CornerAngles angles;  // no departures
};

const VertexCopyId kCentre(0);
const double kCorner = std::numbers::pi / 3;

VertexPath path_from(HalfedgeId back, double angle) {
  return {10, GeneratorId(2), {back, {std::cos(angle), std::sin(angle)}}};
}

/// The angle, seen from the centre, of what the windows cover together. All triangles are equilateral.
double covered_angle(const test::RecordingTarget& found) {
  double sum = 0;
  for (const auto& sent : found.windows) {
    const auto angle = [&](double t) { return std::atan2(t - sent.window.x, sent.window.depth); };
    sum += angle(sent.window.end) - angle(sent.window.begin);
  }
  return sum;
}

TEST_CASE("a generator sends a window through each of its faces, and a path to each of its neighbours") {
  const Setup setup(8, true);
  const test::RecordingTarget found = setup.send({kCentre, true, {10, GeneratorId(2), {}}});
  CHECK(found.windows.size() == 8);
  CHECK(found.paths.size() == 16);  // from both sides
  for (const auto& path : found.paths) {
    CHECK(path.path.distance == Approx(11));
    CHECK(path.path.generator == GeneratorId(2));
  }
  for (const auto& sent : found.windows) {
    CHECK(sent.window.begin == 0);
    CHECK(sent.window.end == Approx(1));
    CHECK(sent.window.offset == 10);
    CHECK(sent.history.crossed_faces == 1);
    CHECK(sent.history.cycle_check_face == Mesh::face(sent.edge.behind));
  }
}

TEST_CASE("a saddle sends windows between the two straight continuations of the path") {
  // The total angle is 8 / 3 pi: 2 / 3 pi lie between the continuations.
  const Setup setup(8, true);
  REQUIRE(setup.frames.kind[kCentre] == VertexKind::saddle);
  for (int face = 0; face < 8; ++face) {
    for (const double angle : {0.0, 0.2, 0.9}) {
      CAPTURE(face, angle);
      const HalfedgeId back = Mesh::halfedge(FaceId(face), 2);
      const test::RecordingTarget found = setup.send({kCentre, false, path_from(back, angle)});
      CHECK(covered_angle(found) == Approx(2 * kCorner));
    }
  }
}

TEST_CASE("a reflex boundary vertex sends windows on the side where the path can bend") {
  // The total angle is 4 / 3 pi.
  const Setup setup(4, false);
  REQUIRE(setup.frames.kind[kCentre] == VertexKind::reflex);
  const auto covered = [&](int face, double angle) {
    return covered_angle(setup.send({kCentre, false, path_from(Mesh::halfedge(FaceId(face), 2), angle)}));
  };
  CHECK(covered(0, 0.0) == Approx(kCorner));
  CHECK(covered(0, 0.5) == Approx(kCorner - 0.5));
  CHECK(covered(1, 0.5) == Approx(0).margin(1e-12));
  CHECK(covered(3, 0.5) == Approx(0.5));
}

TEST_CASE("the copies of a vertex together send into all faces, each into those of its partition") {
  const Setup setup(8, true, 2);
  REQUIRE(setup.partitions.count() > 1);
  const SharedCopyId shared = setup.partitions.shared(kCentre);
  REQUIRE(shared.valid());
  std::size_t windows = 0;
  int first_copies = 0;
  for (const auto& copy : setup.partitions.copies(shared)) {
    const test::RecordingTarget found = setup.send({copy.vertex, true, {10, GeneratorId(2), {}}}, copy.partition);
    for (const auto& sent : found.windows) {
      CHECK(setup.partitions.of_halfedge(sent.edge.behind) == copy.partition);
    }
    windows += found.windows.size();
    const PseudoSources sources(setup.mesh, setup.frames, setup.partitions, setup.angles, copy.partition);
    first_copies += sources.is_first_copy(copy.vertex);
  }
  CHECK(windows == 8);
  CHECK(first_copies == 1);
}

TEST_CASE("a window is joinable at the ends where its ray runs along a side to a flat vertex") {
  Setup setup(8, true);
  setup.frames.kind[VertexCopyId(1)] = VertexKind::flat;
  const test::RecordingTarget found = setup.send({kCentre, true, {10, GeneratorId(2), {}}});
  for (const auto& sent : found.windows) {
    const std::uint32_t begin = sent.edge.start == VertexCopyId(1) ? WindowHistory::kAtBegin : 0;
    const std::uint32_t end = sent.edge.end == VertexCopyId(1) ? WindowHistory::kAtEnd : 0;
    CHECK(sent.history.joinable_ends == (begin | end));
  }
}

}  // namespace gvd::test_pseudo_sources

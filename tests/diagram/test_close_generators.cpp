// Regressions of exact diagrams, most of them with generators that nearly coincide: each with the smallest mesh on
// which pieces of a face overlapped, or a point lay outside of its face.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/envelope/separate_arcs.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_close_generators {

/// Far above rounding, and far below the error of any of these bugs.
constexpr double kOff = 1e-9;

/// Computes an exact diagram and requires that it passes its check.
Diagram compute_sound(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double chord_tolerance = 1e-4) {
  DiagramOptions options;
  options.chord_tolerance = chord_tolerance;
  Diagram diagram = compute_diagram(mesh, generators, options);
  for (const std::string& violation : check_diagram(mesh, diagram).violations) FAIL_CHECK(violation);
  return diagram;
}

/// Requires that no outline of a piece intersects itself.
void check_outlines(const Diagram& diagram) {
  for (const FacePiece& piece : diagram.pieces) {
    std::vector<ArcSegment> outline;
    for (std::size_t i = 0, n = piece.corners.size(); i < n; ++i) {
      const auto &from = piece.corners[i], &to = piece.corners[(i + 1) % n];
      outline.push_back({{affine_point(from), affine_point(to)}, 0});
    }
    ArcIntersections meetings;
    INFO("generator " << piece.generator.value() << " in face " << piece.face.value());
    CHECK(meetings.find(outline).empty());
  }
}

/// Requires that branch points are equally far from their generators, by distances from each generator alone.
void check_branch_points(const Mesh& mesh, const Diagram& diagram) {
  for (const BranchPoint& branch : diagram.branch_points) {
    for (const GeneratorId g : branch.generators) {
      const ExactField alone(mesh, {diagram.generators[g.index()]});
      CHECK(std::abs(alone.nearest(branch.point).distance - branch.distance) <= kOff * mesh.bbox_diagonal());
    }
  }
}

/// Requires right distances at all vertices. Those of reference start at the vertices, so that no face is split.
void check_distances(const Mesh& mesh, const Diagram& diagram) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const ExactField from(mesh, {vertex_point(mesh, VertexId(v))});
    double least = std::numeric_limits<double>::infinity();
    for (const SurfacePoint& generator : diagram.generators) least = std::min(least, from.nearest(generator).distance);
    INFO("vertex " << v << ": " << diagram.vertex_distance[VertexId(v)] << " instead of " << least);
    CHECK(std::abs(diagram.vertex_distance[VertexId(v)] - least) <= 1e-13 * mesh.bbox_diagonal());
  }
}

TEST_CASE("two generators down to 3e-11 apart: distances of vertices are right, and no bisector is straightened") {
  const Mesh mesh = test::make_tetrahedron();
  for (const double apart : {1e-6, 1e-8, 1e-9, 1e-10, 3e-11}) {
    for (int direction = 0; direction < 12; ++direction) {
      INFO(apart << " apart, direction " << direction);
      const double angle = 0.53 * direction, dx = apart * std::cos(angle), dy = apart * std::sin(angle);
      const Diagram diagram = compute_sound(mesh, {{FaceId(1), {0.5, 0.2, 0.3}},
                                                   {FaceId(1), {0.5 - dx - dy, 0.2 + dx, 0.3 + dy}},
                                                   {FaceId(3), {0.25, 0.25, 0.5}}});
      check_distances(mesh, diagram);
      CHECK(diagram.report.straightened_faces == 0);
    }
  }
}

TEST_CASE("a vertex that gets another label to connect cells keeps the distance of its nearest generator") {
  const Mesh mesh =
      test::make_mesh({{8e-61, 5.9999999999999995e-61, 0},
                       {-8e-61, -5.9999999999999995e-61, 0},
                       {-5.9999999999999995e-61, 8e-61, 0},
                       {5.9999999999999995e-61, -8e-61, 0},
                       {0, 0, 1e-60},
                       {0, 0, -1e-60}},
                      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  const Diagram diagram =
      compute_sound(mesh, {{FaceId(2), {0.04030162782105576, 0.4952726104871693, 0.46442576169177496}},
                           {FaceId(2), {0.040301627612173915, 0.4952726103944689, 0.46442576199335717}},
                           {FaceId(2), {0.04030162771972174, 0.4952726103768199, 0.4644257619034583}},
                           {FaceId(2), {0.04030162763652375, 0.49527261053718685, 0.46442576182628936}},
                           {FaceId(1), {0.2738710323799836, 0.08358643463864551, 0.642542532981371}},
                           {FaceId(1), {0.27389626110564674, 0.08349228645065086, 0.6426114524437023}}});
  check_distances(mesh, diagram);
}

TEST_CASE("a branch point between ridges of the distances is found") {
  // Three generators 1e-3 apart, with paths on both sides of a cube: Newton's method converges only from within 1e-4 of
  // the point.
  const Mesh mesh = test::make_mesh(
      {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {0, 4, 7}, {0, 7, 1}, {3, 2, 6}, {3, 6, 5}, {0, 3, 5}});
  const std::vector<SurfacePoint> generators{
      {FaceId(3), {0.5721193993114423, 0.37712226792781545, 0.050758332760742264}},
      {FaceId(3), {0.5722177358479882, 0.37625171361468546, 0.05153055053732636}},
      {FaceId(3), {0.5724583381699135, 0.3769785442910708, 0.050563117539015656}}};
  const Diagram diagram = compute_sound(mesh, generators);
  check_outlines(diagram);
  check_branch_points(mesh, diagram);
}

TEST_CASE(
    "a branch point whose shortest path lies along the bisector of two nearly coincident generators is accepted") {
  // 1e-8 apart: rounding moves the crossing of that bisector by 1e-6, so that the path enters the face beyond it.
  const Mesh mesh = test::make_mesh(
      {{1000000, 1000000, -1000000},
       {1000000, 1000000, -999999},
       {999999.4, 1000000.8, -1000000},
       {999999.4, 1000000.8, -999999},
       {1000000.8, 1000000.6, -1000000},
       {1000000.2, 1000001.4, -1000000},
       {1000000.8, 1000000.6, -999999},
       {1000000.2, 1000001.4, -999999}},
      {{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {5, 7, 6}, {0, 4, 1}, {4, 6, 1}, {2, 3, 5}, {3, 7, 5}, {6, 7, 3}});
  const std::vector<SurfacePoint> generators{
      {FaceId(7), {0.7790915475442288, 0.1542803819654349, 0.06662807049033628}},
      {FaceId(2), {0.7904689384998862, 0.20598377592730016, 0.003547285572813641}},
      {FaceId(2), {0.7904689540683125, 0.20598377905660772, 0.003547266875079752}},
      {FaceId(2), {0.7904689425613217, 0.2059837633799411, 0.003547294058737188}}};
  const Diagram diagram = compute_sound(mesh, generators);
  check_outlines(diagram);
  check_branch_points(mesh, diagram);
}

TEST_CASE("three label intervals with a branch point inside the face are contracted before those with one outside") {
  // Three pairs of generators that mirror each other, and a face with ties along one of its sides.
  const Mesh mesh = test::make_mesh({{3.2e-08, 2.4e-08, 0},
                                     {-3.6784609690826525e-08, 1.571281292110205e-08, 0},
                                     {2.6472135954999582e-08, 1.9854101966249684e-08, 9.510565162951535e-09},
                                     {-3.043022464959859e-08, 1.2998491246340234e-08, 9.510565162951535e-09},
                                     {1.752786404500042e-08, 1.3145898033750315e-08, 5.877852522924732e-09},
                                     {-2.014861367528788e-08, 8.606626520175078e-09, 5.877852522924732e-09},
                                     {1.752786404500042e-08, 1.3145898033750315e-08, -5.877852522924731e-09},
                                     {-2.014861367528788e-08, 8.606626520175078e-09, -5.877852522924731e-09},
                                     {2.6472135954999582e-08, 1.9854101966249684e-08, -9.510565162951537e-09},
                                     {-3.043022464959859e-08, 1.2998491246340234e-08, -9.510565162951537e-09},
                                     {4.784609690826507e-09, -3.971281292110204e-08, 0},
                                     {3.958088694598992e-09, -3.2852593212589906e-08, 9.510565162951535e-09}},
                                    {{0, 1, 2},
                                     {1, 3, 2},
                                     {2, 3, 4},
                                     {3, 5, 4},
                                     {4, 5, 6},
                                     {5, 7, 6},
                                     {6, 7, 8},
                                     {7, 9, 8},
                                     {8, 9, 0},
                                     {9, 1, 0},
                                     {1, 10, 3},
                                     {10, 11, 3},
                                     {10, 0, 11},
                                     {0, 2, 11}});
  const std::vector<SurfacePoint> generators{{FaceId(0), {0, 0, 1}}, {FaceId(2), {0, 0, 1}}, {FaceId(4), {0, 0, 1}},
                                             {FaceId(6), {0, 0, 1}}, {FaceId(3), {0, 1, 0}}, {FaceId(5), {0, 1, 0}}};
  check_branch_points(mesh, compute_sound(mesh, generators));
}

TEST_CASE("arcs that would intersect when they are refined stay apart") {
  // No branch point in the face; a generator 1e-11 from a vertex.
  const Mesh mesh = test::make_mesh({{-0.16048672133459363, -0.12010143974368086, -0.1641401707111253},
                                     {0.7571880193076502, 0.5678996436247411, -0.15319297908646823},
                                     {0.13938238561981137, 0.10453471016518553, 0.38785488051079553},
                                     {0.6062831263100479, 0.4548870756847025, -0.0005621572492090499}},
                                    {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  const std::vector<SurfacePoint> generators{
      {FaceId(2), {0.8193634360172279, 0.1805690859571426, 6.747802562946094e-05}},
      {FaceId(1), {0.9999999999849025, 7.54874251457493e-12, 7.54874251457493e-12}},
      {FaceId(2), {0.5, 0.5, 0}},
      {FaceId(1), {0.10749348911050415, 0.8787287254535427, 0.013777785435953111}},
      {FaceId(1), {0.3333333333333333, 0.3333333333333333, 0.3333333333333333}}};
  check_outlines(compute_sound(mesh, generators, 2.4e-4));
}

TEST_CASE("in a face without width the points of bisectors lie inside") {
  const Mesh mesh =
      test::make_mesh({{10000.138918542134, 0.10418890660015824, 0},
                       {9999.6, -0.2999999999999999, 0},
                       {10000, 0, 0},
                       {10000, 0, 0},
                       {9999.24824590337, -0.563815572471545, 0},
                       {9999.6, -0.30000000000000027, 0},
                       {10000.138918542134, 0.10418890660015798, 0}},
                      {{0, 1, 2}, {1, 0, 3}, {1, 4, 2}, {4, 1, 3}, {4, 5, 2}, {5, 4, 3}, {5, 6, 2}, {6, 5, 3}});
  const std::vector<SurfacePoint> generators{{FaceId(0), {0, 1, 0}},
                                             {FaceId(0), {0, 0.9997409794867326, 0.00025902051326747187}},
                                             {FaceId(1), {0.9997409794867326, 0.00025902051326747187, 0}},
                                             {FaceId(3), {0, 0.9997409794867326, 0.00025902051326747187}}};
  check_outlines(compute_sound(mesh, generators, 1.3e-4));
}

}  // namespace gvd::test_close_generators

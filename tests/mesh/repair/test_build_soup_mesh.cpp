#include <random>

#include "mesh/reading/soup_files.hpp"
#include "support/meshes.hpp"
#include "support/twisted_strip.hpp"

namespace gvd::test_build_soup_mesh {

using test::kTwist, test::make_twisted_strip, test::split_triangles;

using Polygons = std::vector<std::vector<std::int32_t>>;

PolygonSoup make_soup(std::vector<Vec3> positions, const Polygons& polygons) {
  PolygonSoup soup;
  soup.positions = std::move(positions);
  for (const auto& polygon : polygons) {
    soup.corners.insert(soup.corners.end(), polygon.begin(), polygon.end());
    soup.first_corner.push_back(soup.corners.size());
  }
  return soup;
}

const std::vector<Vec3> kPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {1, 1, 1}};

PolygonSoup points_soup(std::size_t vertices, const Polygons& polygons) {
  return make_soup({kPoints.begin(), kPoints.begin() + static_cast<std::ptrdiff_t>(vertices)}, polygons);
}

// Repairs, requires exactly one kind of defect, and requires `error` to refuse it naming the same element.
CheckedMesh require_repaired(const PolygonSoup& soup, DefectKind kind, std::int64_t count, std::int64_t first) {
  CheckedMesh checked = build_mesh(soup);
  REQUIRE(checked.defects.defects.size() == 1);
  CHECK(checked.defects.defects[0].kind == kind);
  CHECK(checked.defects.count(kind) == count);
  CHECK(checked.defects.defects[0].first == first);
  CHECK(checked.defects.messages.front() == checked.defects.defects[0].message);
  try {
    build_mesh(soup, DefectPolicy::error);
    FAIL("accepted under DefectPolicy::error");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::precondition);
    CHECK(error.element() == first);
  }
  return checked;
}

void require_refused(const PolygonSoup& soup, const std::string& part, std::int64_t element,
                     DefectPolicy policy = DefectPolicy::repair) {
  try {
    build_mesh(soup, policy);
    FAIL("accepted, expected: " << part);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::precondition);
    CHECK(error.element() == element);
    CHECK_THAT(error.what(), Catch::Matchers::Contains(part));
  }
}

PolygonSoup soup_of(const Mesh& mesh) {
  PolygonSoup soup;
  soup.positions = mesh.positions();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (const VertexId v : mesh.vertices(FaceId(f))) soup.corners.push_back(v.value());
    soup.first_corner.push_back(soup.corners.size());
  }
  return soup;
}

double area(const Mesh& mesh) { return compute_mesh_summary(mesh).area; }

// A strip of `n` quads whose ends are joined, with a half twist or without.
PolygonSoup make_band(int n, bool twisted, double offset = 0) {
  PolygonSoup soup;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    const double half = twisted ? angle / 2 : 0;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(half);
      soup.positions.emplace_back(offset + r * std::cos(angle), r * std::sin(angle),
                                  side * std::sin(half) + (twisted ? 0 : side));
    }
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const bool cross = twisted && j == 0;
    for (const int v : {2 * i, 2 * j + cross, 2 * j + !cross, 2 * i + 1}) soup.corners.push_back(v);
    soup.first_corner.push_back(soup.corners.size());
  }
  return soup;
}

void append(PolygonSoup& soup, const PolygonSoup& more) {
  const auto shift = static_cast<std::int32_t>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), more.positions.begin(), more.positions.end());
  for (std::size_t p = 0; p < more.polygon_count(); ++p) {
    for (const std::int32_t v : more.polygon(p)) soup.corners.push_back(v + shift);
    soup.first_corner.push_back(soup.corners.size());
  }
}

TEST_CASE("a soup without defects becomes the same mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const CheckedMesh checked = build_mesh(soup_of(mesh), DefectPolicy::error);
    CHECK(checked.defects.defects.empty());
    CHECK(checked.mesh.positions() == mesh.positions());
    REQUIRE(checked.mesh.face_count() == mesh.face_count());
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      REQUIRE(checked.mesh.vertices(FaceId(f)) == mesh.vertices(FaceId(f)));
      REQUIRE(checked.input_polygon[FaceId(f)] == f);
    }
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      REQUIRE(checked.mesh_vertex[v] == VertexId(v));
      REQUIRE(checked.input_vertex[VertexId(v)] == v);
    }
  }
}

TEST_CASE("a soup of arrays has polygons of one size, and refuses corners that are no vertices") {
  const std::vector<double> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const PolygonSoup quad = gvd::make_soup(square, std::vector<std::int64_t>{0, 1, 2, 3}, 4);
  CHECK(quad.polygon_count() == 1);
  CHECK(quad.positions[2] == Vec3(1, 1, 0));
  CHECK(build_mesh(quad).mesh.face_count() == 2);
  for (const std::int64_t wrong : {std::int64_t{-1}, std::int64_t{4}, std::int64_t{1} << 32}) {
    try {
      gvd::make_soup(square, std::vector<std::int64_t>{0, 1, 2, 0, 2, wrong});
      FAIL("no error");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::precondition);
      CHECK(error.element() == 1);
      CHECK_THAT(error.what(), Catch::Matchers::Contains("face 1 has the vertex " + std::to_string(wrong)));
    }
  }
}

TEST_CASE("errors begin with the name of the file, and the mesh of a result is its own input") {
  const PolygonSoup twice =
      gvd::make_soup(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}, std::vector<std::int64_t>{0, 1, 2, 0, 1, 2});
  try {
    build_mesh(twice, DefectPolicy::error, "a.ply");
    FAIL("no error");
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Catch::Matchers::StartsWith("a.ply: "));
    CHECK(error.element() == 1);
  }
  const CheckedMesh own = as_input(build_mesh(twice).mesh);
  CHECK(own.input_vertex.raw() == std::vector<std::int32_t>{0, 1, 2});
  CHECK(own.input_polygon.raw() == std::vector<std::int32_t>{0});
  CHECK(own.mesh_vertex == std::vector<VertexId>{VertexId(0), VertexId(1), VertexId(2)});
}

TEST_CASE("unwelded: equal coordinates are one vertex, and -0 is 0") {
  PolygonSoup soup =
      make_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 1, -0.0}, {1, -0.0, 0}, {1, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  CHECK(build_mesh(soup).mesh.vertex_count() == 6);
  CHECK(build_mesh(soup).defects.coincident_vertices == 2);
  soup.unwelded = true;
  const CheckedMesh checked = require_repaired(soup, DefectKind::unwelded_vertices, 2, 3);
  CHECK(checked.mesh.vertex_count() == 4);
  CHECK(checked.mesh_vertex[3] == checked.mesh_vertex[2]);
}

TEST_CASE("zero-length edge: its ends are welded, and the surface stays closed") {
  // Two triangles joined by a collapsed quad: the edge 1-4 has length 0.
  const PolygonSoup soup =
      make_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 4, 2}, {4, 3, 2}});
  const CheckedMesh checked = build_mesh(soup);
  CHECK(checked.defects.count(DefectKind::zero_length_edges) == 1);
  CHECK(checked.defects.count(DefectKind::degenerate_faces) == 1);
  CHECK(checked.mesh.face_count() == 2);
  CHECK(compute_mesh_summary(checked.mesh).boundary_loops == 1);
  CHECK(compute_mesh_summary(checked.mesh).euler_characteristic == 1);
  CHECK(checked.mesh_vertex[4] == checked.mesh_vertex[1]);
  require_refused(soup, "1 edge of length 0, first the one between vertices 1 and 4 in face 1", 1, DefectPolicy::error);
}

TEST_CASE("degenerate faces: a corner that repeats") {
  CHECK(
      require_repaired(points_soup(3, {{0, 1, 2}, {0, 1, 1}}), DefectKind::degenerate_faces, 1, 1).mesh.face_count() ==
      1);
  CHECK(
      require_repaired(points_soup(3, {{0, 1}, {0, 1, 2}, {}}), DefectKind::degenerate_faces, 2, 0).mesh.face_count() ==
      1);
  CHECK(require_repaired(points_soup(3, {{0, 1, 2, 2}}), DefectKind::degenerate_faces, 1, 0).mesh.face_count() == 1);
  CHECK(require_repaired(points_soup(4, {{0, 1, 3, 1, 2}, {3, 2, 1}}), DefectKind::degenerate_faces, 1, 0)
            .mesh.face_count() == 2);
  require_refused(points_soup(3, {{0, 1, 0}, {2, 2, 2}}), "every face is degenerate", 0);
}

TEST_CASE("three points on a line are legal and counted") {
  const PolygonSoup soup = make_soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}});
  const CheckedMesh checked = build_mesh(soup, DefectPolicy::error);
  CHECK(checked.mesh.face_count() == 3);
  CHECK(checked.defects.zero_area_faces == 1);
}

TEST_CASE("a surface stretched beyond what doubles can tell is refused, with its edges and what to do") {
  const auto stretched = [](double factor) {
    const Mesh sphere = test::make_sphere(2);
    PolygonSoup soup;
    for (const Vec3& p : sphere.positions()) soup.positions.push_back({factor * p.x(), p.y() / factor, p.z()});
    for (const auto& corners : sphere.face_vertices()) {
      for (const VertexId v : corners) soup.corners.push_back(v.value());
      soup.first_corner.push_back(soup.corners.size());
    }
    return soup;
  };
  for (const double factor : {1.0, 1e4, 1e12}) CHECK(build_mesh(stretched(factor)).mesh.face_count() == 320);
  for (const double factor : {1e16, 1e30}) {
    CHECK_THROWS_WITH(build_mesh(stretched(factor)), Catch::Matchers::Contains("of 320 triangles: heights are below") &&
                                                         Catch::Matchers::Contains("scale the axes"));
  }
}

TEST_CASE("duplicate faces are removed, in either direction") {
  CHECK(require_repaired(points_soup(4, {{0, 1, 2}, {0, 3, 1}, {1, 2, 0}}), DefectKind::duplicate_faces, 1, 2)
            .mesh.face_count() == 2);
  CHECK(
      require_repaired(points_soup(4, {{0, 1, 2}, {0, 3, 1}, {0, 2, 1}, {0, 1, 3}}), DefectKind::duplicate_faces, 2, 2)
          .mesh.face_count() == 2);
  CHECK(require_repaired(points_soup(3, {{0, 1, 2}, {1, 2, 0}}), DefectKind::duplicate_faces, 1, 1).mesh.face_count() ==
        1);
}

TEST_CASE("two faces back to back are a closed surface and are kept") {
  const CheckedMesh checked = build_mesh(points_soup(3, {{0, 1, 2}, {0, 2, 1}}), DefectPolicy::error);
  CHECK(compute_mesh_summary(checked.mesh).euler_characteristic == 2);
  const CheckedMesh quads =
      build_mesh(make_soup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {0, 3, 2, 1}}));
  CHECK(quads.defects.defects.empty());
  CHECK(compute_mesh_summary(quads.mesh).euler_characteristic == 2);
}

TEST_CASE("orientation: the minority of each component is flipped") {
  PolygonSoup soup = soup_of(test::make_sphere(1));
  for (const std::size_t f : {4U, 17U, 30U}) std::swap(soup.corners[3 * f], soup.corners[3 * f + 1]);
  const CheckedMesh checked = require_repaired(soup, DefectKind::inconsistent_orientation, 3, 4);
  CHECK(
      checked.defects.messages.front().starts_with("3 faces are oriented against most of their component, first face"));
  CHECK(compute_mesh_summary(checked.mesh).euler_characteristic == 2);
  // Of two faces with opposite orientation the first one is kept as it is.
  const CheckedMesh two =
      require_repaired(points_soup(4, {{0, 1, 2}, {0, 1, 3}}), DefectKind::inconsistent_orientation, 1, 1);
  CHECK(two.defects.messages.front().starts_with("1 face is oriented against most of its component, first face 1"));
  CHECK(two.mesh.vertices(FaceId(0)) == std::array{VertexId(0), VertexId(1), VertexId(2)});
}

TEST_CASE("a surface with one side is refused, unless its component is dropped") {
  PolygonSoup soup = make_band(9, true);
  require_refused(soup, "the component of face 0 has only one side", 0);
  require_refused(soup, "the largest component, that of face 0, has only one side", 0, DefectPolicy::largest);
  append(soup, soup_of(test::make_sphere(1)));
  CHECK(compute_mesh_summary(build_mesh(soup, DefectPolicy::largest).mesh).euler_characteristic == 2);
  CHECK(compute_mesh_summary(build_mesh(make_band(9, false)).mesh).boundary_loops == 2);
}

TEST_CASE("an edge of three faces: the fin is cut off, and the closed body stays closed") {
  PolygonSoup soup = make_soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, -1, -1}},
                               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 1, 4}});
  const CheckedMesh checked = require_repaired(soup, DefectKind::nonmanifold_edges, 1, 0);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  CHECK(summary.components == 2);
  CHECK(summary.boundary_loops == 1);
  CHECK(summary.vertices == 7);
  CHECK(checked.input_vertex[VertexId(5)] == 0);
  CHECK(checked.input_vertex[VertexId(6)] == 1);
  CHECK(checked.mesh_vertex[0] == VertexId(0));
  CHECK_THAT(checked.defects.messages[0],
             Catch::Matchers::Contains("between vertices 0 and 1 (3 faces, one is face 0)"));
}

TEST_CASE("a vertex that joins two fans is cut") {
  const PolygonSoup soup = points_soup(5, {{0, 1, 2}, {0, 3, 4}});
  const CheckedMesh checked = require_repaired(soup, DefectKind::nonmanifold_vertices, 1, 0);
  CHECK(checked.mesh.vertex_count() == 6);
  CHECK(checked.input_vertex[VertexId(5)] == 0);
}

TEST_CASE("unused vertices are dropped, and the maps from input to mesh show it") {
  const CheckedMesh checked = require_repaired(points_soup(5, {{1, 2, 4}}), DefectKind::unused_vertices, 2, 0);
  CHECK(checked.mesh_vertex == std::vector<VertexId>{VertexId(), VertexId(0), VertexId(1), VertexId(), VertexId(2)});
  CHECK(checked.input_vertex.raw() == std::vector<std::int32_t>{1, 2, 4});
}

TEST_CASE("a component of faces without area is dropped and counted, and one that others hang on stays") {
  PolygonSoup stray = points_soup(3, {{0, 1, 2}});
  append(stray, make_soup({{5, 0, 0}, {6, 0, 0}, {8, 0, 0}}, {{0, 1, 2}}));
  const CheckedMesh checked = require_repaired(stray, DefectKind::zero_area_components, 1, 1);
  CHECK(checked.mesh.face_count() == 1);
  CHECK(checked.mesh.vertex_count() == 3);
  CHECK(checked.defects.zero_area_faces == 0);
  CHECK(checked.mesh_vertex[4] == VertexId());
  CHECK(checked.defects.messages ==
        std::vector<std::string>{"1 component consists of faces without area only, first the one of face 1: "
                                 "removed"});
  const PolygonSoup filled = make_soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 2, 3}, {0, 1, 2}});
  CHECK(build_mesh(filled, DefectPolicy::error).defects.zero_area_faces == 1);
  // Where nothing has an area, nothing is dropped.
  CHECK(build_mesh(make_soup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})).defects.zero_area_faces == 1);
}

TEST_CASE("a component without area is found at every size of a mesh") {
  for (const double size : {1e-75, 1e-60, 1e-30, 1.0, 1e30, 1e74}) {
    CAPTURE(size);
    // A needle whose height is above 1e-15 of its longest side, and one whose height is below.
    PolygonSoup soup = points_soup(3, {{0, 1, 2}});
    append(soup, make_soup({{5, 0, 0}, {6, 0, 0}, {5.5, 1.1e-15, 0}}, {{0, 1, 2}}));
    append(soup, make_soup({{5, 1, 0}, {6, 1, 0}, {5.5, 1, 0.9e-15}}, {{0, 1, 2}}));
    for (Vec3& p : soup.positions) p *= size;
    const CheckedMesh checked = build_mesh(soup);
    CHECK(checked.defects.count(DefectKind::zero_area_components) == 1);
    CHECK(checked.mesh.face_count() == 2);
    CHECK(checked.defects.zero_area_faces == 0);
  }
}

TEST_CASE("a face without area that the cut of an edge sets free is dropped") {
  const PolygonSoup fin =
      make_soup({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const CheckedMesh checked = build_mesh(fin);
  CHECK(checked.defects.count(DefectKind::nonmanifold_edges) == 1);
  CHECK(checked.defects.zero_area_faces + checked.defects.count(DefectKind::zero_area_components) == 1);
}

TEST_CASE("a long band with a half twist is cut where its faces disagree, a short one is refused") {
  const CheckedMesh checked = require_repaired(make_band(60, true), DefectKind::one_sided_edges, 1, 0);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  CHECK(summary.boundary_loops == 1);
  CHECK(summary.euler_characteristic == 1);
  CHECK(summary.components == 1);
  CHECK(checked.mesh.face_count() == 120);
  CHECK_THAT(checked.defects.messages.front(), Catch::Matchers::Contains("cut open there"));
  require_refused(make_band(20, true), "only one side", 0);
}

TEST_CASE("a closed one-sided surface is cut along seven twisted edges if these are fewer than 1 % of its edges") {
  // 21 edges for each of 33 rows are 693. Those of a closed mesh are a multiple of 3.
  for (const int split : {0, 2}) {
    PolygonSoup soup = make_twisted_strip(33, true);
    split_triangles(soup, split);
    require_refused(soup, "the component of face 0 has only one side, like a Moebius strip", 0);
  }
  PolygonSoup soup = make_twisted_strip(33, true);
  split_triangles(soup, 3);  // 702 edges
  const CheckedMesh checked = require_repaired(soup, DefectKind::one_sided_edges, kTwist, 3);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  CHECK(summary.components == 1);
  CHECK(summary.boundary_loops == 2);
  CHECK(summary.euler_characteristic == 0);
  CHECK(summary.faces == std::int64_t(soup.polygon_count()));
  CHECK(summary.vertices == std::ssize(soup.positions) + kTwist);
  CHECK(checked.defects.messages ==
        std::vector<std::string>{"7 edges between faces of opposite orientations make the surface one-sided, like a "
                                 "Moebius strip, first the one between vertices 1 and 2 of face 3: cut open there"});
}

TEST_CASE("a strip with a half twist of seven edges is refused at exactly 1 % of its edges, and cut below") {
  for (const int split : {6, 7}) {  // 22 edges for each of 31 rows, and 3 for each split
    PolygonSoup soup = make_twisted_strip(31, false);
    split_triangles(soup, split);
    if (split == 6) {  // 700 edges
      require_refused(soup, "only one side", 0);
      continue;
    }
    const CheckedMesh checked = require_repaired(soup, DefectKind::one_sided_edges, kTwist, 7);
    const MeshSummary summary = compute_mesh_summary(checked.mesh);
    CHECK(summary.components == 1);
    CHECK(summary.boundary_loops == 1);
    CHECK(summary.euler_characteristic == 1);
    CHECK(summary.vertices == std::ssize(soup.positions) + kTwist + 1);
  }
}

// Reverses a triangle.
void flip(PolygonSoup& soup, int f) { std::swap(soup.corners[3 * f + 1], soup.corners[3 * f + 2]); }

TEST_CASE("faces that are reversed inside a one-sided component are flipped, and not cut off") {
  PolygonSoup soup = make_twisted_strip(60, true);  // 1260 edges
  flip(soup, 300);
  const CheckedMesh checked = build_mesh(soup);
  CHECK(checked.defects.count(DefectKind::one_sided_edges) == kTwist);
  CHECK(checked.defects.count(DefectKind::inconsistent_orientation) == 1);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  CHECK(summary.components == 1);
  CHECK(summary.boundary_loops == 2);
  CHECK(summary.euler_characteristic == 0);
  flip(soup, 301);  // the other half of its quadrilateral: 7 + 4 edges disagree
  CHECK(build_mesh(soup).defects.count(DefectKind::one_sided_edges) == kTwist);
  for (int f = 100; f < 104; ++f) flip(soup, f);  // two quadrilaterals side by side: 7 + 4 + 6
  require_refused(soup, "only one side", 0);
}

TEST_CASE("of several seams the longest are closed by flips, and the shortest is cut") {
  // Forty rows are reversed: three seams. Without the last two triangles, that at the ends of the strip has six edges.
  PolygonSoup soup = make_twisted_strip(140, false);  // 3080 edges
  const int row = 2 * kTwist;
  for (int f = 70 * row; f < 110 * row; ++f) flip(soup, f);
  soup.corners.resize(soup.corners.size() - 6);
  soup.first_corner.resize(soup.first_corner.size() - 2);
  const CheckedMesh checked = build_mesh(soup);
  CHECK(checked.defects.count(DefectKind::one_sided_edges) == kTwist - 1);
  CHECK(checked.defects.count(DefectKind::inconsistent_orientation) == 40 * row);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  CHECK(summary.components == 1);
  CHECK(summary.euler_characteristic == 1);
}

TEST_CASE("a few twists are counted for each component, and the largest component may be one that is cut") {
  PolygonSoup soup = make_twisted_strip(40, true);
  append(soup, make_band(20, false, 5));
  const CheckedMesh repaired = build_mesh(soup);
  CHECK(repaired.defects.count(DefectKind::one_sided_edges) == kTwist);
  CHECK(compute_mesh_summary(repaired.mesh).boundary_loops == 4);
  const CheckedMesh largest = build_mesh(soup, DefectPolicy::largest);
  CHECK(largest.defects.count(DefectKind::one_sided_edges) == kTwist);
  CHECK(largest.mesh.face_count() == 560);
  append(soup, make_band(20, true, 10));  // one edge of 80 disagrees
  require_refused(soup, "the component of face 580 has only one side", 580);
}

TEST_CASE("largest: the component with the largest area, of equals the first") {
  PolygonSoup soup = soup_of(test::make_two_components());
  const CheckedMesh all = build_mesh(soup);
  const CheckedMesh checked = build_mesh(soup, DefectPolicy::largest);
  CHECK(compute_mesh_summary(all.mesh).components == 2);
  CHECK(compute_mesh_summary(checked.mesh).components == 1);
  CHECK(checked.defects.count(DefectKind::dropped_components) == 1);
  CHECK(area(checked.mesh) > 0.5 * area(all.mesh));
  PolygonSoup twins = points_soup(3, {{0, 1, 2}});
  append(twins, points_soup(3, {{0, 1, 2}}));
  CHECK(build_mesh(twins, DefectPolicy::largest).input_polygon[FaceId(0)] == 0);
}

TEST_CASE("soups that can't be repaired are refused with the first element") {
  PolygonSoup soup = points_soup(3, {{0, 1, 2}});
  soup.positions[1].x() = NAN;
  require_refused(soup, "vertex 1 has a coordinate that is not finite", 1);
  soup.positions[1].x() = 1e80;
  require_refused(soup, "vertex 1 has a coordinate beyond 1e+75", 1);
  soup.positions = {{0, 0, 0}, {1e-80, 0, 0}, {0, 1e-80, 0}};
  require_refused(soup, "smaller than 1e-75", 0);
  soup.positions.assign(3, Vec3(1, 2, 3));
  require_refused(soup, "all vertices are at the same position", 0);
  require_refused(points_soup(3, {{0, 1, 2}, {0, 1, 3}}), "face 1 refers to vertex 3", 1);
  require_refused(points_soup(3, {}), "no face", -1);
  CHECK_NOTHROW(build_mesh(make_soup({{0, 0, 0}, {1e-320, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}})));
}

TEST_CASE("the result is the same twice, and building it again changes nothing") {
  std::mt19937 random(3);
  PolygonSoup soup = points_soup(6, {});
  for (int f = 0; f < 9; ++f) {
    for (int i = 0; i < 3; ++i) soup.corners.push_back(static_cast<std::int32_t>(random() % 6));
    soup.first_corner.push_back(soup.corners.size());
  }
  try {
    const Mesh first = build_mesh(soup, DefectPolicy::largest).mesh;
    CHECK(soup_of(first).corners == soup_of(build_mesh(soup, DefectPolicy::largest).mesh).corners);
    CHECK(soup_of(first).corners == soup_of(build_mesh(soup_of(first), DefectPolicy::error).mesh).corners);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::precondition);
  }
}

TEST_CASE("random triangles: the surface keeps its points or is refused") {
  std::mt19937 random(11);
  int built = 0;
  for (int round = 0; round < 4000; ++round) {
    PolygonSoup soup;
    const auto vertices = 4 + random() % 5;
    for (std::size_t v = 0; v < vertices; ++v) soup.positions.emplace_back(random() % 97, random() % 89, random() % 83);
    const auto faces = 1 + random() % 9;
    for (std::size_t f = 0; f < faces; ++f) {
      for (int i = 0; i < 3; ++i) soup.corners.push_back(static_cast<std::int32_t>(random() % vertices));
      soup.first_corner.push_back(soup.corners.size());
    }
    INFO("round " << round);
    try {
      const CheckedMesh checked = build_mesh(soup);
      ++built;
      double kept = 0;
      std::vector<char> seen(soup.polygon_count(), 0);
      for (std::int32_t f = 0; f < checked.mesh.face_count(); ++f) {
        kept += checked.mesh.area(FaceId(f));
        seen[checked.input_polygon[FaceId(f)]] = 1;
      }
      double given = 0;
      for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
        const auto at = [&](std::size_t i) { return soup.positions[soup.polygon(p)[i]]; };
        if (seen[p]) given += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
      }
      REQUIRE(kept == Approx(given));
      const auto dropped = std::count(seen.begin(), seen.end(), 0);
      REQUIRE(dropped == checked.defects.count(DefectKind::degenerate_faces) +
                             checked.defects.count(DefectKind::duplicate_faces) +
                             checked.defects.count(DefectKind::zero_area_components));
    } catch (const Error& error) {
      REQUIRE(error.code() == ErrorCode::precondition);
      REQUIRE_THAT(error.what(), Catch::Matchers::Contains("only one side") ||
                                     Catch::Matchers::Contains("every face is") ||
                                     Catch::Matchers::Contains("rounding decides the shape"));
    }
  }
  CHECK(built > 2000);
}

}  // namespace gvd::test_build_soup_mesh

// The faces that a box finds, pairs of faces of whole meshes, and the pairs that a remesh inherits from its surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "dual/faces_intersect.hpp"
#include "dual/placed_faces.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/remesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_self_intersections {

TEST_CASE("a box finds exactly the faces whose boxes overlap it") {
  const Mesh mesh = test::make_torus(20, 10);
  const FaceBoxes boxes(mesh, mesh.faces());
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 low(random.real(-1.5, 1.5), random.real(-1.5, 1.5), random.real(-0.5, 0.5));
    const Box3 box(low, low + Vec3::Constant(random.real(0, 0.5)));
    std::vector<FaceId> found, wanted;
    const auto collect = [&](FaceId f) {
      found.push_back(f);
      return false;
    };
    CHECK_FALSE(boxes.any_of(box, collect));
    std::sort(found.begin(), found.end());
    for (const FaceId f : mesh.faces()) {
      if (face_box(mesh, f).intersects(box)) wanted.push_back(f);
    }
    CHECK(found == wanted);
  }
}

TEST_CASE("closed boxes that touch overlap, and an empty mesh has none") {
  const Box3 unit(Vec3(0, 0, 0), Vec3(1, 1, 1));
  CHECK(unit.intersects(Box3(Vec3(1, 1, 1), Vec3(2, 2, 2))));
  CHECK_FALSE(unit.intersects(Box3(Vec3(1, 1, 1.5), Vec3(2, 2, 2))));
  const Mesh empty;
  CHECK_FALSE(FaceBoxes(empty, empty.faces()).any_of(unit, [](FaceId) { return true; }));
}

std::vector<FacePair> search_all_pairs(const Mesh& mesh) {
  std::vector<FacePair> pairs;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    for (std::int32_t j = i + 1; j < mesh.face_count(); ++j) {
      if (faces_intersect(mesh, FaceId(i), FaceId(j))) pairs.push_back({FaceId(i), FaceId(j)});
    }
  }
  return pairs;
}

/// The mesh with every vertex moved by at most `distance` along each axis.
Mesh shake(const Mesh& mesh, double distance, unsigned seed) {
  test::Random random(seed);
  std::vector<Vec3> positions = mesh.positions();
  const auto shift = [&] { return random.real(-distance, distance); };
  for (Vec3& p : positions) p += Vec3(shift(), shift(), shift());
  std::vector<std::array<VertexId, 3>> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

std::size_t count_pairs(const std::vector<Vec3>& positions, const std::vector<std::array<int, 3>>& faces) {
  return find_self_intersections(test::make_mesh(positions, faces)).size();
}

TEST_CASE("two separate triangles intersect where they cross, touch or overlap") {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto meets = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return count_pairs({a, b, c, p, q, r}, {{0, 1, 2}, {3, 4, 5}}) == 1;
  };
  CHECK_FALSE(meets({0, 0, 1}, {4, 0, 1}, {0, 4, 1}));
  CHECK(meets({1, 1, -1}, {1, 1, 1}, {2, 1, 1}));       // one crosses the other
  CHECK(meets({1, 1, 0}, {1, 1, 1}, {2, 1, 1}));        // a vertex touches a face
  CHECK(meets({4, 0, 0}, {5, 0, 1}, {5, 1, 1}));        // two vertices touch
  CHECK(meets({2, 2, -1}, {2, 2, 1}, {9, 9, 0}));       // two edges touch
  CHECK(meets({1, 1, 0}, {9, 1, 0}, {9, 2, 0}));        // coplanar, overlapping
  CHECK(meets({0.5, 0.5, 0}, {1, 0.5, 0}, {1, 1, 0}));  // coplanar, one inside the other
  CHECK_FALSE(meets({3, 3, 0}, {9, 3, 0}, {9, 4, 0}));  // coplanar, apart
  CHECK_FALSE(meets({2.5, 2, -1}, {2, 2.5, 1}, {9, 9, 0}));
}

TEST_CASE("two triangles of one vertex intersect where they cross beyond it") {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto meets = [&](const Vec3& p, const Vec3& q) {
    // The third face joins them to one fan.
    const Mesh fan = test::make_mesh({a, b, c, p, q}, {{0, 1, 2}, {0, 3, 4}, {0, 2, 3}});
    const std::vector<FacePair> pairs = find_self_intersections(fan);
    return std::find(pairs.begin(), pairs.end(), FacePair{FaceId(0), FaceId(1)}) != pairs.end();
  };
  CHECK_FALSE(meets({-1, 0, 0}, {0, -1, 0}));
  CHECK_FALSE(meets({1, 1, 1}, {2, 1, 1}));
  CHECK(meets({1, 1, -1}, {1, 1, 1}));
  CHECK(meets({9, 9, -1}, {9, 9, 1}));
  CHECK(meets({1, 1, 0}, {1, 2, 3}));  // along an edge of one
}

TEST_CASE("two triangles of one edge intersect where they are folded flat") {
  const auto meets = [&](const Vec3& p) {
    return count_pairs({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p}, {{0, 1, 2}, {1, 0, 3}}) == 1;
  };
  CHECK_FALSE(meets({0, -4, 0}));
  CHECK_FALSE(meets({0, 4, 1}));
  CHECK(meets({4, 4, 0}));
}

TEST_CASE("no mesh of the family intersects itself") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    CHECK(find_self_intersections(mesh).empty());
  }
}

TEST_CASE("the pairs are those of a search over all pairs, for any number of threads") {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    for (const auto& [name, mesh] : test::small_family()) {
      INFO(name << ", seed " << seed);
      const Mesh shaken = shake(mesh, 0.4 * mesh.mean_edge_length(), seed);
      const std::vector<FacePair> pairs = find_self_intersections(shaken, 1);
      CHECK(pairs == search_all_pairs(shaken));
      CHECK(pairs == find_self_intersections(shaken, 4));
      found += pairs.size();
    }
  }
  CHECK(found > 1000);
}

TEST_CASE("lengths whose products overflow or underflow change no pair") {
  const Mesh torus = test::make_torus(20, 10);
  const Mesh mesh = shake(torus, 0.8 * torus.mean_edge_length(), 1);
  const std::vector<FacePair> pairs = find_self_intersections(mesh);
  CHECK(pairs.size() > 50);
  for (const int exponent : {-400, -140, -41, 41, 140, 400}) {
    INFO("2^" << exponent);
    std::vector<Vec3> positions = mesh.positions();
    for (Vec3& p : positions) p *= std::ldexp(1.0, exponent);
    const Mesh scaled(std::move(positions), mesh.face_vertices());
    CHECK(find_self_intersections(scaled) == pairs);
  }
}

Mesh join(const std::vector<Mesh>& meshes) {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const Mesh& mesh : meshes) {
    const std::size_t offset = positions.size();
    positions.insert(positions.end(), mesh.positions().begin(), mesh.positions().end());
    for (const auto& [a, b, c] : mesh.face_vertices()) {
      faces.push_back({VertexId(a.index() + offset), VertexId(b.index() + offset), VertexId(c.index() + offset)});
    }
  }
  return {std::move(positions), std::move(faces)};
}

/// A sheet that passes through itself in some places only: two grids, one of them with waves.
Mesh make_crossing_sheets(int n, double level) {
  const Mesh flat = test::make_grid(n, n);
  std::vector<Vec3> waves = flat.positions();
  for (Vec3& p : waves) p.z() = level + std::sin(p.x()) * std::cos(1.3 * p.y());
  return join({flat, Mesh(std::move(waves), flat.face_vertices())});
}

/// The cells that a face has a part in.
std::set<GeneratorId> cells_in(const Diagram& diagram, FaceId f) {
  std::set<GeneratorId> cells;
  if (diagram.face_label[f].valid()) cells.insert(diagram.face_label[f]);
  for (const FacePiece& piece : diagram.pieces) {
    if (piece.face == f) cells.insert(piece.generator);
  }
  return cells;
}

/// The faces of the surface with a part under a face of the remesh.
std::set<FaceId> faces_under(const Mesh& surface, const RemeshResult& result, FaceId face) {
  std::set<FaceId> under;
  for (const FaceId f : surface.faces()) {
    for (const GeneratorId g : cells_in(result.diagram, f)) {
      for (const VertexId v : result.mesh.vertices(face)) {
        if (g.value() == v.value()) under.insert(f);
      }
    }
  }
  return under;
}

TEST_CASE("pairs are found where one of their faces counts") {
  const Mesh sheets = make_crossing_sheets(9, 0.3);
  const auto all = find_self_intersections(sheets);
  REQUIRE(all.size() > 10);
  std::vector<char> counts(sheets.face_count(), 0);
  CHECK(find_self_intersections(PlacedFaces(sheets), 1, {}, counts).empty());
  const FaceId one = all[all.size() / 2].second;
  counts[one.index()] = 1;
  std::vector<FacePair> wanted;
  std::ranges::copy_if(all, std::back_inserter(wanted),
                       [&](const FacePair& p) { return p.first == one || p.second == one; });
  CHECK(find_self_intersections(PlacedFaces(sheets), 1, {}, counts) == wanted);
}

TEST_CASE("every inherited pair has faces of the input under it that intersect, by brute force") {
  std::size_t inherited = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    CAPTURE(seed);
    const Mesh surface = make_crossing_sheets(9, 0.3 + 0.2 * seed);
    const RemeshResult result = remesh(surface, test::random_generators(surface, 40, seed));
    const RemeshCertificate& certificate = result.certificate;
    CHECK(certificate.inherited_intersections == std::ssize(certificate.self_intersections));
    inherited += certificate.self_intersections.size();
    for (const FacePair& pair : certificate.self_intersections) {
      const auto first = faces_under(surface, result, pair.first), second = faces_under(surface, result, pair.second);
      CHECK(std::ranges::any_of(first, [&](FaceId f) {
        return std::ranges::any_of(second, [&](FaceId g) { return f != g && faces_intersect(surface, f, g); });
      }));
    }
  }
  CHECK(inherited > 10);
}

/// Two spheres of radius 1 and .93, whose coarse meshes intersect, and a small one across the outer one only.
Mesh make_pierced_spheres() {
  std::vector<Vec3> small;
  const Mesh ball = test::make_sphere(1);
  for (const Vec3& p : ball.positions()) small.push_back(0.05 * p + Vec3(0, 0, 0.985));
  return join({test::make_nested_spheres(0.93), Mesh(std::move(small), ball.face_vertices())});
}

TEST_CASE("an intersection beside one of the input is not inherited: it is repaired, or refused") {
  const Mesh surface = make_pierced_spheres();
  const auto component = compute_face_components(surface);
  RemeshOptions options;
  options.placement.method = Placement::generator;
  std::size_t inherited = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    CAPTURE(seed);
    const RemeshResult result = remesh(surface, test::random_generators(surface, 24, seed), options);
    const auto component_of = [&](FaceId f) {
      return component[result.generators[result.mesh.vertices(f)[0].index()].face];
    };
    for (const FacePair& pair : result.certificate.self_intersections) {
      const std::set<std::int32_t> components{component_of(pair.first), component_of(pair.second)};
      CHECK(components == std::set<std::int32_t>{0, 2});  // the outer sphere and the small one
    }
    inherited += result.certificate.self_intersections.size();
  }
  CHECK(inherited > 0);
}

TEST_CASE("the cells of a large face count only near the other face") {
  // A square of two faces; a small triangle stands across one of them, near the first of its generators.
  const Mesh surface =
      test::make_mesh({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {7, 1, -1}, {7, 1.5, -1}, {7, 1, 1}},
                      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  const auto given = find_self_intersections(surface);
  REQUIRE(given == std::vector<FacePair>{{FaceId(0), FaceId(2)}});
  const std::vector<SurfacePoint> generators{
      make_surface_point(FaceId(0), {0.2, 0.7, 0.1}), make_surface_point(FaceId(0), {0.8, 0.1, 0.1}),
      make_surface_point(FaceId(0), {0.1, 0.1, 0.8}), make_surface_point(FaceId(2), {0.3, 0.3, 0.4})};
  const Diagram diagram = compute_diagram(surface, generators);
  REQUIRE(cells_in(diagram, FaceId(0)).size() == 3);
  CHECK(find_intersecting_cells(surface, diagram, given) == std::vector<CellPair>{{GeneratorId(0), GeneratorId(3)}});
  CHECK(find_intersecting_cells(surface, diagram, {}).empty());
}

TEST_CASE("a pair of faces is inherited if any cell of one intersects any cell of the other, in either order") {
  const Mesh strip = test::make_grid(3, 1);
  const std::vector<FacePair> pairs{{FaceId(0), FaceId(1)}, {FaceId(0), FaceId(5)}};
  const GeneratorId a(strip.vertices(FaceId(0))[1].value()), b(strip.vertices(FaceId(5))[2].value());
  const std::vector<CellPair> cells{{std::min(a, b), std::max(a, b)}};
  CHECK(find_inherited(strip, pairs, {}).empty());
  CHECK(find_inherited(strip, pairs, cells) == std::vector<FacePair>{{FaceId(0), FaceId(5)}});
  CHECK(find_inherited(strip, {}, cells).empty());
}

}  // namespace gvd::test_self_intersections

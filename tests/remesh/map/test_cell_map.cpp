// What makes the map one-to-one, checked by other means than its own: every point of the remesh has one origin, and
// borders are the same from both sides.
#include <map>
#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "map/cell_map.hpp"
#include "map/cut_into_cells.hpp"
#include "map/dual_polygons.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_cell_map {

/// The pieces of a map: its cells in the plane.
struct Pieces {
  Pieces(const Mesh& surface, const RemeshResult& result)
      : dual(result.mesh.positions(), undo_flips(result.mesh.face_vertices(), result.flips)),
        cells(value_or_throw(cut_into_cells(surface, result))),
        polygons(value_or_throw(DualPolygons::try_to_build(cells.cut.mesh, cells.cut.label, dual))),
        faces(result.generators.size()) {
    place_crossings(cells, polygons);
    for (std::int32_t f = 0; f < cells.cut.mesh.face_count(); ++f)
      faces[cells.cut.label[FaceId(f)]].push_back(FaceId(f));
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const GeneratorId g(i);
      planes.push_back(value_or_throw(flatten_cell({surface, result, cells, polygons}, g, faces[g])));
    }
  }

  Mesh dual;
  CellSurface cells;
  DualPolygons polygons;
  IdVector<GeneratorId, std::vector<FaceId>> faces;
  IdVector<GeneratorId, PlaneCell> planes;
};

double area(const Vec2& a, const Vec2& b, const Vec2& c) { return 0.5 * twice_signed_area(a, b, c); }

/// Weights of a point in a triangle.
std::array<double, 3> weights(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  const double whole = area(a, b, c);
  return {area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole};
}

bool is_inside(const std::array<double, 3>& w) { return w[0] >= 0 && w[1] >= 0 && w[2] >= 0; }

/// Faces of the cut surface that the map takes to a point of a polygon.
int count_origins(const Pieces& pieces, const DualPolygon& polygon, const Vec2& point) {
  int count = 0;
  for (const GeneratorId g : polygon.cells) {
    const PlaneCell& plane = pieces.planes[g];
    for (std::size_t i = 0; i < plane.targets.size(); ++i) {
      const BorderTarget& t = plane.targets[i];
      if (t.polygon != &polygon) continue;
      const auto w = weights(point, t.apex, t.from, t.to);
      if (!is_inside(w)) continue;
      const Vec2 back = w[0] * plane.apex + w[1] * plane.bases[i] + w[2] * plane.bases[i + 1];
      for (const FaceId f : pieces.faces[g]) {
        const auto& [a, b, c] = pieces.cells.cut.mesh.vertices(f);
        count += is_inside(weights(back, plane.disc.at(a), plane.disc.at(b), plane.disc.at(c)));
      }
    }
  }
  return count;
}

/// Points of a triangle that are not on lines where rounding may count twice.
const std::vector<std::array<double, 3>> kSamples{{0.341, 0.322, 0.337}, {0.711, 0.183, 0.106}, {0.129, 0.744, 0.127},
                                                  {0.152, 0.097, 0.751}, {0.493, 0.479, 0.028}, {0.031, 0.512, 0.457},
                                                  {0.447, 0.019, 0.534}, {0.913, 0.043, 0.044}, {0.233, 0.541, 0.226}};

void require_one_origin(const Pieces& pieces) {
  std::size_t triangles = 0;
  for (std::int32_t i = 0; i < pieces.cells.cut.mesh.vertex_count(); ++i) {
    const DualPolygon* polygon = pieces.polygons.at(VertexId(i));
    if (!polygon) continue;
    for (const DualPolygon::Triangle& triangle : polygon->triangles) {
      ++triangles;
      for (const auto& w : kSamples) {
        Vec2 point = Vec2::Zero();
        for (std::size_t k = 0; k < 3; ++k) point += w[k] * polygon->corner(triangle.corners[k]);
        REQUIRE(count_origins(pieces, *polygon, point) == 1);
      }
    }
  }
  REQUIRE(triangles == static_cast<std::size_t>(pieces.polygons.remesh().face_count()));
}

/// The sum of areas is that of the polygon, face by face of the disc, and triangle by triangle of the fan.
void require_areas(const Pieces& pieces) {
  std::map<const DualPolygon*, double> covered;
  for (const PlaneCell& plane : pieces.planes) {
    double disc = 0, fan = 0;
    for (const FaceId f : pieces.faces[GeneratorId(plane.vertex.value())]) {
      const auto& [a, b, c] = pieces.cells.cut.mesh.vertices(f);
      const double face = area(plane.disc.at(a), plane.disc.at(b), plane.disc.at(c));
      REQUIRE(face > 0);
      disc += face;
    }
    for (std::size_t i = 0; i < plane.targets.size(); ++i) {
      const BorderTarget& t = plane.targets[i];
      fan += area(plane.apex, plane.bases[i], plane.bases[i + 1]);
      REQUIRE(area(t.apex, t.from, t.to) > 0);
      covered[t.polygon] += area(t.apex, t.from, t.to);
    }
    REQUIRE(disc == Approx(fan));
  }
  for (const auto& [polygon, sum] : covered) {
    double whole = 0;
    for (const auto& t : polygon->triangles) {
      whole += area(polygon->corner(t.corners[0]), polygon->corner(t.corners[1]), polygon->corner(t.corners[2]));
    }
    REQUIRE(sum == Approx(whole));
  }
}

/// Each piece of a border between two cells goes to the same points, seen from either.
void require_same_borders(const Pieces& pieces) {
  std::map<HalfedgeId, const BorderTarget*> targets;
  for (const PlaneCell& plane : pieces.planes) {
    for (const BorderTarget& t : plane.targets) targets[t.halfedge] = &t;
  }
  for (const auto& [h, t] : targets) {
    const auto other = targets.find(pieces.cells.cut.mesh.twin(h));
    REQUIRE(other != targets.end());
    REQUIRE(other->second->polygon == t->polygon);
    REQUIRE(other->second->from == t->to);
    REQUIRE(other->second->to == t->from);
  }
}

void require_pieces(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  const RemeshResult result = remesh(mesh, generators);
  const Pieces pieces(mesh, result);
  require_areas(pieces);
  require_same_borders(pieces);
  require_one_origin(pieces);
}

TEST_CASE("cell map: every point of the remesh has exactly one origin") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const auto& [count, seed] : test::thinned({std::pair{6, 3u}, {40, 4u}})) {
      INFO(name << ", " << count << " generators, seed " << seed);
      require_pieces(mesh, test::random_generators(mesh, count, seed));
    }
  }
}

TEST_CASE("cell map: where four cells meet, two triangles have one centre") {
  const Mesh grid = test::make_grid(4, 4);
  std::vector<SurfacePoint> generators;
  for (const double x : {1.0, 3.0}) {
    for (const double y : {1.0, 3.0}) {
      for (std::int32_t v = 0; v < grid.vertex_count(); ++v) {
        if (grid.position(VertexId(v)) == Vec3(x, y, 0)) generators.push_back(vertex_point(grid, VertexId(v)));
      }
    }
  }
  REQUIRE(generators.size() == 4);
  require_pieces(grid, generators);
}

TEST_CASE("cell map: of a cell at the boundary, the anchor goes to the vertex") {
  const Mesh half = test::make_half_sphere(3);
  const RemeshResult result = remesh(half, test::random_generators(half, 20, 5));
  const Pieces pieces(half, result);
  int at_boundary = 0;
  for (const PlaneCell& plane : pieces.planes) {
    const VertexId anchor = pieces.cells.anchors[GeneratorId(plane.vertex.value())];
    if (!anchor.valid()) continue;
    ++at_boundary;
    CHECK(plane.disc.at(anchor) == plane.apex);
    CHECK(is_on_boundary(half, plane.origin));
  }
  CHECK(at_boundary >= 3);
}

}  // namespace gvd::test_cell_map

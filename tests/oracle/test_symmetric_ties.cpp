// Exact diagrams where everything is a tie: regular solids and grids, by an oracle outside of the solver.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "oracle/equidistance.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_symmetric_ties {

Mesh make_octahedron() {
  return test::make_mesh({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                         {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

/// The unit cube with n x n squares a side.
Mesh make_cube(int n) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  std::map<std::array<int, 3>, int> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = known.try_emplace(at, static_cast<int>(positions.size()));
    if (is_new) positions.push_back(Vec3(at[0], at[1], at[2]) / n);
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int u, int v) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = i + u;
            at[(axis + 2) % 3] = j + v;
            return vertex(at);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side == n) {
            faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
          } else {
            faces.insert(faces.end(), {{a, c, b}, {a, d, c}});
          }
        }
      }
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

std::vector<test::NamedMesh> symmetric_meshes() {
  return {{"tetrahedron", test::make_tetrahedron()}, {"octahedron", make_octahedron()},
          {"icosahedron", test::make_sphere(0)},     {"cube of 12 faces", make_cube(1)},
          {"cube of 48 faces", make_cube(2)},        {"cube of 108 faces", make_cube(3)},
          {"pillow", test::make_pillow()},           {"grid of 1", test::make_grid(1, 1)},
          {"grid of 4", test::make_grid(2, 2)},      {"grid of 12", test::make_grid(4, 3)},
          {"plate", test::make_plate(2, 0.5)}};
}

std::vector<SurfacePoint> all_vertices(const Mesh& mesh) {
  std::vector<SurfacePoint> points;
  for (int v = 0; v < mesh.vertex_count(); ++v) points.push_back(vertex_point(mesh, VertexId(v)));
  return points;
}

std::vector<SurfacePoint> middles_of_edges(const Mesh& mesh) {
  std::vector<SurfacePoint> points;
  for (int e = 0; e < mesh.edge_count(); ++e) points.push_back(edge_point(mesh.halfedge(EdgeId(e)), 0.5));
  return points;
}

std::vector<SurfacePoint> centres_of_faces(const Mesh& mesh) {
  std::vector<SurfacePoint> points;
  for (int f = 0; f < mesh.face_count(); ++f) points.push_back(make_surface_point(FaceId(f), {1 / 3., 1 / 3., 1 / 3.}));
  return points;
}

/// The middles of a mesh's squares, each on the diagonal that its two faces share.
std::vector<SurfacePoint> middles_of_squares(const Mesh& mesh) {
  std::vector<SurfacePoint> points;
  for (int f = 0; f < mesh.face_count(); f += 2) {
    HalfedgeId diagonal = Mesh::halfedge(FaceId(f), 0);
    for (int corner = 1; corner < 3; ++corner) {
      const HalfedgeId h = Mesh::halfedge(FaceId(f), corner);
      if (mesh.length(h) > mesh.length(diagonal)) diagonal = h;
    }
    points.push_back(edge_point(diagonal, 0.5));
  }
  return points;
}

/// Crossings keep 2e-12 of their edge from its ends. Branch points whose order a tie has reversed lie up to 4.8e-12 of
/// the face's size on the wrong side. Over such a length the difference of two distances changes by up to twice as
/// much.
void require_equidistant_but_for_ties(const Mesh& mesh, const Diagram& diagram) {
  const double longest = longest_edge(mesh), rounding = 1e-14 * mesh.bbox_diagonal();
  const double crossings = 4e-12 * longest + rounding, branch_points = 9.6e-12 * longest + rounding;
  test::require_equidistant(mesh, diagram, {crossings, branch_points, branch_points});
}

TEST_CASE("where all is a tie, branch points and crossings are equally far by CGAL's shortest paths") {
  for (const auto& [name, mesh] : symmetric_meshes()) {
    for (const auto& [kind, generators] : std::map<std::string, std::vector<SurfacePoint>>{
             {"vertices", all_vertices(mesh)}, {"edges", middles_of_edges(mesh)}, {"faces", centres_of_faces(mesh)}}) {
      INFO(name << ", generators on its " << kind);
      require_equidistant_but_for_ties(mesh, test::compute_sound_exact(mesh, generators));
    }
  }
}

TEST_CASE("every second vertex, edge and face of a symmetric mesh: some ties are left") {
  for (const auto& [name, mesh] : symmetric_meshes()) {
    for (const auto& all : {all_vertices(mesh), middles_of_edges(mesh), centres_of_faces(mesh)}) {
      for (const std::size_t step : {std::size_t{2}, std::size_t{3}}) {
        std::vector<SurfacePoint> generators;
        for (std::size_t i = 0; i < all.size(); i += step) generators.push_back(all[i]);
        INFO(name << ", " << generators.size() << " generators, every " << step);
        require_equidistant_but_for_ties(mesh, test::compute_sound_exact(mesh, generators));
      }
    }
  }
}

TEST_CASE("cells that are the faces of a solid, the squares of a cube and of a grid, meet at its vertices") {
  struct Case {
    std::string name;
    Mesh mesh;
    std::vector<SurfacePoint> generators;
    int vertices;  ///< where cells meet
    int degree;    ///< how many of them
  };
  const Mesh tetrahedron = test::make_tetrahedron(), octahedron = make_octahedron(), icosahedron = test::make_sphere(0);
  const Mesh cube = make_cube(1), grid = test::make_grid(4, 3);
  for (const Case& c :
       {Case{"tetrahedron", tetrahedron, centres_of_faces(tetrahedron), 4, 3},
        Case{"octahedron", octahedron, centres_of_faces(octahedron), 6, 4},
        Case{"icosahedron", icosahedron, centres_of_faces(icosahedron), 12, 5},
        Case{"cube", cube, middles_of_squares(cube), 8, 3}, Case{"grid", grid, middles_of_squares(grid), 6, 4}}) {
    INFO(c.name);
    const Diagram diagram = test::compute_sound_exact(c.mesh, c.generators);
    require_equidistant_but_for_ties(c.mesh, diagram);
    // Where four or more meet, the tie is broken: several branch points of three, all in the same place.
    std::map<VertexId, int> count;
    for (const BranchPoint& b : diagram.branch_points) {
      CHECK(b.generators.size() == 3);
      const auto at = [&](const Vec3& p) { return (p - b.position).norm() <= 4.8e-12 * longest_edge(c.mesh); };
      const auto vertex = std::find_if(c.mesh.positions().begin(), c.mesh.positions().end(), at);
      REQUIRE(vertex != c.mesh.positions().end());
      ++count[VertexId(vertex - c.mesh.positions().begin())];
    }
    CHECK(count.size() == static_cast<std::size_t>(c.vertices));
    for (const auto& [vertex, branch_points] : count) CHECK(branch_points == c.degree - 2);
  }
}

}  // namespace gvd::test_symmetric_ties

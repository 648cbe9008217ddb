// Reads a mesh, builds a geodesic Voronoi diagram of a few generators, and walks through what it holds.
//
//   diagram_of_a_mesh MESH
#include <cstdio>
#include <exception>
#include <gvd/check.hpp>
#include <gvd/diagram.hpp>
#include <gvd/read_soup.hpp>
#include <gvd/soup.hpp>
#include <vector>

int main(int argc, char* argv[]) {
  if (argc != 2) return std::fprintf(stderr, "usage: %s MESH\n", argv[0]), 2;
  try {
    // Any polygon soup becomes a checked mesh, or an error that says what is wrong with it.
    const gvd::CheckedMesh checked = gvd::build_mesh(gvd::read_soup(argv[1]));
    const gvd::Mesh& mesh = checked.mesh;

    // Generators are surface points: here a vertex, a point on an edge and one inside a face.
    const std::vector<gvd::SurfacePoint> generators{
        gvd::vertex_point(mesh, gvd::VertexId(0)),
        gvd::edge_point(gvd::Mesh::halfedge(gvd::FaceId(mesh.face_count() / 2), 0), 0.25),
        gvd::make_surface_point(gvd::FaceId(mesh.face_count() - 1), {0.2, 0.3, 0.5}),
    };
    const gvd::Diagram diagram = gvd::compute_diagram(mesh, generators);

    for (const gvd::Cell& cell : diagram.cells) {
      std::printf("cell %d: area %.6g, Euler characteristic %d, %zu neighbours\n", cell.generator.value(), cell.area,
                  cell.euler_characteristic, cell.neighbours.size());
    }
    for (const gvd::Bisector& bisector : diagram.bisectors) {
      std::printf("bisector between %d and %d: %zu points%s\n", bisector.left.value(), bisector.right.value(),
                  bisector.points.size(), bisector.closed ? ", closed" : "");
    }
    for (const gvd::BranchPoint& branch : diagram.branch_points) {
      std::printf("branch point at %.6g %.6g %.6g\n", branch.position.x(), branch.position.y(), branch.position.z());
    }

    // Every invariant of a diagram can be asked for; a diagram that the library built holds them all.
    const gvd::DiagramCheck check = gvd::check_diagram(mesh, diagram);
    for (const std::string& violation : check.violations) std::printf("violated: %s\n", violation.c_str());
    return check.ok() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

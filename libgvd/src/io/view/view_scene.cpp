// A diagram as a scene of the page, with its figures and the energies of its cells.
//
// The energy of a cell is integrated face by face, where the squared distance is a quadratic function of barycentric
// coordinates; the midpoints of the sides of a triangle integrate it exactly. The Euler count compares the graph of the
// bisectors with the topology of the cells, which were found independently.
// Source: the rule of the midpoints is exact to degree 2; V - E + F over branch points, bisectors and cells is Euler's.
// Invariant: a scene refers to its mesh and copies all else, so the diagram may go before the page is made.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "io/view/view_steps.hpp"

namespace gvd {
namespace {

/// The squared distance in one face, as a function of barycentric coordinates.
class SquaredDistance {
 public:
  SquaredDistance(const Mesh& mesh, const Diagram& diagram, FaceId f) {
    const auto& corners = mesh.vertices(f);
    for (int i = 0; i < 3; ++i) {
      corner_[i] = std::pow(diagram.vertex_distance[corners[i]], 2);
      side_[i] = (mesh.position(corners[(i + 1) % 3]) - mesh.position(corners[i])).squaredNorm();
    }
  }

  double operator()(const Bary& b) const {
    const double value = interpolate(b, corner_[0], corner_[1], corner_[2]) -
                         (b[0] * b[1] * side_[0] + b[1] * b[2] * side_[1] + b[2] * b[0] * side_[2]);
    return value > 0 ? value : 0;
  }

 private:
  Bary corner_{}, side_{};
};

/// Integral over a polygon of a face of area `area`: a fan of triangles with signed areas, each by the midpoints of its
/// sides, which is exact for quadratic functions.
double integrate(const SquaredDistance& squared, double area, const std::vector<Bary>& polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Bary &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double share = twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
    sum += area * share * (squared(mix(a, b, 0.5)) + squared(mix(b, c, 0.5)) + squared(mix(c, a, 0.5))) / 3;
  }
  return sum;
}

/// Twice the excess of the cells' Euler characteristics over that of the mesh, as the graph of the bisectors gives it.
///
/// The count follows from V - E + F over branch points, bisectors, boundary pieces and cells. A branch point of degree
/// d counts d - 2 inside the mesh and d on the boundary. The end of a bisector on the boundary counts 1.
std::int64_t count_excess(const Mesh& mesh, const Diagram& diagram) {
  std::int64_t excess = 0;
  for (const Bisector& bisector : diagram.bisectors) excess += bisector.closed ? 0 : 2;
  for (const BranchPoint& branch_point : diagram.branch_points)
    excess -= is_on_boundary(mesh, branch_point.point) ? 0 : 2;
  return excess;
}

bool reaches_everything(const Diagram& diagram) {
  return std::all_of(diagram.vertex_label.begin(), diagram.vertex_label.end(),
                     [](GeneratorId label) { return label.valid(); });
}

std::vector<ViewFigure> make_figures(const Mesh& mesh, const Diagram& diagram, const Mesh& shown) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  std::int64_t characteristics = 0, discs = 0;
  for (const Cell& cell : diagram.cells) {
    characteristics += cell.euler_characteristic;
    discs += cell.euler_characteristic == 1 && cell.components == 1;
  }
  std::vector<ViewFigure> figures{{"Faces", fmt::format("{}", shown.face_count())},
                                  {"Vertices", fmt::format("{}", shown.vertex_count())},
                                  {"Area", fmt::format("{:.6g}", summary.area)},
                                  {"Euler characteristic", fmt::format("{}", summary.euler_characteristic)},
                                  {"Generators", fmt::format("{}", diagram.generators.size())},
                                  {"Branch points", fmt::format("{}", diagram.branch_points.size())},
                                  {"Bisectors", fmt::format("{}", diagram.bisectors.size())},
                                  {"Bisector length", fmt::format("{:.6g}", diagram.length)},
                                  {"Disc regions", fmt::format("{} of {}", discs, diagram.cells.size())}};
  if (&shown != &mesh) figures.insert(figures.begin() + 1, {"Faces before the cut", fmt::format("{}", summary.faces)});
  if (reaches_everything(diagram)) {
    figures.push_back({"Euler count", fmt::format("{} of {}", count_excess(mesh, diagram),
                                                  2 * (characteristics - summary.euler_characteristic))});
  }
  return figures;
}

std::vector<Vec3> make_polyline(const Mesh& mesh, const Bisector& bisector) {
  std::vector<Vec3> polyline;
  polyline.reserve(bisector.points.size() + 1);
  for (const SurfacePoint& point : bisector.points) polyline.push_back(position(mesh, point));
  if (bisector.closed && !polyline.empty()) polyline.push_back(polyline.front());
  return polyline;
}

/// The part of a scene that does not depend on the mesh that is shown.
ViewScene make_diagram_scene(std::string name, const Mesh& mesh, const Diagram& diagram) {
  ViewScene scene;
  scene.name = std::move(name);
  for (const Bisector& bisector : diagram.bisectors) scene.bisectors.push_back(make_polyline(mesh, bisector));
  for (const SurfacePoint& generator : diagram.generators) scene.generators.push_back(position(mesh, generator));
  for (const BranchPoint& branch_point : diagram.branch_points) scene.branch_points.push_back(branch_point.position);
  scene.cells = diagram.cells;
  scene.cell_energy = io::compute_cell_energies(mesh, diagram);
  return scene;
}

}  // namespace

namespace io {

IdVector<GeneratorId, double> compute_cell_energies(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, double> energies(diagram.cells.size(), 0.0);
  const auto add = [&](FaceId f, GeneratorId cell, const std::vector<Bary>& polygon) {
    const double energy = integrate(SquaredDistance(mesh, diagram, f), mesh.area(f), polygon);
    if (std::isfinite(energy)) energies[cell] += energy;
  };
  const std::vector<Bary> whole(kWholeTriangle.begin(), kWholeTriangle.end());
  for (const FaceId f : diagram.face_label.ids()) {
    if (diagram.face_label[f].valid()) add(f, diagram.face_label[f], whole);
  }
  for (const FacePiece& piece : diagram.pieces) add(piece.face, piece.generator, piece.corners);
  return energies;
}

}  // namespace io

ViewScene make_view_scene(std::string name, const Mesh& mesh, const Diagram& diagram) {
  ViewScene scene = make_diagram_scene(std::move(name), mesh, diagram);
  scene.mesh = &mesh;
  scene.face_label = diagram.face_label;
  scene.pieces = diagram.pieces;
  scene.vertex_distance = diagram.vertex_distance;
  scene.figures = make_figures(mesh, diagram, mesh);
  return scene;
}

ViewScene make_view_scene(std::string name, const LabelledMesh& shown) {
  if (shown.diagram == nullptr || shown.face_label == nullptr || shown.vertex_distance == nullptr)
    throw Error(ErrorCode::precondition, "a scene of a labelled mesh needs a diagram, face labels and distances");
  const Mesh& mesh = shown.diagram_mesh != nullptr ? *shown.diagram_mesh : shown.mesh;
  ViewScene scene = make_diagram_scene(std::move(name), mesh, *shown.diagram);
  scene.mesh = &shown.mesh;
  scene.face_label = *shown.face_label;
  scene.vertex_distance = *shown.vertex_distance;
  scene.figures = make_figures(mesh, *shown.diagram, shown.mesh);
  return scene;
}

}  // namespace gvd

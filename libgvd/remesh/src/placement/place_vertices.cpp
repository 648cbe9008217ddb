#include <algorithm>

#include "gvd/error.hpp"
#include "gvd/placement.hpp"
#include "placement/cell_quadrics.hpp"
#include "placement/crease_cells.hpp"
#include "placement/fit_vertices.hpp"
#include "placement/move_guard.hpp"
#include "placement/surface_samples.hpp"
#include "placement/with_positions.hpp"

namespace gvd {
namespace {

/// Eigenvalues of a quadric below this fraction of the largest one are those of directions along the surface. The cell
/// of a sphere with an angular radius of r has r^2 / 4: 0.2 radians.
constexpr double kQuadricTruncation = 0.01;
/// Samples for each vertex.
constexpr double kSamplesPerVertex = 20;
/// Weight of the springs in the rounds of the fit, as a fraction of a cell's area. They matter along the surface, where
/// the distances hardly change: docs/notes/remesh-placement.md has what weaker and stronger ones give.
constexpr double kSpring = 0.02;
/// The same for cells with creases, which triangles miss unless the vertices move there.
constexpr double kCreaseSpring = 0.003;
/// A cell of no area must have a spring, too: that of a square with sides of a millionth of the bounding box's
/// diagonal.
constexpr double kLeastCellArea = 1e-12;
/// How much stronger the springs of vertices are that stay.
constexpr double kRigidSpring = 1e6;

class Placer {
 public:
  Placer(const Mesh& surface, const Diagram& diagram, const Mesh& remesh, const std::vector<SurfacePoint>& face_points,
         const PlacementOptions& options)
      : surface_(surface),
        remesh_(remesh),
        options_(options),
        quadrics_(compute_cell_quadrics(surface, diagram)),
        creased_(find_crease_cells(surface, diagram)),
        guard_(surface, remesh, diagram.generators, face_points, options) {}

  std::vector<Vec3> run() {
    std::vector<Vec3> positions = guard_.move(remesh_.positions(), find_optima());
    if (options_.method == Placement::quadric) return positions;
    const NearestFaceTree tree(surface_);
    const double count = kSamplesPerVertex * remesh_.vertex_count();
    const FitTarget target{&surface_, &tree, sample_surface(surface_, count), count, options_.threads};
    const std::vector<VertexAnchor> anchors = make_anchors();
    for (int round = 0; round < kFitRounds; ++round) {
      std::vector<Vec3> fitted = fit_vertices(with_positions(remesh_, positions), target, anchors);
      keep_fixed(fitted);
      positions = guard_.move(positions, fitted);
    }
    return positions;
  }

 private:
  std::vector<Vec3> find_optima() const {
    std::vector<Vec3> optima = remesh_.positions();
    for (std::size_t v = 0; v < optima.size(); ++v) {
      optima[v] += quadrics_[GeneratorId(static_cast<std::int64_t>(v))].minimize(kQuadricTruncation);
    }
    keep_fixed(optima);
    return optima;
  }

  void keep_fixed(std::vector<Vec3>& positions) const {
    for (const GeneratorId g : options_.fixed) positions[g.index()] = remesh_.position(VertexId(g.value()));
  }

  std::vector<VertexAnchor> make_anchors() const {
    std::vector<VertexAnchor> anchors;
    for (std::int32_t i = 0; i < remesh_.vertex_count(); ++i) {
      const GeneratorId g(i);
      const double spring = creased_[g] ? kCreaseSpring : kSpring;
      anchors.push_back({remesh_.position(VertexId(i)), spring * std::max(quadrics_[g].area, least_area())});
    }
    for (const GeneratorId g : options_.fixed) anchors[g.index()].weight *= kRigidSpring;
    return anchors;
  }

  double least_area() const { return kLeastCellArea * surface_.bbox_diagonal() * surface_.bbox_diagonal(); }

  const Mesh& surface_;
  const Mesh& remesh_;
  const PlacementOptions& options_;
  IdVector<GeneratorId, Quadric> quadrics_;
  IdVector<GeneratorId, char> creased_;
  MoveGuard guard_;
};

}  // namespace

std::vector<Vec3> place_vertices(const Mesh& surface, const Diagram& diagram, const Mesh& remesh,
                                 const std::vector<SurfacePoint>& face_points, const PlacementOptions& options) {
  if (static_cast<std::size_t>(remesh.vertex_count()) != diagram.generators.size() ||
      static_cast<std::size_t>(remesh.face_count()) != face_points.size()) {
    throw Error(ErrorCode::precondition, "the remesh is not the dual of the diagram");
  }
  if (options.method == Placement::generator) return remesh.positions();
  return Placer(surface, diagram, remesh, face_points, options).run();
}

}  // namespace gvd

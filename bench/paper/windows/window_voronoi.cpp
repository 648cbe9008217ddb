#include "windows/window_voronoi.hpp"

#include <memory>
#include <utility>

#include "cpu_clock.hpp"
#include "diagram/envelope/trace_envelope.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_queries.hpp"
#include "mesh/working_mesh.hpp"
#include "pieces/clip_polygon.hpp"
#include "pieces/collect_pieces.hpp"
#include "pieces/working_pieces.hpp"
#include "windows/separate_windows.hpp"
#include "windows/weighted_face.hpp"

namespace gvd::paper {
namespace {

/// Cuts all faces of a working mesh.
class FaceCutter {
 public:
  FaceCutter(const WorkingMesh& working, const DistanceField& field, const NearestLabels& labels)
      : mesh_(working.mesh()), field_(field), labels_(labels) {
    const ParallelChunks one_thread(1, no_progress_);
    // The tolerance is for arcs, which are not traced here.
    crossings_ = EnvelopeTracer(working, field, mesh_.mean_edge_length(), one_thread).cross_edges(labels);
  }

  Pieces cut_all() {
    Pieces pieces;
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      boundary_crossings(mesh_, crossings_, f, on_boundary_);
      if (on_boundary_.empty()) {
        pieces.push_back({f, labels_.label[mesh_.vertices(f)[0]], whole_face()});
      } else {
        cut(f, pieces);
      }
    }
    return pieces;
  }

  std::int64_t forced_faces() const { return forced_faces_; }

 private:
  void cut(FaceId f, Pieces& pieces) {
    const FaceLayout layout(mesh_, f);
    field_.collect(f, layout, sources_);
    WeightedFace::Cut cut = WeightedFace(layout, sources_).cut(make_runs(on_boundary_));
    forced_faces_ += cut.forced ? 1 : 0;
    for (BoundaryRun& run : cut.polygons) pieces.push_back({f, run.generator, std::move(run.points)});
  }

  const Mesh& mesh_;
  const DistanceField& field_;
  const NearestLabels& labels_;
  Progress no_progress_;
  Crossings crossings_;
  std::vector<BoundaryCrossing> on_boundary_;  // of the current face
  std::vector<FaceSource> sources_;            // likewise
  std::int64_t forced_faces_ = 0;
};

/// Distances with the labels of the vertices.
struct Propagated {
  WindowField field;  ///< of all generators at once, or empty
  std::unique_ptr<DistanceField> distances;
  IdVector<VertexId, double> distance;
  IdVector<VertexId, GeneratorId> label;
};

void propagate(const WorkingMesh& working, bool unpruned, Propagated& result) {
  const Mesh& mesh = working.mesh();
  if (unpruned) {
    auto separate = std::make_unique<SeparateWindows>(mesh, working.generator_vertices().raw());
    result.distance = separate->distance();
    result.label = separate->label();
    result.distances = std::move(separate);
    return;
  }
  PropagationOptions options;
  options.keep = KeepWindows::all;
  options.threads = 1;
  result.field = propagate_windows(mesh, working.generator_vertices().raw(), options, {});
  result.distance = result.field.distance;
  result.label = result.field.label;
  result.distances = std::make_unique<WindowDistances>(mesh, result.field);
}

}  // namespace

Comparison compute_window_voronoi(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                  const WindowVoronoiOptions& options) {
  const WorkingMesh working(mesh, generators);
  Comparison result;
  const double start = bench::cpu_milliseconds();
  Propagated propagated;
  propagate(working, options.unpruned, propagated);
  const double reached = bench::cpu_milliseconds();
  const Progress no_progress;
  const NearestLabels labels =
      take_labels(working, propagated.distance, propagated.label, ParallelChunks(1, no_progress));
  FaceCutter cutter(working, *propagated.distances, labels);
  Pieces pieces = cutter.cut_all();
  result.field_ms = reached - start;
  result.diagram_ms = bench::cpu_milliseconds() - reached;
  result.faults.forced_faces = cutter.forced_faces();
  collect_pieces(mesh, generators, take_to_input(working, std::move(pieces)), result);
  return result;
}

}  // namespace gvd::paper

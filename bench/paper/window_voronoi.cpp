// The geodesic Voronoi diagram from exact windows with straight segments, after Xu et al. ([27] in the paper).
//
// Window propagation gives all windows that enter a triangle, and the exact distances of its corners. Unfolded into its
// plane, they are points with additive weights. Along each edge their lower envelope says where the nearest generator
// changes; a crossing is stored once for both faces. WeightedFace joins the crossings of a triangle. In the unpruned
// mode each generator's windows cover the whole mesh: the diagram is the same, the time is that of m single-source
// runs, as the original algorithm has it.
//
// Source: C. Xu, Y.-J. Liu, Q. Sun, J. Li, Y. He, Polyline-sourced geodesic Voronoi diagrams on triangle meshes, 2014.
// Distances are exact; what is not are the segments, because a bisector of weighted points is a hyperbola. So E of this
// method is what straight segments alone cost. Section 5.3 and table 4 of the paper compare with it.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "clocks.hpp"
#include "comparators.hpp"
#include "diagram/envelope/trace_envelope.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_field.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"
#include "pieces.hpp"
#include "weighted_face.hpp"

namespace gvd::paper {

namespace {

/// Vertices are nearer to another generator only if its distance is less by this fraction; rounding decides nothing.
constexpr double kEqual = 2e-14;

/// Lengths are enlarged by this fraction: on symmetric meshes a generator wins in a single point of an edge.
constexpr double kSlack = 1e-9;

/// Bytes that the windows may need.
constexpr double kMostMemory = 8e9;

/// Throws before the windows fill the memory: as many more will come for each generator that is left.
void check_memory(std::size_t generators, std::size_t windows) {
  const double bytes = double(generators) * double(windows * (sizeof(Window) + 4));
  if (bytes <= kMostMemory) return;
  throw Error(ErrorCode::precondition,
              fmt::format("the windows of {} generators, one by one, need {:.1f} GB; take fewer generators", generators,
                          1e-9 * bytes));
}

PropagationOptions all_windows() {
  PropagationOptions options;
  options.keep = KeepWindows::all;
  options.threads = 1;
  return options;
}

/// Exact distances from one window propagation for each generator, over the whole mesh: no generator's windows are
/// pruned by the distances of another one.
class SeparateWindows final : public DistanceField {
 public:
  /// Runs the propagations, on one thread. The mesh must outlive this.
  /// Throws Error{precondition} if the windows of all generators would need more than kMostMemory.
  SeparateWindows(const Mesh& mesh, const std::vector<VertexId>& generators)
      : mesh_(mesh), distance_(mesh.vertex_count(), kInfinity), label_(mesh.vertex_count()) {
    for (const VertexId v : generators) {
      fields_.push_back(propagate_windows(mesh, {v}, all_windows(), {}));
      check_memory(generators.size(), fields_.back().windows.size());
    }
    for (std::size_t g = 0; g < fields_.size(); ++g) {
      for (const VertexId v : mesh_.vertices()) {
        if (!(fields_[g].distance[v] < distance_[v] * (1 - kEqual))) continue;
        distance_[v] = fields_[g].distance[v];
        label_[v] = GeneratorId(g);
      }
    }
  }

  /// Of every vertex: the distance to its nearest generator, and that generator, the lower one where two are equal.
  const IdVector<VertexId, double>& distance() const { return distance_; }
  const IdVector<VertexId, GeneratorId>& label() const { return label_; }

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override {
    return find_edges(mesh_, parallel, [&](EdgeId e) {
      return std::count_if(fields_.begin(), fields_.end(), [&](const WindowField& f) { return can_win(f, e); }) > 1;
    });
  }

  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override {
    collect_winners(e, sources, [&](const WindowField& field, std::vector<EdgeSource>& own) {
      collect_edge_sources(mesh_, field, mesh_.halfedge(e), own);
    });
  }

  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override {
    collect_winners(f, sources, [&](const WindowField& field, std::vector<FaceSource>& own) {
      collect_face_sources(mesh_, field, f, layout, own);
    });
  }

 private:
  /// The sources in an edge or a face of all generators that can win there.
  template <class Element, class Source, class CollectOwn>
  void collect_winners(Element element, std::vector<Source>& sources, const CollectOwn& collect_own) const {
    sources.clear();
    std::vector<Source> own;
    for (std::size_t g = 0; g < fields_.size(); ++g) {
      if (!can_win(fields_[g], element)) continue;
      collect_own(fields_[g], own);
      for (Source& source : own) source.generator = GeneratorId(g);
      sources.insert(sources.end(), own.begin(), own.end());
    }
  }

  /// Whether the generator can be the nearest one in a point within `longest` of v: two distances change by that much
  /// each.
  bool can_win(const WindowField& field, VertexId v, double longest) const {
    return field.distance[v] <= distance_[v] * (1 + kSlack) + 2 * longest * (1 + kSlack);
  }
  bool can_win(const WindowField& field, EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e);
    const double length = mesh_.length(h);
    return can_win(field, mesh_.from(h), length) && can_win(field, mesh_.to(h), length);
  }
  bool can_win(const WindowField& field, FaceId f) const {
    const double longest = std::ranges::max(mesh_.shape(f).length);
    return std::ranges::all_of(mesh_.vertices(f), [&](VertexId v) { return can_win(field, v, longest); });
  }

  const Mesh& mesh_;
  std::vector<WindowField> fields_;  // [generator]
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, GeneratorId> label_;
};

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
    for (const FaceId f : mesh_.faces()) {
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

/// Fills in the distances of all generators at once, or of each by itself.
void propagate(const WorkingMesh& working, bool unpruned, Propagated& result) {
  const Mesh& mesh = working.mesh();
  if (unpruned) {
    auto separate = std::make_unique<SeparateWindows>(mesh, working.generator_vertices().raw());
    result.distance = separate->distance();
    result.label = separate->label();
    result.distances = std::move(separate);
    return;
  }
  result.field = propagate_windows(mesh, working.generator_vertices().raw(), all_windows(), {});
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

#include "map/cut_into_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "gvd/closest_point.hpp"
#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A generator on the boundary within this fraction of an edge from a vertex is taken to be there. Far above the
/// rounding of positions, far below a distance that shows.
constexpr double kAtVertex = 1e-6;

/// A place on an edge.
struct EdgeCut {
  HalfedgeId edge;
  double t = 0.5;
};

class CellCutter {
 public:
  CellCutter(const Mesh& surface, const RemeshResult& result) : surface_(surface), generators_(result.generators) {
    cells_.cut = cut_faces(surface, result.diagram);
  }

  CellSurface run() {
    trace();
    cells_.anchors.assign(generators_.size(), {});
    split_short_runs();
    trace();
    split_at_anchors();
    trace();
    split_chords();
    trace();
    return std::move(cells_);
  }

 private:
  const Mesh& mesh() const { return cells_.cut.mesh; }

  void trace() { cells_.borders = trace_cell_borders(mesh(), cells_.cut.label, generators_.size()); }

  VertexId split(HalfedgeId h, double t) {
    const std::array<FaceId, 2> faces{Mesh::face(h), mesh().twin(h).valid() ? Mesh::face(mesh().twin(h)) : FaceId()};
    const Vec3 at = (1 - t) * mesh().position(mesh().from(h)) + t * mesh().position(mesh().to(h));
    const VertexId v = MeshEditor(cells_.cut.mesh).split_edge(h, at);
    for (const FaceId f : faces) {
      if (!f.valid()) continue;
      cells_.cut.parent.push_back(FaceId(cells_.cut.parent[f]));
      cells_.cut.label.push_back(GeneratorId(cells_.cut.label[f]));
    }
    return v;
  }

  /// Edges keep their ids when others are split, halfedges do not.
  void split_edges(const std::vector<EdgeId>& edges) {
    for (const EdgeId e : edges) split(mesh().halfedge(e), 0.5);
  }

  void split_short_runs() {
    std::vector<EdgeId> edges;
    for (std::size_t i = 0; i < cells_.borders.size(); ++i) {
      const GeneratorId g(i);
      for (const BorderRun& run : cells_.borders[g].runs) {
        if (run.end == run.begin + 1 && run.other > g) edges.push_back(mesh().edge(cells_.borders[g].loop[run.begin]));
      }
    }
    split_edges(edges);
  }

  /// The place on the boundary of a cell that is nearest to its generator.
  EdgeCut nearest_on_boundary(GeneratorId g) const {
    const CellBorder& border = cells_.borders[g];
    const Vec3 at = position(surface_, generators_[g.index()]);
    EdgeCut best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = border.runs.back().begin; i < border.runs.back().end; ++i) {
      const HalfedgeId h = border.loop[i];
      const Vec3 &from = mesh().position(mesh().from(h)), along = mesh().position(mesh().to(h)) - from;
      const double t = std::clamp(foot_on_edge(mesh(), h, at), 0.0, 1.0);
      const double distance = (from + t * along - at).norm();
      if (distance < least) {
        least = distance;
        best = {h, t};
      }
    }
    return best;
  }

  /// The ends of the run belong to other cells, too: they can't be anchors.
  void split_at_anchors() {
    for (std::size_t i = 0; i < cells_.borders.size(); ++i) {
      const GeneratorId g(i);
      const CellBorder& border = cells_.borders[g];
      if (!border.at_boundary()) continue;
      const EdgeCut cut = nearest_on_boundary(g);
      const VertexId from = mesh().from(cut.edge), to = mesh().to(cut.edge);
      const BorderRun& run = border.runs.back();
      if (cut.t <= kAtVertex && from != mesh().from(border.loop[run.begin])) {
        cells_.anchors[g] = from;
      } else if (cut.t >= 1 - kAtVertex && to != mesh().to(border.loop[run.end - 1])) {
        cells_.anchors[g] = to;
      } else {
        cells_.anchors[g] = split(cut.edge, away_from_ends(cut.t));
      }
    }
  }

  static double away_from_ends(double t) {
    constexpr double kNearEnd = 0.01;
    if (t <= kAtVertex) return kNearEnd;
    return t >= 1 - kAtVertex ? 1 - kNearEnd : t;
  }

  void split_chords() {
    std::vector<EdgeId> chords;
    IdVector<VertexId, GeneratorId> side(static_cast<std::size_t>(mesh().vertex_count()));
    for (std::size_t i = 0; i < cells_.borders.size(); ++i) {
      const GeneratorId g(i);
      const CellBorder& border = cells_.borders[g];
      if (!border.at_boundary()) continue;
      const std::vector<VertexId> vertices = run_vertices(mesh(), border, border.runs.back());
      const auto anchor = std::find(vertices.begin(), vertices.end(), cells_.anchors[g]);
      collect_chords(g, {vertices.begin(), anchor + 1}, side, chords);
      for (const VertexId v : vertices) side[v] = GeneratorId();
      collect_chords(g, {anchor, vertices.end()}, side, chords);
      for (const VertexId v : vertices) side[v] = GeneratorId();
    }
    split_edges(chords);
  }

  /// Appends the edges inside cell g that join two of the vertices. `side` is invalid for all others.
  void collect_chords(GeneratorId g, const std::vector<VertexId>& vertices, IdVector<VertexId, GeneratorId>& side,
                      std::vector<EdgeId>& chords) const {
    for (const VertexId v : vertices) side[v] = g;
    for (const VertexId v : vertices) {
      for_each_outgoing(mesh(), v, [&](HalfedgeId h) {
        const HalfedgeId twin = mesh().twin(h);
        if (!twin.valid() || mesh().to(h) < v || side[mesh().to(h)] != g) return;
        const auto& label = cells_.cut.label;
        if (label[Mesh::face(h)] == g && label[Mesh::face(twin)] == g) chords.push_back(mesh().edge(h));
      });
    }
  }

  const Mesh& surface_;
  const std::vector<SurfacePoint>& generators_;
  CellSurface cells_;
};

}  // namespace

CellSurface cut_into_cells(const Mesh& surface, const RemeshResult& result) {
  return CellCutter(surface, result).run();
}

}  // namespace gvd

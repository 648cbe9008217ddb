// The arcs of the mesh's boundary that lie in one cell each.
//
// Bisectors that end on the boundary cut its loops into arcs. The ends on each halfedge are sorted along it. A walk
// round each loop then begins a new arc at every end; what comes before the first end belongs to the last arc.
// A cell with several arcs breaks property (3) of gvd/dual.hpp. Arcs also tell quadrics which parts of the boundary lie
// in a cell. Each boundary halfedge is passed once.

#include <algorithm>
#include <map>

#include "base/least.hpp"
#include "gvd/closest_point.hpp"
#include "mesh/vertex_ring.hpp"
#include "repair/cell_topology.hpp"

namespace gvd {
namespace {

/// The end of a bisector on a boundary halfedge.
struct BoundaryEnd {
  double at = 0;      ///< parameter along the halfedge
  GeneratorId after;  ///< the cell that follows it along the halfedge
};

class ArcLister {
 public:
  ArcLister(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {}

  std::vector<BoundaryArc> list() {
    for (const Bisector& b : diagram_.bisectors) {
      if (b.closed) continue;
      // The surface lies to the left of a boundary halfedge. So the next cell is the right one of a bisector that
      // starts there, and the left one of a bisector that ends there.
      if (!b.ends[0].valid()) add_end(b.points.front(), b.right);
      if (!b.ends[1].valid()) add_end(b.points.back(), b.left);
    }
    for (auto& [h, ends] : ends_) std::ranges::stable_sort(ends, {}, &BoundaryEnd::at);
    IdVector<HalfedgeId, char> seen(mesh_.halfedge_count(), 0);
    for (const HalfedgeId h : mesh_.halfedges()) {
      if (!mesh_.twin(h).valid() && !seen[h]) cut_loop(h, seen);
    }
    return std::move(arcs_);
  }

 private:
  void add_end(const SurfacePoint& point, GeneratorId after) {
    if (point.kind() == SurfacePoint::Kind::vertex) {
      ends_[mesh_.halfedge(vertex(mesh_, point))].push_back({0, after});
    } else if (point.kind() == SurfacePoint::Kind::edge) {
      const HalfedgeId h = halfedge(point);
      ends_[h].push_back({point.bary[Mesh::corner(Mesh::next(h))], after});
    }
  }

  /// Walks once round the boundary loop of `first`. The segments before the first end belong to the last arc.
  void cut_loop(HalfedgeId first, IdVector<HalfedgeId, char>& seen) {
    const std::size_t before = arcs_.size();
    BoundaryArc head;
    BoundaryArc* arc = &head;
    for (HalfedgeId h = first; !seen[h];) {
      seen[h] = 1;
      double begin = 0;
      const auto here = ends_.find(h);
      for (std::size_t i = 0; here != ends_.end() && i < here->second.size(); ++i) {
        const BoundaryEnd& end = here->second[i];
        arc->segments.push_back({h, begin, end.at});
        arcs_.push_back({end.after, {}});
        arc = &arcs_.back();
        begin = end.at;
      }
      arc->segments.push_back({h, begin, 1});
      h = next_on_boundary(mesh_, h);
    }
    if (arcs_.size() > before) {
      arc->segments.insert(arc->segments.end(), head.segments.begin(), head.segments.end());
    } else if (const GeneratorId whole = diagram_.vertex_label[mesh_.from(first)]; whole.valid()) {
      head.cell = whole;
      arcs_.push_back(std::move(head));
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::map<HalfedgeId, std::vector<BoundaryEnd>> ends_;
  std::vector<BoundaryArc> arcs_;
};

}  // namespace

std::vector<BoundaryArc> list_boundary_arcs(const Mesh& mesh, const Diagram& diagram) {
  return ArcLister(mesh, diagram).list();
}

SurfacePoint find_nearest_point(const Mesh& mesh, const BoundaryArc& arc, const Vec3& to) {
  Least<SurfacePoint> nearest;
  for (const BoundaryArc::Segment& segment : arc.segments) {
    const Vec3& from = mesh.position(mesh.from(segment.halfedge));
    const Vec3 along = mesh.position(mesh.to(segment.halfedge)) - from;
    const double t = std::clamp(foot_on_edge(mesh, segment.halfedge, to), segment.begin, segment.end);
    nearest.offer((from + t * along - to).squaredNorm(), edge_point(segment.halfedge, t));
  }
  return make_surface_point(nearest.value.face, nearest.value.bary);
}

}  // namespace gvd

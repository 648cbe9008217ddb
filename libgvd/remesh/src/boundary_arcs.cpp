#include "boundary_runs.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace gvd {
namespace {

/// Where a bisector ends on a boundary halfedge.
struct BoundaryEnd {
  double at = 0;      ///< parameter along the halfedge
  GeneratorId after;  ///< the cell ahead of it, along the halfedge
};

class RunLister {
 public:
  RunLister(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {}

  std::vector<BoundaryRun> list() {
    for (const Bisector& b : diagram_.bisectors) {
      if (b.closed) continue;
      // Seen with the surface to the left of the boundary, the cell ahead is to the right of a bisector that comes in.
      if (!b.ends[0].valid()) add_end(b.points.front(), b.right);
      if (!b.ends[1].valid()) add_end(b.points.back(), b.left);
    }
    for (auto& [h, ends] : ends_) {
      std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    }
    std::vector<char> seen(static_cast<std::size_t>(mesh_.halfedge_count()), 0);
    for (std::int32_t i = 0; i < mesh_.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (!mesh_.twin(h).valid() && !seen[h.index()]) cut_loop(h, seen);
    }
    return std::move(runs_);
  }

 private:
  void add_end(const SurfacePoint& point, GeneratorId after) {
    if (point.kind() == SurfacePoint::Kind::vertex) {
      ends_[mesh_.halfedge(vertex(mesh_, point))].push_back({0, after});
    } else if (point.kind() == SurfacePoint::Kind::edge) {
      const HalfedgeId h = halfedge(point);
      ends_[h].push_back({point.bary[static_cast<std::size_t>(Mesh::corner(Mesh::next(h)))], after});
    }
  }

  /// Walks once round the loop of `first`. What comes before the first end belongs to the run after the last one.
  void cut_loop(HalfedgeId first, std::vector<char>& seen) {
    const std::size_t before = runs_.size();
    BoundaryRun head;
    BoundaryRun* run = &head;
    for (HalfedgeId h = first; !seen[h.index()];) {
      seen[h.index()] = 1;
      double begin = 0;
      const auto here = ends_.find(h);
      for (std::size_t i = 0; here != ends_.end() && i < here->second.size(); ++i) {
        const BoundaryEnd& end = here->second[i];
        run->pieces.push_back({h, begin, end.at});
        runs_.push_back({end.after, {}});
        run = &runs_.back();
        begin = end.at;
      }
      run->pieces.push_back({h, begin, 1});
      h = Mesh::next(h);
      while (mesh_.twin(h).valid()) h = Mesh::next(mesh_.twin(h));
    }
    if (runs_.size() > before) {
      run->pieces.insert(run->pieces.end(), head.pieces.begin(), head.pieces.end());
    } else if (const GeneratorId whole = diagram_.vertex_label[mesh_.from(first)]; whole.valid()) {
      head.cell = whole;
      runs_.push_back(std::move(head));
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::map<HalfedgeId, std::vector<BoundaryEnd>> ends_;
  std::vector<BoundaryRun> runs_;
};

}  // namespace

std::vector<BoundaryRun> list_boundary_runs(const Mesh& mesh, const Diagram& diagram) {
  return RunLister(mesh, diagram).list();
}

SurfacePoint nearest_point(const Mesh& mesh, const BoundaryRun& run, const Vec3& to) {
  SurfacePoint best;
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryRun::Piece& piece : run.pieces) {
    const Vec3& from = mesh.position(mesh.from(piece.halfedge));
    const Vec3 along = mesh.position(mesh.to(piece.halfedge)) - from;
    const double t = std::clamp((to - from).dot(along) / along.squaredNorm(), piece.begin, piece.end);
    const double distance = (from + t * along - to).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best = edge_point(piece.halfedge, t);
  }
  return make_surface_point(best.face, best.bary);
}

}  // namespace gvd

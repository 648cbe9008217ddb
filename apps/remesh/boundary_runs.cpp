#include "boundary_runs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace gvd {
namespace {

/// Where a bisector ends on the boundary.
struct BoundaryEnd {
  double at = 0;      ///< parameter along its halfedge, later arc length along the loop
  GeneratorId after;  ///< the cell ahead of it, along the halfedge
};

/// One loop of boundary halfedges, with the arc length at which each begins.
struct BoundaryLoop {
  std::vector<HalfedgeId> halfedges;
  std::vector<double> start;
  double length = 0;
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
    std::vector<char> seen(static_cast<std::size_t>(mesh_.halfedge_count()), 0);
    for (std::int32_t i = 0; i < mesh_.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (!mesh_.twin(h).valid() && !seen[h.index()]) cut_loop(walk(h, seen));
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

  BoundaryLoop walk(HalfedgeId first, std::vector<char>& seen) const {
    BoundaryLoop loop;
    for (HalfedgeId h = first; !seen[h.index()];) {
      seen[h.index()] = 1;
      loop.halfedges.push_back(h);
      loop.start.push_back(loop.length);
      loop.length += mesh_.length(h);
      h = Mesh::next(h);
      while (mesh_.twin(h).valid()) h = Mesh::next(mesh_.twin(h));
    }
    return loop;
  }

  void cut_loop(const BoundaryLoop& loop) {
    std::vector<BoundaryEnd> ends;
    for (std::size_t i = 0; i < loop.halfedges.size(); ++i) {
      const auto here = ends_.find(loop.halfedges[i]);
      if (here == ends_.end()) continue;
      std::stable_sort(here->second.begin(), here->second.end(),
                       [](const auto& a, const auto& b) { return a.at < b.at; });
      for (const BoundaryEnd& end : here->second) {
        ends.push_back({loop.start[i] + end.at * mesh_.length(loop.halfedges[i]), end.after});
      }
    }
    if (ends.empty()) {
      const GeneratorId whole = diagram_.vertex_label[mesh_.from(loop.halfedges[0])];
      if (whole.valid()) runs_.push_back({whole, point_at(loop, 0)});
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const double stop = i + 1 < ends.size() ? ends[i + 1].at : ends[0].at + loop.length;
      runs_.push_back({ends[i].after, point_at(loop, std::fmod(0.5 * (ends[i].at + stop), loop.length))});
    }
  }

  SurfacePoint point_at(const BoundaryLoop& loop, double at) const {
    const auto next = std::upper_bound(loop.start.begin() + 1, loop.start.end(), at);
    const auto i = static_cast<std::size_t>(next - loop.start.begin()) - 1;
    const HalfedgeId h = loop.halfedges[i];
    const double t = std::clamp((at - loop.start[i]) / mesh_.length(h), 0.0, 1.0);
    const SurfacePoint p = edge_point(h, t);
    return make_surface_point(p.face, p.bary);
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

}  // namespace gvd

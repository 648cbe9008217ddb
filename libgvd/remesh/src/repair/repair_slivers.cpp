// Repairs slivers, which are triangles so thin that their normal is meaningless.
//
// A sliver is not a defect of the dual, and more generators do not always help: two generators that are close together
// have slivers around them whatever is added. So this comes last, on a mesh that is right, and keeps generators only if
// they leave fewer slivers. If generators beside all slivers fail, the thinnest half is tried next.

#include "repair/repair_slivers.hpp"

#include <algorithm>

#include "dual/dual_defects.hpp"
#include "gvd/quality.hpp"
#include "repair/propose_generators.hpp"

namespace gvd {
namespace {

/// The largest number of meshes that are tried.
constexpr int kTrials = 6;

double q_of(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return compute_q(mesh.position(a), mesh.position(b), mesh.position(c));
}

/// The thinnest slivers as defects, `most` of them.
std::vector<DualDefect> list_defects(const Mesh& mesh, const Diagram& diagram, const Mesh& remesh, std::size_t most) {
  const DualMesh dual = build_dual(mesh, diagram);
  std::vector<FaceId> slivers = find_slivers(remesh);
  std::stable_sort(slivers.begin(), slivers.end(),
                   [&](FaceId f, FaceId g) { return q_of(remesh, f) < q_of(remesh, g); });
  slivers.resize(std::min(most, slivers.size()));
  std::vector<DualDefect> defects;
  for (const FaceId f : slivers) defects.push_back(triangle_defect(diagram, dual, f.index(), "is a sliver"));
  return defects;
}

}  // namespace

std::vector<FaceId> find_slivers(const Mesh& remesh) {
  std::vector<FaceId> slivers;
  for (const FaceId f : remesh.faces()) {
    if (q_of(remesh, f) < kSliverQ) slivers.push_back(f);
  }
  return slivers;
}

void repair_slivers(const Mesh& mesh, const Diagram& diagram, const Mesh& remesh, std::size_t max_count,
                    const std::function<bool(const std::vector<SurfacePoint>&)>& accept) {
  const std::size_t given = diagram.generators.size();
  std::size_t most = find_slivers(remesh).size();
  for (int trial = 0; trial < kTrials && most > 0; ++trial) {
    const auto defects = list_defects(mesh, diagram, remesh, most);
    const auto points =
        propose_generators(mesh, diagram, defects, given + max_count - diagram.generators.size()).points;
    if (points.empty()) return;
    std::vector<SurfacePoint> generators = diagram.generators;
    generators.insert(generators.end(), points.begin(), points.end());
    most = accept(generators) ? find_slivers(remesh).size() : most / 2;
  }
}

}  // namespace gvd

// A round of a remesh: the triangles of a diagram's dual, the mesh that they make, and the defects in the way.
//
// The triangles of decimated components take the place of the dual there. Vertices are placed if nothing else is wrong.
// Triangles that intersect afterwards are defects, unless the surface intersects itself there.
#include "remesh_round.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "dual/dual_defects.hpp"
#include "dual/flipped_triangles.hpp"
#include "dual/inherited_intersections.hpp"
#include "dual/placed_faces.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/error.hpp"
#include "gvd/placement.hpp"
#include "mesh/submesh.hpp"
#include "move_guard.hpp"
#include "part_distance.hpp"
#include "repair/cell_topology.hpp"
#include "repair/fewer_generators.hpp"

namespace gvd {
namespace {

/// Up to this round, flipped triangles are looked for only if the dual has no other defect, because the repair of other
/// defects often removes them. Later rounds repair both kinds together, because a remesh that takes so long would
/// otherwise repair them in turns. Nine of ten remeshes end earlier.
constexpr std::int32_t kRoundsWithoutFlips = 12;

}  // namespace

RemeshRound RoundMaker::build(const Diagram& diagram, std::int32_t number) const {
  RemeshRound round;
  const Progress& progress = options_.diagram.progress;
  round.dual = build_dual(mesh_, diagram);
  report_progress(progress, "dual", 0.5);
  round.defects = check_dual(mesh_, diagram, round.dual);
  if (decimated_) leave_out_decimated(diagram, round);
  const bool is_sound = round.defects.empty();
  if (is_sound) round.defects = find_coincident_corners(diagram, round.dual);
  report_progress(progress, "dual", 1);
  if (round.defects.empty()) build_mesh(diagram, round);
  if (is_sound ? !round.defects.empty() : number <= kRoundsWithoutFlips) return round;
  for (const std::size_t i : find_flipped_triangles(mesh_, diagram, round.dual)) {
    round.defects.push_back(triangle_defect(diagram, round.dual, i, "is flipped"));
  }
  return round;
}

void RoundMaker::place(const Diagram& diagram, RemeshRound& round) {
  PlacementOptions options = options_.placement;
  options.threads = options_.diagram.threads;
  options.progress = options_.diagram.progress;
  options.fixed = find_in_order(fixed_, diagram.generators);
  if (decimated_) hold_folds_and_tips(diagram, round, options.fixed);
  if (options.method != Placement::generator && options.fixed.size() < diagram.generators.size()) {
    options.on_curves = list_on_curves(diagram);
    PlacedRemesh placed = place_freely(diagram, round, options);
    round.mesh = Mesh(std::move(placed.positions), apply_flips(round.mesh.face_vertices(), placed.flips));
    round.flips = std::move(placed.flips);
  }
  for (const FacePair& pair : find_intersections(diagram, round)) {
    for (const auto& [f, g] : {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      if (f.index() >= round.dual.faces.size()) {
        round.decimated_wrong.push_back(f);
        continue;
      }
      const auto& [a, b, c] = round.mesh.vertices(g);
      const std::string what = fmt::format("intersects that of {}, {} and {}", a.value(), b.value(), c.value());
      round.defects.push_back(
          triangle_defect(diagram, round.dual, f.index(), what, DualProperty::no_self_intersection));
    }
  }
}

std::vector<GeneratorId> RoundMaker::list_on_curves(const Diagram& diagram) const {
  IdVector<EdgeId, char> has_edge(mesh_.edge_count(), 0);
  IdVector<VertexId, char> has_vertex(mesh_.vertex_count(), 0);
  for (const CreaseCurve& curve : options_.creases) {
    for (const EdgeId e : curve.edges) has_edge[e] = 1;
    for (const VertexId v : curve.vertices) has_vertex[v] = 1;
  }
  std::vector<GeneratorId> on_curves;
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const SurfacePoint& point = diagram.generators[i];
    const bool is_on = point.kind() == SurfacePoint::Kind::vertex ? has_vertex[vertex(mesh_, point)] != 0
                       : point.kind() == SurfacePoint::Kind::edge ? has_edge[mesh_.edge(halfedge(point))] != 0
                                                                  : false;
    if (is_on) on_curves.emplace_back(i);
  }
  return on_curves;
}

std::vector<DualDefect> RoundMaker::find_coincident_corners(const Diagram& diagram, const DualMesh& dual) const {
  const auto at = [&](GeneratorId g) { return position(mesh_, diagram.generators[g.index()]); };
  std::vector<DualDefect> defects;
  for (std::size_t i = 0; i < dual.faces.size(); ++i) {
    const auto& [a, b, c] = dual.faces[i];
    if (at(a) != at(b) && at(b) != at(c) && at(c) != at(a)) continue;
    defects.push_back(triangle_defect(diagram, dual, i, "has an edge of length 0"));
  }
  return defects;
}

void RoundMaker::leave_out_decimated(const Diagram& diagram, RemeshRound& round) const {
  const auto is_decimated = [&](GeneratorId g) { return decimated_->has(diagram.generators[g.index()]); };
  std::erase_if(round.defects, [&](const DualDefect& d) { return !d.cells.empty() && is_decimated(d.cells.front()); });
  DualMesh left;
  for (std::size_t i = 0; i < round.dual.faces.size(); ++i) {
    if (is_decimated(round.dual.faces[i].front())) continue;
    left.faces.push_back(round.dual.faces[i]);
    left.branch_points.push_back(round.dual.branch_points[i]);
  }
  round.dual = std::move(left);
}

void RoundMaker::hold_folds_and_tips(const Diagram& diagram, const RemeshRound& round,
                                     std::vector<GeneratorId>& fixed) const {
  const Mesh& mesh = round.mesh;
  std::vector<FaceId> folded;
  const auto normals = normals_at_faces(mesh_, mesh, diagram.generators, round.face_points);
  for (const FaceId f : mesh.faces()) {
    if (is_flipped(PlacedFaces(mesh).corners(f), normals[f.index()])) folded.push_back(f);
  }
  for (const FacePair& pair : find_self_intersections(mesh, options_.diagram.threads, options_.diagram.progress)) {
    folded.insert(folded.end(), {pair.first, pair.second});
  }
  for (const FaceId f : folded) {
    if (f.index() < round.dual.faces.size()) continue;
    for (const VertexId v : mesh.vertices(f)) fixed.emplace_back(v.value());
  }
  for (std::size_t g = 0; g < diagram.generators.size(); ++g) {
    if (!decimated_->has(diagram.generators[g])) continue;
    const VertexId v = vertex(mesh_, diagram.generators[g]);
    if (!mesh_.is_boundary(v) && total_angle(mesh_, v) < kTipAngle) fixed.emplace_back(g);
  }
}

PlacedRemesh RoundMaker::place_freely(const Diagram& diagram, const RemeshRound& round,
                                      PlacementOptions options) const {
  PlacedRemesh placed = place_vertices(mesh_, diagram, round.mesh, round.face_points, options);
  if (!decimated_) return placed;
  const std::vector<GeneratorId> farther = list_farther(diagram, round, placed);
  if (farther.empty()) return placed;
  options.fixed.insert(options.fixed.end(), farther.begin(), farther.end());
  return place_vertices(mesh_, diagram, round.mesh, round.face_points, options);
}

std::vector<GeneratorId> RoundMaker::list_farther(const Diagram& diagram, const RemeshRound& round,
                                                  const PlacedRemesh& placed) const {
  const auto& component = decimated_->component();
  const auto component_of = [&](VertexId v) { return component[diagram.generators[v.index()].face]; };
  const Mesh after(placed.positions, apply_flips(round.mesh.face_vertices(), placed.flips));
  std::map<std::int32_t, std::vector<FaceId>> of_surface, of_remesh;
  for (const FaceId f : mesh_.faces()) {
    if (decimated_->has(component[f])) of_surface[component[f]].push_back(f);
  }
  for (const FaceId f : round.mesh.faces()) {
    if (f.index() >= round.dual.faces.size()) of_remesh[component_of(round.mesh.vertices(f)[0])].push_back(f);
  }
  std::vector<GeneratorId> farther;
  for (const auto& [c, faces] : of_remesh) {
    const Mesh part = make_submesh(mesh_, of_surface[c]).mesh;
    const PartDistance now = measure_part_distance(part, make_submesh(after, faces).mesh);
    if (now.is_within(measure_part_distance(part, make_submesh(round.mesh, faces).mesh))) continue;
    for (const FaceId f : faces) {
      for (const VertexId v : round.mesh.vertices(f)) farther.emplace_back(v.value());
    }
  }
  return farther;
}

void RoundMaker::append_decimated(const Diagram& diagram, std::vector<std::array<VertexId, 3>>& faces,
                                  std::vector<SurfacePoint>& face_points) const {
  IdVector<VertexId, VertexId> of_surface(mesh_.vertex_count());
  for (std::size_t g = 0; g < diagram.generators.size(); ++g) {
    const SurfacePoint& point = diagram.generators[g];
    if (decimated_->has(point)) of_surface[vertex(mesh_, point)] = VertexId(g);
  }
  for (const DecimatedFace& face : decimated_->faces()) {
    const auto& [a, b, c] = face.corners;
    faces.push_back({of_surface[a], of_surface[b], of_surface[c]});
    face_points.push_back(face.point());
  }
}

void RoundMaker::build_mesh(const Diagram& diagram, RemeshRound& round) const {
  std::vector<Vec3> positions;
  for (const SurfacePoint& p : diagram.generators) positions.push_back(position(mesh_, p));
  std::vector<std::array<VertexId, 3>> faces;
  for (const auto& [a, b, c] : round.dual.faces) {
    faces.push_back({VertexId(a.value()), VertexId(b.value()), VertexId(c.value())});
  }
  for (const BranchPointId b : round.dual.branch_points) round.face_points.push_back(diagram.branch_points[b].point);
  if (decimated_) append_decimated(diagram, faces, round.face_points);
  auto built = Mesh::try_to_build(std::move(positions), std::move(faces));
  if (const Error* const error = std::get_if<Error>(&built)) {
    round.obstacle = std::string("the dual of the generators is not a manifold mesh: ") + error->what() +
                     "; move or remove generators";
  } else {
    round.mesh = std::get<Mesh>(std::move(built));
  }
}

std::vector<FacePair> RoundMaker::find_intersections(const Diagram& diagram, const RemeshRound& round) {
  if (options_.allow_intersections) return {};
  const std::vector<FacePair> pairs =
      find_self_intersections(round.mesh, options_.diagram.threads, options_.diagram.progress);
  if (pairs.empty()) return {};
  if (!of_input_) of_input_ = find_self_intersections(mesh_, options_.diagram.threads, options_.diagram.progress);
  const auto decimated_faces = std::int64_t{round.mesh.face_count()} - std::ssize(round.dual.faces);
  const auto inherited = find_inherited_pairs({mesh_, diagram, round.mesh, round.face_points, decimated_faces}, pairs,
                                              *of_input_, options_.diagram.progress);
  std::vector<FacePair> own;
  std::set_difference(pairs.begin(), pairs.end(), inherited.begin(), inherited.end(), std::back_inserter(own));
  return own;
}

}  // namespace gvd

// Windows after a change of some generators. Only the generators around the change are propagated again.
//
// Idea: a window matters only in the cell of its generator and where it competes at that cell's border. So only the
// changed generators, and generators whose windows meet theirs, take part in a new propagation, inside their cells; all
// other generators stay away. Near the cells of generators that stayed away, the result is wrong; near the changed
// generators, it is that of a whole propagation. To tell the two apart, the digests of all windows at each halfedge are
// compared with the digests before the change. They differ around the change, and they differ around generators that
// stayed away. If a strip of faces without a difference separates these two areas, neither has had an effect on the
// other: what happens in a face depends on the windows that come to its sides and on the distances of its corners, and
// these are the same in the strip. Otherwise more generators take part.
// Source: none; windows as in propagate_windows.cpp. The queue keeps the order of any two windows whatever else it
// holds, so that the same windows meet in the same order.
// Invariant: field and record have the bits of a whole propagation, unless shortest paths tie (see the end).
//
// Why a strip is enough. Consider the propagation P of all generators, and the propagation Q of the generators that
// take part. In both, a face gets its windows from its neighbours and from its corners. Let all halfedges of the strip
// have the same digests in Q and before the change. Then the same windows enter the side of the change through the
// strip as before. No window of a generator that stayed away is among them: if such a window is in a face, its
// generator is in the face's list of windows or is the label of a corner, so that the face counts as beside generators
// that stayed away. By induction over the buckets, P does on the side of the change what Q does, and on the other side
// what was done before.
// The digests have the bucket of each window, but not its place among windows of other halfedges in the bucket. Windows
// of one bucket are carried in the order in which they were queued. This is the order of the windows that they descend
// from, back to the order of the generators. So two windows that exist in both P and Q have the same order in both.
// There are exceptions: windows of other generators may have queued a halfedge before, and a split face changes the
// order round its corners. The exceptions matter only if two windows tie to the last bit, as on meshes with symmetries,
// because then the first one wins.
#include "geodesic/windows/propagation/changed_windows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geodesic/windows/propagation/propagation.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using GeneratorFlags = IdVector<GeneratorId, std::uint8_t>;

/// Number of rings of faces around those that windows of changed generators have touched. Generators with windows in
/// these rings take part. More rings propagate more, fewer have to be widened more often.
constexpr int kMarginRings = 3;

/// Number of rings beyond the first meeting with a generator that stayed away in which further generators are looked
/// for.
constexpr int kMeetingRings = 2;

/// Number of attempts, with more and more generators, before all take part.
constexpr int kMaxLocalAttempts = 3;

/// If more than this share of the generators would take part, all do.
constexpr double kMostGenerators = 0.6;

/// Calls visit(FaceId) for the faces at the corners of f, some of them more than once.
template <class Visit>
void for_each_face_around(const Mesh& mesh, FaceId f, Visit visit) {
  for (const VertexId v : mesh.vertices(f)) for_each_outgoing(mesh, v, [&](HalfedgeId h) { visit(Mesh::face(h)); });
}

void add_faces_of(const Mesh& mesh, VertexId v, FaceSet& set) {
  for_each_outgoing(mesh, v, [&](HalfedgeId h) { set.add(Mesh::face(h)); });
}

/// Adds the faces for which wanted(FaceId) holds and that are connected to the set through such faces. Faces with a
/// common corner are neighbours.
template <class Wanted>
void grow(const Mesh& mesh, FaceSet& set, Wanted wanted) {
  for (std::size_t i = 0; i < set.faces.size(); ++i) {
    for_each_face_around(mesh, set.faces[i], [&](FaceId f) {
      if (set.contains[f] == 0 && wanted(f)) set.add(f);
    });
  }
}

/// Calls visit(GeneratorId) for the label of each corner of a face, and for each window on its halfedges.
template <class Visit>
void for_each_generator(const Mesh& mesh, const WindowField& field, FaceId f, Visit visit) {
  for (const VertexId v : mesh.vertices(f)) {
    if (field.label[v].valid()) visit(field.label[v]);
  }
  field.windows.for_each(f, [&](const Window& w) { visit(w.generator); });
}

/// The windows before a change, and the change. Old faces are faces of the mesh before the change. Generators that do
/// not change have the same number before and after.
struct BeforeChange {
  const Mesh &old_mesh, &mesh;
  const CommonElements& common;
  const WindowField& field;
  const WindowRecord& record;
  GeneratorFlags is_removed, is_added;  ///< changed generators, by their numbers before and after

  BeforeChange(const GeneratorChange& change, const WindowField& old_field, const WindowRecord& old_record)
      : old_mesh(change.before.mesh()),
        mesh(change.after.mesh()),
        common(change.common),
        field(old_field),
        record(old_record),
        is_removed(change.before.generator_vertices().size(), 0),
        is_added(change.after.generator_vertices().size(), 0) {
    for (const GeneratorId g : change.changed.before) is_removed[g] = 1;
    for (const GeneratorId g : change.changed.after) is_added[g] = 1;
  }

  bool has_removed(FaceId old_face) const {
    bool found = false;
    for_each_generator(old_mesh, field, old_face, [&](GeneratorId g) { found = found || is_removed[g] != 0; });
    return found;
  }
  /// Selects all generators that had windows in an old face and are not removed. Does nothing if the face is invalid.
  void select_in(FaceId old_face, GeneratorFlags& selected) const {
    if (!old_face.valid()) return;
    for_each_generator(old_mesh, field, old_face, [&](GeneratorId g) {
      if (is_removed[g] == 0) selected[g] = 1;
    });
  }
  /// The label of a vertex before the change; invalid if that generator is removed.
  GeneratorId label(VertexId v) const {
    const VertexId old = common.vertex_before[v];
    const GeneratorId g = old.valid() ? field.label[old] : GeneratorId();
    return g.valid() && is_removed[g] == 0 ? g : GeneratorId();
  }
  /// The distance from that generator; infinity if there is none.
  double distance(VertexId v) const { return label(v).valid() ? field.distance[common.vertex_before[v]] : kInfinity; }
};

/// Propagates the selected generators of a working mesh. Their windows enter only the open faces.
RecordedWindows propagate_recorded(const WorkingMesh& working, const GeneratorFlags& selected, const FaceSet& open,
                                   const PropagationSite& site) {
  RecordedWindows result;
  result.records.resize(working.mesh().halfedge_count());
  Propagation<WindowRecorder> propagation(site.state, site.parallel, kInfinity, site.progress,
                                          WindowRecorder(open.contains, result.records));
  for (const GeneratorId g : selected.ids()) {
    if (selected[g] != 0) propagation.start(working.vertex(g), g, 0);
  }
  result.field = propagation.run();
  return result;
}

/// Computes the distances when only the added generators are propagated. All other cells only shrink, so that the
/// distances before the change bound the propagation.
WindowField probe_added(const BeforeChange& before, const WorkingMesh& after, const PropagationSite& site) {
  PropagationState& state = site.state;
  for (std::size_t i = 0; i < state.labels.distance.size(); ++i) {
    const VertexCopyId copy(i);
    const VertexId v = state.partitions.vertex(copy);
    state.labels.distance[copy] = before.distance(v);
    if (std::isfinite(before.distance(v))) state.labels.label[copy] = before.label(v);
  }
  std::vector<std::pair<VertexId, GeneratorId>> added;
  for (const GeneratorId g : before.is_added.ids()) {
    if (before.is_added[g] != 0) added.emplace_back(after.vertex(g), g);
  }
  state.keep = KeepWindows::none;
  WindowField probe = propagate_on(state, added, site.parallel, site.progress);
  state.keep = KeepWindows::near_bisectors;
  state.restart();
  return probe;
}

/// The faces that the change touches: new faces, faces in which removed generators had windows, and faces with a corner
/// to which an added generator is nearer than all generators that stay.
FaceSet find_touched(const BeforeChange& before, const GeneratorChange& change, const PropagationSite& site) {
  FaceSet touched(before.mesh.face_count());
  for (const FaceId f : before.common.only_after) touched.add(f);
  FaceSet old(before.old_mesh.face_count());
  for (const GeneratorId g : change.changed.before) add_faces_of(before.old_mesh, change.before.vertex(g), old);
  grow(before.old_mesh, old, [&](FaceId f) { return before.has_removed(f); });
  for (const FaceId f : old.faces) {
    if (before.common.after[f].valid()) touched.add(before.common.after[f]);
  }
  if (change.changed.after.empty()) return touched;
  const WindowField probe = probe_added(before, change.after, site);
  FaceSet reached(before.mesh.face_count());
  for (const GeneratorId g : change.changed.after) add_faces_of(before.mesh, change.after.vertex(g), reached);
  grow(before.mesh, reached, [&](FaceId f) {
    return std::ranges::any_of(before.mesh.vertices(f),
                               [&](VertexId v) { return probe.distance[v] != before.distance(v); });
  });
  for (const FaceId f : reached.faces) touched.add(f);
  return touched;
}

/// The added generators, and those that had windows within kMarginRings rings of the faces that the change touches.
GeneratorFlags select_near(const BeforeChange& before, const FaceSet& touched) {
  GeneratorFlags selected = before.is_added;
  FaceSet near = touched;
  std::size_t begin = 0;
  for (int ring = 0; ring < kMarginRings; ++ring) {
    for (const std::size_t end = near.faces.size(); begin < end; ++begin) {
      for_each_face_around(before.mesh, near.faces[begin], [&](FaceId f) { near.add(f); });
    }
  }
  for (const FaceId f : near.faces) before.select_in(before.common.before[f], selected);
  for (const FaceId old : before.common.only_before) before.select_in(old, selected);
  return selected;
}

/// The faces that windows may enter: faces in the cells of the selected generators, and faces that the change touches.
FaceSet find_open(const BeforeChange& before, const WorkingMesh& after, const GeneratorFlags& selected,
                  const FaceSet& touched) {
  FaceSet open = touched;
  for (const GeneratorId g : selected.ids()) {
    if (selected[g] != 0 && before.is_added[g] == 0) add_faces_of(before.mesh, after.vertex(g), open);
  }
  grow(before.mesh, open, [&](FaceId f) {
    return std::ranges::any_of(before.mesh.vertices(f), [&](VertexId v) {
      const GeneratorId g = before.label(v);
      return g.valid() && selected[g] != 0;
    });
  });
  return open;
}

/// The faces among `faces` that differ from before the change, after a propagation that opened them.
FaceSet find_different(const BeforeChange& before, const std::vector<FaceId>& faces, const RecordedWindows& now,
                       const PropagationState& state) {
  const Mesh& mesh = before.mesh;
  const CommonElements& common = before.common;
  // True for new faces, and for faces that have several labels now and had one before, or the other way round.
  const auto has_other_state = [&](FaceId f) {
    const FaceId old = common.before[f];
    return !old.valid() || has_several_labels(state, now.field, f) != (before.record.multi_label[old] != 0);
  };
  // The states of a face's neighbours count, too, because they determine which windows are kept.
  const auto is_different = [&](FaceId f) {
    if (has_other_state(f)) return true;
    for (int i = 0; i < 3; ++i) {
      const HalfedgeId h = Mesh::halfedge(f, i), twin = mesh.twin(h);
      if (now.records[h] != before.record.halfedge[Mesh::halfedge(common.before[f], i)]) return true;
      if (twin.valid() && has_other_state(Mesh::face(twin))) return true;
      const VertexId v = mesh.from(h), old = common.vertex_before[v];
      if (!old.valid() || now.field.label[v] != before.field.label[old]) return true;
      if (now.field.distance[v] != before.field.distance[old]) return true;
    }
    return false;
  };
  FaceSet different(mesh.face_count());
  for (const FaceId f : faces) {
    if (is_different(f)) different.add(f);
  }
  return different;
}

/// A propagation of some generators, and what it makes different.
struct Repropagation {
  GeneratorFlags selected;
  FaceSet open;
  RecordedWindows now;
  FaceSet different;  // some of the open faces
};

Repropagation repropagate(const GeneratorFlags& selected, FaceSet open, const BeforeChange& before,
                          const WorkingMesh& after, const PropagationSite& site) {
  RecordedWindows now = propagate_recorded(after, selected, open, site);
  FaceSet different = find_different(before, open.faces, now, site.state);
  return {selected, std::move(open), std::move(now), std::move(different)};
}

/// Whether generators that stayed away had windows in an open face, or a face at its corners is not open.
bool is_beside_others(const BeforeChange& before, const Repropagation& run, FaceId f) {
  bool found = false;
  if (const FaceId old = before.common.before[f]; old.valid()) {
    for_each_generator(before.old_mesh, before.field, old,
                       [&](GeneratorId g) { found = found || (before.is_removed[g] == 0 && run.selected[g] == 0); });
  }
  for_each_face_around(before.mesh, f, [&](FaceId other) { found = found || run.open.contains[other] == 0; });
  return found;
}

/// Adds to `changed` all different faces that are connected to it. Returns whether none of them lies beside generators
/// that stayed away. Otherwise, selects the generators there for the next attempt.
bool grow_apart(const BeforeChange& before, const Repropagation& run, FaceSet& changed, GeneratorFlags& selected) {
  int rings_left = kMeetingRings;
  bool are_apart = true;
  for (std::size_t begin = 0; begin < changed.faces.size() && rings_left > 0;) {
    for (const std::size_t end = changed.faces.size(); begin < end; ++begin) {
      const FaceId f = changed.faces[begin];
      are_apart = are_apart && !is_beside_others(before, run, f);
      for_each_face_around(before.mesh, f, [&](FaceId other) {
        if (!are_apart) before.select_in(before.common.before[other], selected);
        if (run.different.contains[other] != 0) changed.add(other);
      });
    }
    if (!are_apart) --rings_left;
  }
  return are_apart;
}

/// The faces that the change makes different, if they are separate from faces that differ because generators stayed
/// away. Otherwise, selects more generators for the next attempt and returns nothing.
std::optional<FaceSet> separate_changed(const BeforeChange& before, const Repropagation& run,
                                        GeneratorFlags& selected) {
  const FaceSet& different = run.different;
  FaceSet changed(before.mesh.face_count());
  for (const FaceId f : different.faces) {
    const FaceId old = before.common.before[f];
    bool is_of_change = !old.valid() || before.has_removed(old);
    for_each_generator(before.mesh, run.now.field, f,
                       [&](GeneratorId g) { is_of_change = is_of_change || before.is_added[g] != 0; });
    if (is_of_change) changed.add(f);
  }
  if (!grow_apart(before, run, changed, selected)) return std::nullopt;
  FaceSet explained = changed;
  for (const FaceId f : different.faces) {
    if (explained.contains[f] == 0 && is_beside_others(before, run, f)) explained.add(f);
  }
  grow(before.mesh, explained, [&](FaceId f) { return different.contains[f] != 0; });
  if (explained.faces.size() == different.faces.size()) return changed;
  // The change has had an effect far away that no window explains, so that all generators have to take part.
  selected.assign(selected.size(), 1);
  return std::nullopt;
}

}  // namespace

FaceSet make_full_set(const Mesh& mesh) {
  FaceSet all(mesh.face_count());
  for (const FaceId f : mesh.faces()) all.add(f);
  return all;
}

RecordedWindows propagate_all(const WorkingMesh& working, const PropagationSite& site) {
  return propagate_recorded(working, GeneratorFlags(working.generator_vertices().size(), 1),
                            make_full_set(working.mesh()), site);
}

bool has_several_labels(const PropagationState& state, const WindowField& field, FaceId f) {
  if (state.face_state[f] != FaceState::open) return state.face_state[f] == FaceState::multi_label;
  const auto& [a, b, c] = state.mesh->vertices(f);
  return field.label[a] != field.label[b] || field.label[b] != field.label[c];
}

ChangedWindows find_changed_windows(const GeneratorChange& change, const WindowField& field, const WindowRecord& record,
                                    const PropagationSite& site) {
  const BeforeChange before(change, field, record);
  const FaceSet touched = find_touched(before, change, site);
  GeneratorFlags selected = select_near(before, touched);
  for (int i = 0; i < kMaxLocalAttempts; ++i) {
    const auto count = static_cast<std::int32_t>(std::ranges::count(selected.raw(), 1));
    if (count > kMostGenerators * static_cast<double>(selected.size())) break;
    FaceSet open = find_open(before, change.after, selected, touched);
    Repropagation run = repropagate(selected, std::move(open), before, change.after, site);
    if (auto changed = separate_changed(before, run, selected)) {
      return {std::move(*changed), std::move(run.now), count};
    }
    site.state.restart();
  }
  // As a last resort, all generators take part. Then every difference is an effect of the change.
  selected.assign(selected.size(), 1);
  Repropagation whole = repropagate(selected, make_full_set(before.mesh), before, change.after, site);
  return {std::move(whole.different), std::move(whole.now), selected.count()};
}

}  // namespace gvd

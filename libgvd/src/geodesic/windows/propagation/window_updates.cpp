// Windows after a change of some generators: only those around them are propagated again.
//
// Idea: a window matters only in the cell of its generator and where it competes at that cell's border. So the changed
// generators and those whose windows meet theirs are propagated from the beginning, in their cells; all others stay
// away. Near the cells of generators that stayed away, the result is wrong; near the changed generators, it is that of
// a whole propagation. To tell the one from the other, the digests of all windows at each halfedge are compared with
// those before the change. They differ around the change, and they differ around what stayed away. If a strip of faces
// without a difference separates the two, neither has had an effect on the other: what happens in a face depends on the
// windows that come to its sides and on the distances of its corners, and these are the same in the strip. Otherwise
// more generators take part.
// Source: none; windows as in propagate_windows.cpp. The queue keeps the order of any two windows whatever else it
// holds, so that the same windows meet in the same order.
// Invariant: field and record have the bits of a whole propagation, unless shortest paths tie (see the end).
//
// Why a strip is enough. Consider the propagation of all generators, P, and that of those that take part, Q. In both,
// a face gets its windows from its neighbours and from its corners. Let all halfedges of the strip have the same
// digests in Q and before the change. Then the same windows enter the side of the change through the strip as before.
// No window of a generator that stayed away is among them. Such a window in a face has its
// generator in the face's list of windows, or its label at a corner, so the face belongs to the others. By induction
// over the buckets, P does on the side of the change what Q does, and on the other side what was done before.
// The digests have the bucket of each window, but not its place among windows of other halfedges in the bucket. Windows
// of one bucket are carried in the order in which they were queued. This is the order of the windows that they descend
// from, back to the order of the generators. So two windows that exist in P and in Q have the same order there.
// This has exceptions: windows of others may have queued a halfedge before, and a split face turns the order round its
// corners. They have an effect where two windows tie to the last bit, as on meshes with symmetries: the first one wins.
#include "geodesic/windows/propagation/window_updates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "geodesic/windows/propagation/propagation.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using GeneratorFlags = IdVector<GeneratorId, std::uint8_t>;

/// Rings of faces around those that windows of changed generators have touched. Generators with windows there take
/// part. Wider rings propagate more, narrower ones have to be widened more often.
constexpr int kMarginRings = 3;

/// Rings beyond the first meeting with a generator that stayed away, in which others are looked for, too.
constexpr int kMeetingRings = 2;

/// Attempts with more and more generators before all take part.
constexpr int kMaxLocalAttempts = 3;

/// Share of the generators from which on all take part.
constexpr double kMostGenerators = 0.6;

/// The options of the windows of a diagram, so that all of them are carried as `compute_diagram` carries them.
PropagationOptions recorded_options(int threads) {
  PropagationOptions options;
  options.keep = KeepWindows::near_bisectors;
  options.threads = threads;
  return options;
}

ElementCounts counts(const Mesh& mesh) { return {mesh.vertex_count(), mesh.face_count()}; }

/// The mode of a propagation with these frames.
PropagationMode mode_of(const FaceFrames& frames) {
  const double sine = std::max(frames.least_sine, std::numeric_limits<double>::min());
  return {frames.has_needles, frames.has_thin_faces, frames.has_thin_faces ? std::ilogb(sine) : 0};
}

/// Whether a face has, or at some time had, several labels. After a propagation with the result `field`.
bool has_several_labels(const PropagationState& state, const WindowField& field, FaceId f) {
  if (state.face_state[f] != FaceState::open) return state.face_state[f] == FaceState::multi_label;
  const auto& [a, b, c] = state.mesh->vertices(f);
  return field.label[a] != field.label[b] || field.label[b] != field.label[c];
}

/// Whether test(GeneratorId) holds for the label of a corner of a face, or for a window on one of its halfedges.
template <class Test>
bool any_generator(const Mesh& mesh, const WindowField& field, FaceId f, Test test) {
  bool found = false;
  for (const VertexId v : mesh.vertices(f)) found = found || (field.label[v].valid() && test(field.label[v]));
  if (!found) field.windows.for_each(f, [&](const Window& w) { found = found || test(w.generator); });
  return found;
}

/// Calls visit(FaceId) for the faces at the corners of f, some of them more than once.
template <class Visit>
void for_each_face_around(const Mesh& mesh, FaceId f, Visit visit) {
  for (const VertexId v : mesh.vertices(f)) for_each_outgoing(mesh, v, [&](HalfedgeId h) { visit(Mesh::face(h)); });
}

}  // namespace

/// A set of faces: flags for look-ups, and a list, so that nothing visits all faces.
struct FaceSet {
  IdVector<FaceId, std::uint8_t> contains;
  std::vector<FaceId> faces{};  ///< in the order of insertion

  explicit FaceSet(std::size_t count) : contains(count, 0) {}
  bool add(FaceId f) {
    if (std::exchange(contains[f], 1) != 0) return false;
    faces.push_back(f);
    return true;
  }
  /// Adds the faces for which wanted(FaceId) holds and that are connected to those in the set, from number `begin` on,
  /// through such faces. Faces with a common corner are connected.
  template <class Wanted>
  void grow(const Mesh& mesh, std::size_t begin, Wanted wanted) {
    for (std::size_t i = begin; i < faces.size(); ++i) {
      for_each_face_around(mesh, faces[i], [&](FaceId f) {
        if (contains[f] == 0 && wanted(f)) add(f);
      });
    }
  }
};

namespace {

/// Where and how to propagate.
struct PropagationSite {
  PropagationState& state;
  const ParallelChunks& parallel;
  const Progress& progress;
};

/// Propagates some generators of a working mesh.
template <class Recorder>
WindowField propagate(const WorkingMesh& working, const GeneratorFlags& selected, const Recorder& recorder,
                      const PropagationSite& site) {
  Propagation<Recorder> propagation(site.state, site.parallel, kInfinity, site.progress, recorder);
  for (const GeneratorId g : working.generator_vertices().ids()) {
    if (selected[g] != 0) propagation.start(working.vertex(g), g, 0);
  }
  return propagation.run();
}

}  // namespace

/// One update, from the touched faces to the merged windows.
/// Long because the steps share its sets of faces, and each is a few lines.
class WindowUpdate {
 public:
  WindowUpdate(EditableWindows& windows, const GeneratorChange& change, const Progress& progress)
      : field_(windows.field_),
        record_(windows.record_),
        old_mesh_(change.before.mesh()),
        before_(change.before),
        after_(change.after),
        mesh_(change.after.mesh()),
        common_(change.common),
        changed_(change.changed),
        progress_(progress),
        parallel_(windows.threads_, silent_),
        state_(*windows.state_),
        selected_(after_.generator_vertices().size(), 0),
        is_added_(selected_.size(), 0),
        is_removed_(before_.generator_vertices().size(), 0),
        touched_(mesh_.face_count()),
        open_(0),
        differs_(mesh_.face_count(), 0) {
    for (const GeneratorId g : changed_.before) is_removed_[g] = 1;
    for (const GeneratorId g : changed_.after) is_added_[g] = 1;
  }

  WindowChange run() {
    const PropagationMode mode = mode_of(state_.frames);
    if (mode != record_.mode) {
      propagate_all();
      record_.mode = mode;
      return take(all_faces());
    }
    find_touched();
    select_generators();
    for (int attempt = 0; attempt < kMaxLocalAttempts && is_local(); ++attempt) {
      open_faces();
      propagate_selected();
      const FaceSet changed = find_changes();
      if (is_apart_) return take(changed);
    }
    propagate_all();
    FaceSet changed(mesh_.face_count());
    for (const FaceId f : mesh_.faces()) {
      if (is_different(f)) changed.add(f);
    }
    return take(std::move(changed));
  }

 private:
  /// Whether few enough generators take part that the others save time.
  bool is_local() const {
    const auto count = std::ranges::count(selected_.raw(), 1);
    return static_cast<double>(count) <= kMostGenerators * static_cast<double>(selected_.size());
  }
  bool is_removed(GeneratorId g) const { return is_removed_[g] != 0; }
  bool stayed_away(GeneratorId g) const { return !is_removed(g) && selected_[g] == 0; }

  FaceSet all_faces() const {
    FaceSet all(mesh_.face_count());
    for (const FaceId f : mesh_.faces()) all.add(f);
    return all;
  }

  /// The last resort. What differs then is what the change makes different.
  void propagate_all() {
    selected_.assign(selected_.size(), 1);
    open_ = all_faces();
    propagate_selected();
  }

  void propagate_selected() {
    state_.restart();
    records_.assign(mesh_.halfedge_count(), HalfedgeRecord());
    now_ = propagate(after_, selected_, WindowRecorder(open_.contains, records_), {state_, parallel_, progress_});
  }

  /// The faces with windows of changed generators: before the change by their windows and labels, after it by a
  /// propagation of the changed generators alone, that the distances before the change bound.
  void find_touched() {
    for (const FaceId f : common_.only_after) touched_.add(f);
    FaceSet old(old_mesh_.face_count());
    for (const GeneratorId g : changed_.before) {
      for_each_outgoing(old_mesh_, before_.vertex(g), [&](HalfedgeId h) { old.add(Mesh::face(h)); });
    }
    old.grow(old_mesh_, 0, [&](FaceId f) {
      return any_generator(old_mesh_, field_, f, [&](GeneratorId g) { return is_removed(g); });
    });
    for (const FaceId f : old.faces) {
      if (common_.after[f].valid()) touched_.add(common_.after[f]);
    }
    if (changed_.after.empty()) return;
    const WindowField probe = probe_added();
    FaceSet reached(mesh_.face_count());
    for (const GeneratorId g : changed_.after) {
      for_each_outgoing(mesh_, after_.vertex(g), [&](HalfedgeId h) { reached.add(Mesh::face(h)); });
    }
    reached.grow(mesh_, 0, [&](FaceId f) {
      return std::ranges::any_of(mesh_.vertices(f), [&](VertexId v) { return probe.distance[v] != bound(v); });
    });
    for (const FaceId f : reached.faces) touched_.add(f);
  }

  /// The distance of a vertex before the change, if that of a generator that stays.
  double bound(VertexId v) const {
    const VertexId old = common_.vertex_before[v];
    return old.valid() && field_.label[old].valid() && !is_removed(field_.label[old]) ? field_.distance[old]
                                                                                      : kInfinity;
  }

  /// The distances after the changed generators were added to the others, whose cells only shrink.
  WindowField probe_added() {
    for (std::size_t i = 0; i < state_.labels.distance.size(); ++i) {
      const VertexCopyId copy(i);
      const VertexId v = state_.partitions.vertex(copy);
      state_.labels.distance[copy] = bound(v);
      if (std::isfinite(bound(v))) state_.labels.label[copy] = field_.label[common_.vertex_before[v]];
    }
    state_.keep = KeepWindows::none;
    WindowField probe = propagate(after_, is_added_, NoRecorder(), {state_, parallel_, progress_});
    state_.keep = KeepWindows::near_bisectors;
    return probe;
  }

  /// Lets the generators take part that had windows within some rings of the faces that the change touches.
  void select_generators() {
    for (const GeneratorId g : changed_.after) selected_[g] = 1;
    FaceSet near = touched_;
    std::size_t begin = 0;
    for (int ring = 0; ring < kMarginRings; ++ring) {
      const std::size_t end = near.faces.size();
      for (; begin < end; ++begin) for_each_face_around(mesh_, near.faces[begin], [&](FaceId f) { near.add(f); });
    }
    for (const FaceId f : near.faces) select_in(f);
    for (const FaceId old : common_.only_before) select_in_old(old);
  }

  /// Lets all generators with windows in a face before the change take part.
  void select_in(FaceId f) {
    if (common_.before[f].valid()) select_in_old(common_.before[f]);
  }
  void select_in_old(FaceId old) {
    any_generator(old_mesh_, field_, old, [&](GeneratorId g) {
      if (!is_removed(g)) selected_[g] = 1;
      return false;
    });
  }

  /// Opens the faces in the cells of the generators that take part, and those that the change touches.
  void open_faces() {
    open_ = touched_;
    for (const GeneratorId g : after_.generator_vertices().ids()) {
      if (selected_[g] == 0 || is_added_[g] != 0) continue;
      for_each_outgoing(mesh_, after_.vertex(g), [&](HalfedgeId h) { open_.add(Mesh::face(h)); });
    }
    open_.grow(mesh_, 0, [&](FaceId f) {
      return std::ranges::any_of(mesh_.vertices(f), [&](VertexId v) {
        const VertexId old = common_.vertex_before[v];
        const GeneratorId g = old.valid() ? field_.label[old] : GeneratorId();
        return g.valid() && !is_removed(g) && selected_[g] != 0;
      });
    });
  }

  /// Whether the windows or corners of a face differ from those before the change, or its neighbours' states: on these
  /// depends which windows are kept.
  bool is_different(FaceId f) const {
    const FaceId old = common_.before[f];
    if (has_other_state(f)) return true;  // also where there is no old face
    for (int i = 0; i < 3; ++i) {
      const HalfedgeId h = Mesh::halfedge(f, i), twin = mesh_.twin(h);
      if (records_[h] != record_.halfedge[Mesh::halfedge(old, i)]) return true;
      if (twin.valid() && has_other_state(Mesh::face(twin))) return true;
      const VertexId v = mesh_.from(h), u = common_.vertex_before[v];
      if (!u.valid() || now_.label[v] != field_.label[u] || now_.distance[v] != field_.distance[u]) return true;
    }
    return false;
  }

  /// Whether a face has several labels now and had one before, or the other way round.
  bool has_other_state(FaceId f) const {
    const FaceId old = common_.before[f];
    return !old.valid() || has_several_labels(state_, now_, f) != (record_.multi_label[old] != 0);
  }

  /// Whether changed generators have windows in a face, before or after the change.
  bool is_of_change(FaceId f) const {
    const FaceId old = common_.before[f];
    return !old.valid() || any_generator(old_mesh_, field_, old, [&](GeneratorId g) { return is_removed(g); }) ||
           any_generator(mesh_, now_, f, [&](GeneratorId g) { return is_added_[g] != 0; });
  }

  /// Whether generators that stayed away had windows in a face.
  bool is_of_others(FaceId f) const {
    const FaceId old = common_.before[f];
    return open_.contains[f] == 0 ||
           (old.valid() && any_generator(old_mesh_, field_, old, [&](GeneratorId g) { return stayed_away(g); }));
  }

  /// The faces that the change makes different. `is_apart_`: whether those that others make different are apart from
  /// them. If not, more generators are to take part.
  FaceSet find_changes() {
    FaceSet changed(mesh_.face_count()), by_others(mesh_.face_count());
    std::vector<FaceId> different;
    for (const FaceId f : open_.faces) {
      differs_[f] = is_different(f) ? 1 : 0;
      if (differs_[f] != 0) different.push_back(f);
    }
    for (const FaceId f : different) {
      if (is_of_change(f)) changed.add(f);
    }
    is_apart_ = grow_apart(changed);
    for (const FaceId f : different) {
      if (changed.contains[f] == 0 && is_beside_others(f)) by_others.add(f);
    }
    by_others.grow(mesh_, 0, [&](FaceId f) { return differs_[f] != 0; });
    // A difference that neither explains: the change has had an effect far away that no window shows.
    is_apart_ = is_apart_ && std::ranges::all_of(different, [&](FaceId f) {
                  return changed.contains[f] != 0 || by_others.contains[f] != 0;
                });
    for (const FaceId f : different) differs_[f] = 0;
    return changed;
  }

  /// Whether a face, or one at its corners, belongs to generators that stayed away.
  bool is_beside_others(FaceId f) const {
    bool found = is_of_others(f);
    for_each_face_around(mesh_, f, [&](FaceId other) { found = found || open_.contains[other] == 0; });
    return found;
  }

  /// Adds all differences that are connected to these, unless they meet those that others make; then lets the others
  /// take part and returns false.
  bool grow_apart(FaceSet& changed) {
    int rings = kMeetingRings;
    bool apart = true;
    for (std::size_t begin = 0; begin < changed.faces.size() && rings > 0;) {
      const std::size_t end = changed.faces.size();
      for (; begin < end; ++begin) {
        const FaceId f = changed.faces[begin];
        if (is_beside_others(f)) {
          apart = false;
          select_in(f);
        }
        for_each_face_around(mesh_, f, [&](FaceId other) {
          if (!apart || open_.contains[other] == 0) select_in(other);
          if (differs_[other] != 0) changed.add(other);
        });
      }
      if (!apart) --rings;
    }
    return apart;
  }

  /// Takes over what differs.
  WindowChange take(FaceSet changed) {
    std::ranges::sort(changed.faces);
    count_carried(changed);
    renumber();
    take_windows(changed);
    for (const FaceId f : changed.faces) {
      for (const VertexId v : mesh_.vertices(f)) {
        field_.distance[v] = now_.distance[v];
        field_.label[v] = now_.label[v];
      }
      for (const HalfedgeId h : Mesh::halfedges(f)) record_.halfedge[h] = records_[h];
      record_.multi_label[f] = has_several_labels(state_, now_, f) ? 1 : 0;
    }
    return {std::move(changed.contains), std::move(changed.faces),
            static_cast<std::int32_t>(std::ranges::count(selected_.raw(), 1))};
  }

  /// Keeps the number of carried windows up to date; those that end at the boundary are not carried.
  void count_carried(const FaceSet& changed) {
    const auto add = [&](const Mesh& mesh, const auto& records, FaceId f, std::int64_t sign) {
      for (const HalfedgeId h : Mesh::halfedges(f)) {
        if (mesh.twin(h).valid()) field_.carried += sign * static_cast<std::int64_t>(records[h].count);
      }
    };
    for (const FaceId f : common_.only_before) add(old_mesh_, record_.halfedge, f, -1);
    for (const FaceId f : changed.faces) {
      if (common_.before[f].valid()) add(old_mesh_, record_.halfedge, common_.before[f], -1);
      add(mesh_, records_, f, 1);
    }
  }

  /// Brings what belongs to parts of split faces, and to inserted vertices, under their new numbers.
  void renumber() {
    struct Moved {
      std::array<HalfedgeRecord, 3> records;
      std::uint8_t multi_label = 0;
      std::vector<Window> windows;
    };
    const std::int32_t faces = after_.input().face_count(), vertices = after_.input().vertex_count();
    std::vector<Moved> moved(mesh_.face_count() - faces);
    for (std::int32_t i = faces; i < mesh_.face_count(); ++i) {
      const FaceId old = common_.before[FaceId(i)];
      if (!old.valid()) continue;
      Moved& part = moved[i - faces];
      for (int k = 0; k < 3; ++k) part.records[k] = record_.halfedge[Mesh::halfedge(old, k)];
      part.multi_label = record_.multi_label[old];
      field_.windows.for_each(old, [&](Window w) {
        w.halfedge = Mesh::halfedge(FaceId(i), Mesh::corner(w.halfedge));
        part.windows.push_back(w);
      });
    }
    record_.halfedge.resize(mesh_.halfedge_count());
    record_.multi_label.resize(mesh_.face_count());
    field_.windows.resize(mesh_.face_count());
    for (std::int32_t i = faces; i < mesh_.face_count(); ++i) {
      const Moved& part = moved[i - faces];
      for (int k = 0; k < 3; ++k) record_.halfedge[Mesh::halfedge(FaceId(i), k)] = part.records[k];
      record_.multi_label[FaceId(i)] = part.multi_label;
      field_.windows.replace(FaceId(i), part.windows);
    }
    std::vector<std::pair<double, GeneratorId>> labels;
    for (std::int32_t i = vertices; i < mesh_.vertex_count(); ++i) {
      const VertexId old = common_.vertex_before[VertexId(i)];
      labels.emplace_back(old.valid() ? field_.distance[old] : kInfinity,
                          old.valid() ? field_.label[old] : GeneratorId());
    }
    field_.distance.resize(vertices);
    field_.label.resize(vertices);
    for (const auto& [distance, label] : labels) {
      field_.distance.push_back(distance);
      field_.label.push_back(label);
    }
  }

  /// Replaces the windows of these faces; those of all others stay where they are.
  void take_windows(const FaceSet& changed) {
    std::vector<Window> windows;
    for (const FaceId f : changed.faces) {
      windows.clear();
      now_.windows.for_each(f, [&](const Window& w) { windows.push_back(w); });
      field_.windows.replace(f, windows);
    }
  }

  // What is updated: as before the change until `take`.
  WindowField& field_;
  WindowRecord& record_;
  // The change.
  const Mesh& old_mesh_;
  const WorkingMesh &before_, &after_;
  const Mesh& mesh_;
  const CommonElements& common_;
  const ChangedGenerators& changed_;
  // Propagations report through `progress_`, and nothing else does.
  const Progress& progress_;
  const Progress silent_;
  const ParallelChunks parallel_;
  PropagationState& state_;
  // 1 for generators that take part, and for changed ones, by their numbers after the change.
  GeneratorFlags selected_, is_added_;
  // 1 for changed generators by their numbers before.
  GeneratorFlags is_removed_;
  // Faces that the change touches, and those that windows may enter in an attempt.
  FaceSet touched_, open_;
  // 1 for open faces that differ from those before the change; all 0 between attempts.
  IdVector<FaceId, std::uint8_t> differs_;
  // Whether the last attempt has parted the change from what others make different.
  bool is_apart_ = false;
  // Windows, distances and records of those that took part in the last attempt.
  WindowField now_;
  IdVector<HalfedgeId, HalfedgeRecord> records_;
};

EditableWindows::EditableWindows(const WorkingMesh& working, int threads, const Progress& progress)
    : threads_(threads) {
  const Mesh& mesh = working.mesh();
  const Progress silent;
  const ParallelChunks parallel(threads, silent);
  report_progress(progress, steps::kDistances, 0);
  state_ = std::make_unique<PropagationState>(mesh, counts(working.input()), recorded_options(threads), parallel);
  PropagationState& state = *state_;
  note_least_sine(working, mesh.faces());
  record_.mode = mode_of(state.frames);
  record_.halfedge.resize(mesh.halfedge_count());
  const IdVector<FaceId, std::uint8_t> all(mesh.face_count(), 1);
  field_ = propagate(working, GeneratorFlags(working.generator_vertices().size(), 1),
                     WindowRecorder(all, record_.halfedge), {state, parallel, progress});
  for (const FaceId f : mesh.faces()) record_.multi_label.push_back(has_several_labels(state, field_, f) ? 1 : 0);
  packed_ = field_.windows.size();
}

/// Remembers the least sine of a face that no generator splits, if it is among these.
template <class Faces>
void EditableWindows::note_least_sine(const WorkingMesh& working, const Faces& faces) {
  for (const FaceId f : faces) {
    if (working.is_split(f) || !(state_->frames.least_sine_of(f) < least_.sine)) continue;
    least_ = {f, state_->frames.least_sine_of(f)};
  }
}

/// Brings the frames of the faces up to date, and all that depends on them. Faces that either mesh splits have changed,
/// and their neighbours have other halfedges beside them.
void EditableWindows::follow(const GeneratorChange& change) {
  const WorkingMesh &before = change.before, &after = change.after;
  const Mesh& mesh = after.mesh();
  std::vector<FaceId> changed;
  for (const FaceId f : mesh.faces()) {
    const bool was_split = f.value() < before.mesh().face_count() && before.is_split(f);
    if (!was_split && !after.is_split(f)) continue;
    changed.push_back(f);
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (mesh.twin(h).valid()) changed.push_back(Mesh::face(mesh.twin(h)));
    }
  }
  FaceFrames& frames = state_->frames;
  state_->restart(mesh, changed);
  if (least_.face.valid() && after.is_split(least_.face)) {
    least_ = {};
    note_least_sine(after, mesh.faces());
  } else {
    note_least_sine(after, changed);
  }
  double least = least_.sine;
  for (const FaceId f : changed) least = std::min(least, frames.least_sine_of(f));
  frames.set_least_sine(least);
}

WindowChange EditableWindows::update(const GeneratorChange& change, const Progress& progress) {
  report_progress(progress, steps::kDistances, 0);
  follow(change);
  const WorkingMesh& after = change.after;
  if (mode_of(state_->frames) != record_.mode) {
    const Progress silent;
    const ParallelChunks parallel(threads_, silent);
    state_ =
        std::make_unique<PropagationState>(after.mesh(), counts(after.input()), recorded_options(threads_), parallel);
  }
  WindowChange result = WindowUpdate(*this, change, progress).run();
  if (field_.windows.size() > 2 * packed_ + kScanChunk) {
    field_.windows = field_.windows.packed();
    packed_ = field_.windows.size();
  }
  return result;
}

}  // namespace gvd

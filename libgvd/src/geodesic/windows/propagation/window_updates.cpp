// Keeps windows up to date with the generators of a diagram.
//
// Idea: find_changed_windows tells which faces a change makes different. The windows, labels and digests of these faces
// are replaced; those of all other faces stay where they are. Parts of split faces get new numbers with each change,
// and their data moves along.
// Source: none; see changed_windows.cpp.
// Invariant: field and record have the bits of a propagation of all generators. All windows depend on the mode, so that
// all generators are propagated again when it changes.
#include "geodesic/windows/propagation/window_updates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "geodesic/windows/propagation/changed_windows.hpp"

namespace gvd {
namespace {

/// The options with which `compute_diagram` propagates windows.
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

/// Moves the items of elements `first` .. `end` - 1 to their new numbers. number_before(id) is the previous number of
/// an element, or invalid for an element that gets `fresh`.
template <class Id, class Item, class NumberBefore>
void renumber(IdVector<Id, Item>& items, std::int32_t first, std::int32_t end, const NumberBefore& number_before,
              const Item& fresh) {
  std::vector<Item> moved;
  for (std::int32_t i = first; i < end; ++i) {
    const Id before = number_before(Id(i));
    moved.push_back(before.valid() ? items[before] : fresh);
  }
  items.resize(end);
  std::ranges::move(moved, items.begin() + first);
}

/// The same for the windows of faces.
void renumber(EdgeWindows& windows, std::int32_t first, const IdVector<FaceId, FaceId>& number_before) {
  std::vector<std::vector<Window>> moved;
  for (std::int32_t i = first; i < number_before.count(); ++i) {
    std::vector<Window>& of_face = moved.emplace_back();
    if (!number_before[FaceId(i)].valid()) continue;
    windows.for_each(number_before[FaceId(i)], [&](Window w) {
      w.halfedge = Mesh::halfedge(FaceId(i), Mesh::corner(w.halfedge));
      of_face.push_back(w);
    });
  }
  windows.resize(number_before.size());
  for (std::size_t i = 0; i < moved.size(); ++i) windows.replace(FaceId(first + i), moved[i]);
}

}  // namespace

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
  RecordedWindows all = propagate_all(working, {state, parallel, progress});
  field_ = std::move(all.field);
  record_.halfedge = std::move(all.records);
  for (const FaceId f : mesh.faces()) record_.multi_label.push_back(has_several_labels(state, field_, f) ? 1 : 0);
  packed_ = field_.windows.size();
}

/// Updates the least sine of faces that no generator splits by these faces.
template <class Faces>
void EditableWindows::note_least_sine(const WorkingMesh& working, const Faces& faces) {
  for (const FaceId f : faces) {
    if (working.is_split(f) || !(state_->frames.least_sine_of(f) < least_.sine)) continue;
    least_ = {f, state_->frames.least_sine_of(f)};
  }
}

/// Updates the frames of the faces, and everything that depends on them. Faces that are split in either mesh have
/// changed, and their neighbours have other halfedges beside them.
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

/// Moves all data of parts of split faces, and of inserted vertices, to their new numbers.
void EditableWindows::renumber_split(const GeneratorChange& change) {
  const Mesh &mesh = change.after.mesh(), &input = change.after.input();
  const auto face_before = [&](FaceId f) { return change.common.before[f]; };
  const auto halfedge_before = [&](HalfedgeId h) {
    const FaceId old = face_before(Mesh::face(h));
    return old.valid() ? Mesh::halfedge(old, Mesh::corner(h)) : HalfedgeId();
  };
  const auto vertex_before = [&](VertexId v) { return change.common.vertex_before[v]; };
  renumber(record_.halfedge, input.halfedge_count(), mesh.halfedge_count(), halfedge_before, HalfedgeRecord());
  renumber(record_.multi_label, input.face_count(), mesh.face_count(), face_before, std::uint8_t{0});
  renumber(field_.windows, input.face_count(), change.common.before);
  renumber(field_.distance, input.vertex_count(), mesh.vertex_count(), vertex_before, kInfinity);
  renumber(field_.label, input.vertex_count(), mesh.vertex_count(), vertex_before, GeneratorId());
}

/// Updates the number of carried windows. Windows that end at the boundary are not carried.
void EditableWindows::count_carried(const GeneratorChange& change, const ChangedWindows& changed) {
  const auto count = [](const Mesh& mesh, const IdVector<HalfedgeId, HalfedgeRecord>& records, FaceId f) {
    std::int64_t windows = 0;
    for (const HalfedgeId h : Mesh::halfedges(f)) windows += mesh.twin(h).valid() ? records[h].count : 0;
    return windows;
  };
  for (const FaceId f : change.common.only_before) field_.carried -= count(change.before.mesh(), record_.halfedge, f);
  for (const FaceId f : changed.faces.faces) {
    const FaceId old = change.common.before[f];
    if (old.valid()) field_.carried -= count(change.before.mesh(), record_.halfedge, old);
    field_.carried += count(change.after.mesh(), changed.windows.records, f);
  }
}

/// Takes over the data of the changed faces from the last propagation.
void EditableWindows::take(const GeneratorChange& change, const ChangedWindows& changed) {
  const Mesh& mesh = change.after.mesh();
  const WindowField& now = changed.windows.field;
  count_carried(change, changed);
  renumber_split(change);
  std::vector<Window> windows;
  for (const FaceId f : changed.faces.faces) {
    windows.clear();
    now.windows.for_each(f, [&](const Window& w) { windows.push_back(w); });
    field_.windows.replace(f, windows);
    for (const VertexId v : mesh.vertices(f)) {
      field_.distance[v] = now.distance[v];
      field_.label[v] = now.label[v];
    }
    for (const HalfedgeId h : Mesh::halfedges(f)) record_.halfedge[h] = changed.windows.records[h];
    record_.multi_label[f] = has_several_labels(*state_, now, f) ? 1 : 0;
  }
}

WindowChange EditableWindows::update(const GeneratorChange& change, const Progress& progress) {
  report_progress(progress, steps::kDistances, 0);
  follow(change);
  const WorkingMesh& after = change.after;
  const Progress silent;
  const ParallelChunks parallel(threads_, silent);
  const bool is_same_mode = mode_of(state_->frames) == record_.mode;
  if (!is_same_mode) {
    state_ =
        std::make_unique<PropagationState>(after.mesh(), counts(after.input()), recorded_options(threads_), parallel);
    record_.mode = mode_of(state_->frames);
  }
  const PropagationSite site{*state_, parallel, progress};
  ChangedWindows changed = is_same_mode ? find_changed_windows(change, field_, record_, site)
                                        : ChangedWindows{make_full_set(after.mesh()), propagate_all(after, site),
                                                         after.generator_vertices().count()};
  std::ranges::sort(changed.faces.faces);
  take(change, changed);
  if (field_.windows.size() > 2 * packed_ + kScanChunk) {
    field_.windows = field_.windows.packed();
    packed_ = field_.windows.size();
  }
  return {std::move(changed.faces.contains), std::move(changed.faces.faces), changed.propagated};
}

}  // namespace gvd

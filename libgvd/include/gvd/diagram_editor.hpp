#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// An exact diagram whose generators can be moved, added and removed. Each change updates only what changed.
///
/// Use it to drag a generator, to add generators where a diagram is not good enough, or to try single moves. If many
/// generators change at once, `compute_diagram` is faster: a move costs a fifth of it.
///
///     DiagramEditor editor(mesh, generators);
///     for (const SurfacePoint& p : path) show(editor.move(GeneratorId(3), p));
///
/// `examples/edit_a_diagram.cpp` is a whole program.
///
/// Properties: (1) after any changes, the diagram has the bytes of `compute_diagram(mesh, generators, options)`: it
/// depends on the generators alone, not on the changes that led to them. Only where shortest paths tie to the last bit,
/// as on meshes with exact symmetries, may it break a tie in another way: 3 of 39,000 random edits did; (2) it is
/// the same for any number of threads; (3) a change that throws gvd::Error leaves generators and diagram as they were.
/// Source: none; docs/developer/exact.md, section 12, explains why (1) holds.
/// Cost of a change: O(n) with small constants, for copies and sums over n faces, and the work of `compute_diagram` in
/// the cells of the generator and of its neighbours. With 100 generators on 69,451 faces, a move takes a fifth to a
/// quarter of the time of a new diagram (docs/notes/performance.md). If most cells are neighbours, as with ten
/// generators, it takes about as long as a new diagram. After an interruption, the next change starts from scratch.
/// Memory: about 450 bytes a face, and as much again during a change.
class DiagramEditor {
 public:
  /// Computes the diagram of `generators`. The mesh must outlive the editor.
  ///
  /// Throws what `compute_diagram` throws. Throws Error{invalid_option} for another method than Method::exact, and for
  /// weights, because all distances depend on the least weight, which a change could alter. There is no editor for
  /// generators that are curves.
  DiagramEditor(const Mesh& mesh, std::vector<SurfacePoint> generators, DiagramOptions options = {});
  ~DiagramEditor();
  DiagramEditor(DiagramEditor&& other) noexcept;
  DiagramEditor& operator=(DiagramEditor&& other) noexcept;

  /// The diagram of the present generators; valid until the next change.
  const Diagram& diagram() const;
  /// The present generators, by GeneratorId.
  const std::vector<SurfacePoint>& generators() const { return diagram().generators; }

  /// Moves generator g to another point, near or far. Throws Error{precondition} if there is no such generator, or the
  /// point lies in no face of the mesh, or coincides with another generator.
  const Diagram& move(GeneratorId g, const SurfacePoint& to);
  /// Adds a generator, which gets the next number. Throws as `move` does.
  const Diagram& add(const SurfacePoint& point) { return add(std::vector<SurfacePoint>{point}); }
  /// Adds generators in one change, which get the next numbers. Throws as `move` does.
  const Diagram& add(const std::vector<SurfacePoint>& points);
  /// Removes generator g. The last generator gets its number, and all other generators keep theirs. Throws
  /// Error{precondition} if there is no such generator, or if it is the only one.
  const Diagram& remove(GeneratorId g);

  /// How many generators the last change propagated again: all of them after the constructor, and after a change that
  /// could not be kept local.
  std::int32_t propagated() const;

  /// Sets how the next changes run. The arguments mean what they mean in DiagramOptions.
  void run_with(int threads, Progress progress);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gvd

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "geodesic/windows/propagation/window_record.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/progress.hpp"
#include "mesh/common_elements.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

struct ChangedWindows;

/// The effect of a change of some generators on the windows.
struct WindowChange {
  IdVector<FaceId, std::uint8_t> is_changed;  ///< 1 for a face that is new, or whose windows or corners have changed
  std::vector<FaceId> changed;                ///< the same faces, ascending
  std::int32_t propagated = 0;                ///< number of generators that were propagated again
};

/// Exact distances, and the windows near bisectors, that follow changes of the generators.
///
/// Properties: (1) field() has the bits that `propagate_windows` gives for the same working mesh; (2) so has the record
/// of all windows that were carried. If an update throws, the object can only be assigned to or destroyed.
/// Memory: 49 bytes a face besides the windows, and the memory of one propagation.
class EditableWindows {
 public:
  /// Propagates all generators. Cost: that of `propagate_windows`, and about a tenth more for the record.
  EditableWindows(const WorkingMesh& working, int threads, const Progress& progress);

  const WindowField& field() const { return field_; }
  const WindowRecord& record() const { return record_; }

  /// Follows a change from the present working mesh `before` to `after`, which must outlive the next update.
  /// Cost: O(n) with small constants, and the propagation in the cells that the change may affect: the cells of the
  /// changed generators and of their neighbours. If these are most cells, or the change has effects farther away, all
  /// generators are propagated.
  WindowChange update(const GeneratorChange& change, const Progress& progress);

  /// Sets the number of threads of the next updates.
  void run_with(int threads) { threads_ = threads; }

 private:
  /// The least sine among the faces that no generator splits, and the face that has it.
  struct LeastSine {
    FaceId face;
    double sine = kInfinity;
  };

  template <class Faces>
  void note_least_sine(const WorkingMesh& working, const Faces& faces);
  void follow(const GeneratorChange& change);
  void renumber_split(const GeneratorChange& change);
  void count_carried(const GeneratorChange& change, const ChangedWindows& changed);
  void take(const GeneratorChange& change, const ChangedWindows& changed);

  int threads_;
  std::unique_ptr<PropagationState> state_;  // ready for the next propagation; its mesh is that of the last change
  LeastSine least_;
  WindowField field_;
  WindowRecord record_;
  std::size_t packed_ = 0;  // number of windows when they were last packed
};

}  // namespace gvd

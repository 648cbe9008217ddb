#pragma once

#include <vector>

#include "gvd/io/view.hpp"
#include "io/view/view_steps.hpp"
#include "values.hpp"

namespace gvd::web {

/// Makes the scenes of a mesh: {manifest, blobs}, JSON and the bytes of the arrays that it refers to.
class Scenes {
 public:
  explicit Scenes(SharedMesh input);

  /// Regions without colours keep those that they had, as far as their neighbours allow. Throws Error{precondition} for
  /// a scene that does not fit its mesh. Cost: O(n log n).
  val show(ViewScene scene);
  val of_diagram(const MeshDiagram& of);
  /// Distances from the nearest point, with isolines.
  val of_distances(const val& points);
  /// A file of these distances, as gvd-distance writes it.
  val write_distances(const val& points, const std::string& format) const;

  /// Positions, three coordinates each, in the coordinates of the scenes.
  val to_page(const val& positions) const;

 private:
  SharedMesh input_;
  io::ViewFrame frame_;
  std::vector<Rgb> colors_;  // of the regions of the last diagram
};

void bind_scenes();

}  // namespace gvd::web

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

  val show(ViewScene scene, UpAxis up = UpAxis::y);
  val of_diagram(const MeshDiagram& of);
  /// Distances from the nearest point, with isolines.
  val of_distances(const val& points);

  /// Positions, three coordinates each, in the coordinates of the scenes.
  val to_page(const val& positions) const;

 private:
  SharedMesh input_;
  io::ViewFrame frame_;
  std::vector<Rgb> colors_;  // of the regions of the last diagram
};

void bind_scenes();

}  // namespace gvd::web

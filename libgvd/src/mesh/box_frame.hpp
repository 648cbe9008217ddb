#pragma once

#include <Eigen/Geometry>
#include <span>

#include "gvd/mesh.hpp"

namespace gvd {

/// The axes that the bounding boxes of a mesh's faces follow: those of the coordinates or, where this makes the boxes
/// much smaller, the principal axes of the vertices. A rod of long needles, oblique to the coordinates, would else have
/// boxes that all contain each other.
class BoxFrame {
 public:
  /// Cost: O(n).
  explicit BoxFrame(const Mesh& mesh);

  const Eigen::Matrix3d& axes() const { return axes_; }  ///< as rows
  bool is_turned() const { return rounding_ > 0; }
  Vec3 turned(const Vec3& p) const { return is_turned() ? Vec3(axes_ * p) : p; }

  /// The box with what rounding of turned corners may leave out.
  Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box) const;

  /// The box of some points of the mesh.
  Eigen::AlignedBox3d box(std::span<const Vec3> points) const;

 private:
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  double rounding_ = 0;  // of a turned corner, mesh units; 0 without turning
};

}  // namespace gvd

#include "intersection/face_boxes.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace gvd {
namespace {

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) faces.push_back(FaceId(i));
  return faces;
}

}  // namespace

Box3 face_box(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  const Vec3 &p = mesh.position(a), &q = mesh.position(b), &r = mesh.position(c);
  return {p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
}

FaceBoxes::FaceBoxes(const Mesh& mesh) : FaceBoxes(mesh, all_faces(mesh)) {}

FaceBoxes::FaceBoxes(const Mesh& mesh, std::vector<FaceId> faces) : faces_(std::move(faces)) {
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) boxes_.push_back(face_box(mesh, FaceId(i)));
  if (!faces_.empty()) build(0, static_cast<std::int32_t>(faces_.size()));
}

void FaceBoxes::build(std::int32_t first, std::int32_t count) {
  const std::size_t index = nodes_.size();
  const auto begin = faces_.begin() + first, end = begin + count;
  Node node;
  node.first = first;
  node.count = count;
  node.box = boxes_[*begin];
  for (auto f = begin; f != end; ++f) {
    node.box.low = node.box.low.cwiseMin(boxes_[*f].low);
    node.box.high = node.box.high.cwiseMax(boxes_[*f].high);
  }
  nodes_.push_back(node);
  if (count <= kLeafFaces) return;
  Eigen::Index axis = 0;
  (node.box.high - node.box.low).maxCoeff(&axis);
  const auto middle = [&](FaceId f) { return boxes_[f].low[axis] + boxes_[f].high[axis]; };
  std::nth_element(begin, begin + count / 2, end,
                   [&](FaceId f, FaceId g) { return std::tuple(middle(f), f) < std::tuple(middle(g), g); });
  build(first, count / 2);
  nodes_[index].right = static_cast<std::int32_t>(nodes_.size());
  build(first + count / 2, count - count / 2);
}

}  // namespace gvd

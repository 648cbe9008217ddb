#include "base/box_tree.hpp"

namespace gvd {

void BoxTree::remove(std::size_t item) {
  std::size_t node = leaves_ + item;
  boxes_[node] = Box2();
  while ((node /= 2) > 0) unite_children(node);
}

}  // namespace gvd

#include "repair/dual_graph.hpp"

namespace gvd {

void DualGraph::add_link(HalfedgeId crossed, std::int32_t from, std::int32_t to) {
  const auto link = static_cast<std::int32_t>(links_.size());
  links_.push_back({crossed, {from, to}});
  for (const std::int32_t node : links_.back().nodes) {
    if (node != kOutside) links_of_[node].push_back(link);
  }
}

std::vector<HalfedgeId> DualGraph::prune_leaves() const {
  std::vector<std::size_t> degree;
  std::vector<std::size_t> leaves;
  for (std::size_t i = 0; i < links_of_.size(); ++i) {
    degree.push_back(links_of_[i].size());
    if (degree.back() == 1) leaves.push_back(i);
  }
  std::vector<char> is_removed(links_.size(), 0);
  while (!leaves.empty()) {
    const std::size_t leaf = leaves.back();
    leaves.pop_back();
    for (const std::int32_t i : links_of_[leaf]) {
      const auto link = static_cast<std::size_t>(i);
      if (is_removed[link]) continue;
      is_removed[link] = 1;
      for (const std::int32_t node : links_[link].nodes) {
        if (node != kOutside && --degree[node] == 1) {
          leaves.push_back(static_cast<std::size_t>(node));
        }
      }
    }
  }
  std::vector<HalfedgeId> remaining;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (!is_removed[i]) remaining.push_back(links_[i].crossed);
  }
  return remaining;
}

}  // namespace gvd

// Finds a maximum flow by shortest augmenting paths (E. A. Dinic 1970). The residual graph then gives the minimum cut.
#include "min_cut.hpp"

#include <algorithm>

namespace gvd {

void MinCut::begin(std::int32_t nodes) {
  arcs_.clear();
  steps_ = 0;
  first_.assign(nodes, -1);
  excess_.assign(nodes, 0);
}

void MinCut::add_edges(std::int32_t a, std::int32_t b, std::int64_t forward, std::int64_t backward) {
  const auto i = static_cast<std::int32_t>(arcs_.size());
  arcs_.push_back({b, first_[a], forward});
  arcs_.push_back({a, first_[b], backward});
  first_[a] = i;
  first_[b] = i + 1;
}

void MinCut::run() {
  while (find_levels()) {
    current_ = first_;
    for (const std::int32_t v : queue_) {
      if (level_[v] > 0) break;
      push_from(v);
      if (steps_ <= kMostSteps * std::ssize(first_)) continue;
      level_.assign(first_.size(), -1);
      return;
    }
  }
}

bool MinCut::find_levels() {
  level_.assign(first_.size(), -1);
  queue_.clear();
  for (std::int32_t v = 0; v < std::ssize(first_); ++v) {
    if (excess_[v] <= 0) continue;
    level_[v] = 0;
    queue_.push_back(v);
  }
  bool found = false;
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const std::int32_t v = queue_[k];
    found = found || excess_[v] < 0;
    for (std::int32_t i = first_[v]; i >= 0; i = arcs_[i].next) {
      if (arcs_[i].capacity == 0 || level_[arcs_[i].to] >= 0) continue;
      level_[arcs_[i].to] = level_[v] + 1;
      queue_.push_back(arcs_[i].to);
    }
  }
  return found;
}

void MinCut::push_from(std::int32_t source) {
  path_.clear();
  while (excess_[source] > 0) {
    const std::int32_t v = path_.empty() ? source : arcs_[path_.back()].to;
    if (excess_[v] < 0) {
      push_along_path(source, v);
    } else if (const std::int32_t i = advance(v); i >= 0) {
      path_.push_back(i);
    } else if (path_.empty()) {
      return;
    } else {
      path_.pop_back();
      const std::int32_t u = path_.empty() ? source : arcs_[path_.back()].to;
      current_[u] = arcs_[current_[u]].next;
    }
  }
}

std::int32_t MinCut::advance(std::int32_t v) {
  for (std::int32_t& i = current_[v]; i >= 0; i = arcs_[i].next) {
    if (arcs_[i].capacity > 0 && level_[arcs_[i].to] == level_[v] + 1) return i;
  }
  return -1;
}

void MinCut::push_along_path(std::int32_t source, std::int32_t sink) {
  std::int64_t most = std::min(excess_[source], -excess_[sink]);
  for (const std::int32_t i : path_) most = std::min(most, arcs_[i].capacity);
  steps_ += std::ssize(path_);
  excess_[source] -= most;
  excess_[sink] += most;
  for (const std::int32_t i : path_) {
    arcs_[i].capacity -= most;
    arcs_[i ^ 1].capacity += most;
  }
  const auto full = std::ranges::find_if(path_, [&](std::int32_t i) { return arcs_[i].capacity == 0; });
  path_.erase(full, path_.end());
}

}  // namespace gvd

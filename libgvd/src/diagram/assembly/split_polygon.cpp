#include "diagram/assembly/split_polygon.hpp"

#include <map>
#include <utility>

namespace gvd {

// Pieces do not cross. So the smaller polygons are nested, and one pass over the corners cuts each off when its second
// interval comes, the inner ones first.
std::vector<FacePolygon> split_at_united_intervals(const FacePolygon& polygon, LabelIntervals& intervals) {
  std::vector<FacePolygon> polygons;
  FacePolygon rest;
  std::map<int, std::vector<std::size_t>> found;  // piece -> indices of its intervals in `rest`, ascending
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t last = rest.size();
    auto& own = found[intervals.piece(polygon[k].interval)];
    // Some of them have been cut off from `rest` with a smaller polygon.
    while (!own.empty() &&
           (own.back() >= last || !intervals.are_one_piece(rest[own.back()].interval, polygon[k].interval)))
      own.pop_back();
    rest.push_back(polygon[k]);
    const bool closes_round = !own.empty() && own.back() == 0 && k + 1 == polygon.size();
    if (own.empty() || own.back() + 1 == last || closes_round) {
      own.push_back(last);
      continue;
    }
    const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(own.back() + 1);
    polygons.emplace_back(begin, rest.end());
    rest.erase(begin, rest.end());
  }
  if (!polygons.empty()) polygons.push_back(std::move(rest));
  return polygons;
}

}  // namespace gvd

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "gvd/region_statistics.hpp"

namespace gvd {
namespace {

constexpr const char* kHeader = "label,area,share,perimeter,radius,compactness,euler_characteristic,neighbours\r\n";

std::string shortest(double value) {
  if (!std::isfinite(value)) return "";
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// "3=0.25 7=1.5". Not "3:25", which spreadsheets take for a time.
std::string list_neighbours(const std::vector<RegionNeighbour>& neighbours) {
  std::string text;
  for (const RegionNeighbour& n : neighbours) {
    if (!text.empty()) text += ' ';
    text += std::to_string(n.region.value()) + '=' + shortest(n.border_length);
  }
  return text;
}

}  // namespace

void write_statistics_csv(std::ostream& out, const IdVector<GeneratorId, RegionStatistics>& regions) {
  out << kHeader;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const RegionStatistics& r = regions.raw()[i];
    std::string line = std::to_string(i);
    for (const double value : {r.area, r.share, r.perimeter, r.radius, r.compactness}) line += ',' + shortest(value);
    line += ',' + std::to_string(r.euler_characteristic) + ',' + list_neighbours(r.neighbours) + "\r\n";
    out << line;
  }
}

}  // namespace gvd

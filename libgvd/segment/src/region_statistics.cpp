// Computes figures of regions, from the diagram's cells and from labelled faces.
//
// Area and Euler characteristic are the diagram's own; lengths are measured on its polylines. A bisector counts in the
// perimeter of both of its cells, so it counts twice if both are the same cell. The mesh's boundary counts for the
// cells whose faces and pieces lie on it. The radius is the largest known distance: at vertices, at branch points, and
// at the corners of pieces in the generator's faces. Charts belong to parts of a cut mesh, and are joined by label.
// Sums run over bisectors, halfedges and pieces in their order.
#include "gvd/region_statistics.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/barycentric.hpp"
#include "diagram/bisector_length.hpp"
#include "diagram/cell_parts.hpp"
#include "face_shares.hpp"
#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

using Regions = IdVector<GeneratorId, RegionStatistics>;

Regions take_cells(const Mesh& mesh, const Diagram& diagram) {
  Regions regions(diagram.generators.size());
  const double total = compute_area(mesh);
  for (const Cell& cell : diagram.cells) {
    RegionStatistics& region = regions[cell.generator];
    region.area = cell.area;
    region.share = total > 0 ? cell.area / total : 0;
    region.euler_characteristic = cell.euler_characteristic;
    for (const GeneratorId g : cell.neighbours) region.neighbours.push_back({g, 0});
  }
  return regions;
}

void add_bisectors(const Mesh& mesh, const Diagram& diagram, Regions& regions) {
  const auto add_border = [&](GeneratorId region, GeneratorId neighbour, double length) {
    std::vector<RegionNeighbour>& all = regions[region].neighbours;
    const auto found = std::ranges::lower_bound(all, neighbour, {}, &RegionNeighbour::region);
    if (found != all.end() && found->region == neighbour) found->border_length += length;
  };
  for (const Bisector& bisector : diagram.bisectors) {
    const double length = compute_length(mesh, bisector);
    regions[bisector.left].perimeter += length;
    regions[bisector.right].perimeter += length;
    if (bisector.left == bisector.right) continue;
    add_border(bisector.left, bisector.right, length);
    add_border(bisector.right, bisector.left, length);
  }
}

/// The fraction of a face's side that bounds the part. Corners on the side have the coordinate 0, apart from the
/// rounding of coordinates that were converted from a split face.
double covered_part(const FacePart& part, int side) {
  const int opposite = (side + 2) % 3;
  double sum = 0;
  for (std::size_t i = 0; i < part.corners.size(); ++i) {
    const Bary &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
    if (a[opposite] > kBarycentricSnap || b[opposite] > kBarycentricSnap) continue;
    sum += std::max(0.0, a[side] - b[side]);  // pieces are counter-clockwise, like the side
  }
  return sum;
}

void add_mesh_boundary(const Mesh& mesh, const Diagram& diagram, Regions& regions) {
  for_each_cell_part(diagram, [&](const FacePart& part) {
    for (const HalfedgeId h : Mesh::halfedges(part.face)) {
      if (mesh.twin(h).valid()) continue;
      regions[part.generator].perimeter += mesh.length(h) * covered_part(part, Mesh::corner(h));
    }
  });
}

void measure_radii(const Mesh& mesh, const Diagram& diagram, Regions& regions) {
  const auto extend = [&](GeneratorId g, double distance) {
    if (g.valid()) regions[g].radius = std::max(regions[g].radius, distance);
  };
  for (const VertexId v : mesh.vertices()) extend(diagram.vertex_label[v], diagram.vertex_distance[v]);
  for (const BranchPoint& point : diagram.branch_points) {
    for (const GeneratorId g : point.generators) extend(g, point.distance - diagram.weight(g));
  }
  std::vector<std::pair<FaceId, GeneratorId>> own;
  for (const GeneratorId g : regions.ids()) {
    if (!diagram.curves.empty()) continue;  // the first point of a curve need not be the nearest
    for (const FaceId f : faces_around(mesh, diagram.generators[g.index()])) own.emplace_back(f, g);
  }
  std::sort(own.begin(), own.end());
  for (const FacePiece& piece : diagram.pieces) {
    if (!std::binary_search(own.begin(), own.end(), std::pair(piece.face, piece.generator))) continue;
    const Vec3 from = position(mesh, diagram.generators[piece.generator.index()]);
    for (const Bary& b : piece.corners) {
      extend(piece.generator, (position(mesh, SurfacePoint{piece.face, b}) - from).norm());
    }
  }
}

constexpr const char *kHeader = "label,area,share,perimeter,radius,compactness,euler_characteristic,neighbours",
                     *kChartsHeader = ",flipped_share,stretch,u_min,v_min,u_max,v_max";

/// The fewest digits that read back as the same double; empty for a value that is not finite.
std::string shortest(double value) {
  if (!std::isfinite(value)) return "";
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

/// A list like "3=0.25 7=1.5"; spreadsheets would take "3:25" for a time.
std::string list_neighbours(const std::vector<RegionNeighbour>& neighbours) {
  std::string text;
  for (const RegionNeighbour& n : neighbours) {
    if (!text.empty()) text += ' ';
    text += std::to_string(n.region.value()) + '=' + shortest(n.border_length);
  }
  return text;
}

/// Joins the charts of each region, because a disconnected region has several. The stretch is their mean, weighted by
/// placed area.
IdVector<GeneratorId, Chart> join_charts(const std::vector<Chart>& charts, std::size_t regions) {
  IdVector<GeneratorId, Chart> joined(regions);
  for (const Chart& chart : charts) {
    Chart& all = joined[chart.generator];
    const double before = all.area - all.unplaced_area, own = chart.area - chart.unplaced_area;
    if (own > 0) all.stretch = (before * all.stretch + own * chart.stretch) / (before + own);
    all.area += chart.area;
    all.flipped_area += chart.flipped_area;
    all.unplaced_area += chart.unplaced_area;
    all.box.extend(chart.box);
  }
  return joined;
}

/// The further fields of a region with charts; empty fields without a chart.
std::string list_chart(const Chart& chart) {
  if (chart.box.isEmpty()) return ",,,,,,";
  const Vec2 &least = chart.box.min(), &most = chart.box.max();
  std::string text;
  for (const double value :
       {chart.flipped_area / chart.area, chart.stretch, least.x(), least.y(), most.x(), most.y()}) {
    text += ',' + shortest(value);
  }
  return text;
}

// Readers need these keys to know the type of each value.
constexpr const char* kGraphHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
    "<key id=\"label\" for=\"node\" attr.name=\"label\" attr.type=\"int\"/>\n"
    "<key id=\"area\" for=\"node\" attr.name=\"area\" attr.type=\"double\"/>\n"
    "<key id=\"x\" for=\"node\" attr.name=\"x\" attr.type=\"double\"/>\n"
    "<key id=\"y\" for=\"node\" attr.name=\"y\" attr.type=\"double\"/>\n"
    "<key id=\"z\" for=\"node\" attr.name=\"z\" attr.type=\"double\"/>\n"
    "<key id=\"length\" for=\"edge\" attr.name=\"length\" attr.type=\"double\"/>\n"
    "<graph edgedefault=\"undirected\">\n";

std::string graph_value(const char* key, double value) {
  return std::string("<data key=\"") + key + "\">" + shortest(value) + "</data>";
}

void check_label_count(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label) {
  if (face_label.count() == mesh.face_count()) return;
  throw Error(ErrorCode::precondition, "the labels were made for another mesh: the number of faces differs");
}

}  // namespace

IdVector<GeneratorId, RegionStatistics> compute_region_statistics(const Mesh& mesh, const Diagram& diagram) {
  check_belongs(mesh, diagram);
  Regions regions = take_cells(mesh, diagram);
  add_bisectors(mesh, diagram, regions);
  add_mesh_boundary(mesh, diagram, regions);
  measure_radii(mesh, diagram, regions);
  for (RegionStatistics& region : regions) {
    region.compactness = 4 * std::numbers::pi * (region.area / region.perimeter) / region.perimeter;
  }
  return regions;
}

void write_statistics_csv(std::ostream& out, const IdVector<GeneratorId, RegionStatistics>& regions,
                          const Charts* charts) {
  out << kHeader << (charts != nullptr ? kChartsHeader : "") << "\r\n";
  IdVector<GeneratorId, Chart> of_region;
  if (charts != nullptr) of_region = join_charts(charts->charts, regions.size());
  for (const GeneratorId g : regions.ids()) {
    const RegionStatistics& r = regions[g];
    std::string line = std::to_string(g.value());
    for (const double value : {r.area, r.share, r.perimeter, r.radius, r.compactness}) line += ',' + shortest(value);
    line += ',' + std::to_string(r.euler_characteristic) + ',' + list_neighbours(r.neighbours);
    out << line << (charts != nullptr ? list_chart(of_region[g]) : "") << "\r\n";
  }
}

void write_adjacency_graphml(std::ostream& out, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const IdVector<GeneratorId, RegionStatistics>& regions) {
  if (generators.size() != regions.size()) {
    throw Error(ErrorCode::precondition, "the graph of regions needs one generator for each region");
  }
  out << kGraphHead;
  for (const GeneratorId g : regions.ids()) {
    const Vec3 p = position(mesh, generators[g.index()]);
    out << "<node id=\"" + std::to_string(g.value()) + "\">" + graph_value("label", g.value()) +
               graph_value("area", regions[g].area) + graph_value("x", p.x()) + graph_value("y", p.y()) +
               graph_value("z", p.z()) + "</node>\n";
  }
  for (const GeneratorId g : regions.ids()) {
    for (const auto& [other, length] : regions[g].neighbours) {
      if (other < g) continue;  // each edge once
      out << "<edge source=\"" + std::to_string(g.value()) + "\" target=\"" + std::to_string(other.value()) + "\">" +
                 graph_value("length", length) + "</edge>\n";
    }
  }
  out << "</graph>\n</graphml>\n";
}

double compute_border_length(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label) {
  check_label_count(mesh, face_label);
  double sum = 0;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (twin.valid() && face_label[Mesh::face(h)] != face_label[Mesh::face(twin)]) sum += mesh.length(h);
  }
  return sum;
}

IdVector<GeneratorId, RegionSize> measure_regions(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& face_label,
                                                  std::size_t regions) {
  check_label_count(mesh, face_label);
  IdVector<GeneratorId, RegionSize> sizes(regions);
  for (const FaceId f : mesh.faces()) {
    const GeneratorId label = face_label[f];
    if (!label.valid()) continue;
    if (label.index() >= regions) {
      throw Error(ErrorCode::precondition, "a face has a label that no region has; give the number of generators",
                  f.value());
    }
    ++sizes[label].faces;
    sizes[label].area += mesh.area(f);
  }
  return sizes;
}

}  // namespace gvd

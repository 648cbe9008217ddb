// Writes distances, paths and isolines as arrays, tables and JSON.
//
// An NPY begins with a magic number, the length of its header, and the header itself: a Python dictionary, padded with
// blanks so that the numbers begin at a multiple of 64 bytes.
// Tables have one line for each value, so that the same header serves distances from the nearest source and distances
// from each source.
// Invariant: numbers have all their digits, so the same doubles are read back, in any locale.
#include "gvd/io/distance_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "gvd/surface_point.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd {
namespace io {

std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape) {
  constexpr std::size_t kAlignment = 64;  // alignment of the numbers in the file
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}{}), }}", type,
                                   fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  std::string bytes("\x93NUMPY\x01\x00", 8);
  const std::size_t before = bytes.size() + sizeof(std::uint16_t);
  header.append(kAlignment - 1 - (before + header.size()) % kAlignment, ' ');
  header.push_back('\n');
  for (const char c : little_endian(std::uint16_t(header.size()))) bytes.push_back(c);
  return bytes + header;
}

}  // namespace io

namespace {

using io::ByteWriter;

void print_distances(ByteWriter& out, const DistanceTable& table) {
  const auto print_rows = [&](const auto& rows, const auto& print) {
    io::print_lines(out, rows, [&](const auto& row) { io::print_array(out, row, print); });
  };
  out.print(",\n\"points\":\"{}\",\n\"distances\":", table.targets.empty() ? "vertices" : "targets");
  print_rows(table.rows.each(), [&](double d) { out.text(io::json_number(d)); });
  out.text(",\n\"nearest\":");
  if (table.nearest.empty()) return out.text("null");
  io::print_ids(out, table.nearest);
}

/// The number of a vertex, or null for a point that is no vertex.
std::string json_vertex(std::int64_t vertex) { return vertex < 0 ? "null" : fmt::format("{}", vertex); }

void print_curves(ByteWriter& out, const Mesh& mesh, const DistanceTable& table) {
  const auto print_point = [&](const SurfacePoint& p) { io::print_point(out, mesh, p); };
  out.text(",\n\"paths\":");
  io::print_lines(out, table.paths, [&](const TargetPath& path) {
    out.print(
        "{{\"source\":{},\"target\":{},\"source_vertex\":{},\"target_vertex\":{},\"length\":{},\"complete\":{},"
        "\"points\":",
        path.source.value(), path.target, json_vertex(table.source_vertex(path.source)),
        json_vertex(table.target_vertex(path.target)), io::json_number(path.path.length), path.path.complete);
    io::print_array(out, path.path.points, print_point);
    out.text("}");
  });
  out.text(",\n\"isolines\":");
  io::print_lines(out, table.isolines, [&](const Isoline& line) {
    out.print("{{\"level\":{},\"closed\":{},\"points\":", line.level, line.closed);
    io::print_array(out, line.points, print_point);
    out.text("}");
  });
}

/// Makes a curve whose distances fall from the path's length to 0.
MeshCurve make_path_curve(const TargetPath& path, std::size_t index) {
  const std::vector<Vec3>& at = path.positions;
  MeshCurve curve{fmt::format("path_{}", index), at, {path.path.length}};
  for (std::size_t k = 1; k < at.size(); ++k) {
    curve.distance.push_back(std::max(0.0, curve.distance.back() - (at[k] - at[k - 1]).norm()));
  }
  return curve;
}

}  // namespace

std::string DistanceTable::source_name(GeneratorId source) const {
  const std::int64_t vertex = source_vertex(source);
  return vertex < 0 ? fmt::format("source {}", source.value()) : fmt::format("vertex {}", vertex);
}

std::string DistanceTable::target_name(std::size_t target) const {
  const std::int64_t vertex = target_vertex(target);
  return vertex < 0 ? fmt::format("point {}", target) : fmt::format("vertex {}", vertex);
}

void write_labels_npy(std::ostream& stream, const std::vector<GeneratorId>& labels) {
  ByteWriter out(stream);
  out.text(io::npy_header("<i4", {labels.size()}));
  for (const GeneratorId label : labels) out.binary(label.value());
  out.finish();
}

void write_labels_csv(std::ostream& stream, const std::vector<GeneratorId>& labels, std::string_view element) {
  ByteWriter out(stream);
  out.print("{},label\n", element);
  for (std::size_t i = 0; i < labels.size(); ++i) out.print("{},{}\n", i, labels[i].value());
  out.finish();
}

void write_levels_npy(std::ostream& stream, const std::vector<FaceNumbers>& levels) {
  ByteWriter out(stream);
  const auto faces = levels.front().values.ids();
  out.text(io::npy_header("<i4", {levels.front().values.size(), levels.size()}));
  for (const FaceId f : faces) {
    for (const FaceNumbers& level : levels) out.binary(level.values[f]);
  }
  out.finish();
}

void write_levels_csv(std::ostream& stream, const std::vector<FaceNumbers>& levels) {
  ByteWriter out(stream);
  out.text("face");
  for (const FaceNumbers& level : levels) out.print(",{}", level.name);
  for (const FaceId f : levels.front().values.ids()) {
    out.print("\n{}", f.value());
    for (const FaceNumbers& level : levels) out.print(",{}", level.values[f]);
  }
  out.text("\n");
  out.finish();
}

void write_distances_npy(std::ostream& stream, const DistanceTable& table) {
  const std::size_t points = table.rows.points();
  const bool is_single = !table.nearest.empty();
  ByteWriter out(stream);
  out.text(io::npy_header("<f8", is_single ? std::vector{points} : std::vector{table.rows.size(), points}));
  for (const double d : table.rows.values()) out.binary(d);
  out.finish();
}

void write_distances_text(std::ostream& stream, const DistanceTable& table) {
  ByteWriter out(stream);
  const std::size_t points = table.rows.points();
  const bool has_targets = !table.targets.empty(), is_single = has_targets && points == 1 && table.rows.size() == 1;
  for (std::size_t i = 0; i < points; ++i) {
    if (!is_single) out.print("{} ", has_targets ? table.target_vertex(i) : std::int64_t(i));
    for (std::size_t row = 0; row < table.rows.size(); ++row) out.print("{}{}", row > 0 ? " " : "", table.rows[row][i]);
    out.text("\n");
  }
  out.finish();
}

void write_distances_csv(std::ostream& stream, const DistanceTable& table) {
  ByteWriter out(stream);
  const bool has_targets = !table.targets.empty(), has_vertices = !table.source_vertices.empty();
  out.print("source,{},distance", has_targets ? "target" : "vertex");
  out.text(!has_vertices ? "\n" : has_targets ? ",source_vertex,target_vertex\n" : ",source_vertex\n");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
      const double d = table.rows[row][i];
      const GeneratorId source = std::isfinite(d) ? table.source(row, i) : GeneratorId();
      out.print("{},{},{}", source.value(), i, d);
      if (has_vertices) out.print(",{}", table.source_vertex(source));
      if (has_vertices && has_targets) out.print(",{}", table.target_vertex(i));
      out.text("\n");
    }
  }
  out.finish();
}

void write_paths_csv(std::ostream& stream, const DistanceTable& table) {
  ByteWriter out(stream);
  out.text("path,source,target,length,face,b0,b1,b2,x,y,z,source_vertex,target_vertex\n");
  for (std::size_t i = 0; i < table.paths.size(); ++i) {
    const auto& [target, source, path, positions] = table.paths[i];
    for (std::size_t k = 0; k < path.points.size(); ++k) {
      const double* const p = positions[k].data();
      out.print("{},{},{},{},{},{},{},{},{}\n", i, source.value(), target, path.length, path.points[k].face.value(),
                fmt::join(path.points[k].bary, ","), fmt::join(p, p + 3, ","), table.source_vertex(source),
                table.target_vertex(std::size_t(target)));
    }
  }
  out.finish();
}

void write_polyline_npy(std::ostream& stream, const std::vector<Vec3>& positions) {
  ByteWriter out(stream);
  out.text(io::npy_header("<f8", {positions.size(), 3}));
  for (const Vec3& at : positions) {
    for (const double x : at) out.binary(x);
  }
  out.finish();
}

void write_polyline_obj(std::ostream& stream, const std::vector<Vec3>& positions) {
  ByteWriter out(stream);
  for (const Vec3& at : positions) out.print("v {} {} {}\n", at.x(), at.y(), at.z());
  if (positions.size() > 1) out.text("l");
  for (std::size_t i = 1; positions.size() > 1 && i <= positions.size(); ++i) out.print(" {}", i);
  if (positions.size() > 1) out.text("\n");
  out.finish();
}

void write_distances_json(std::ostream& stream, const Mesh& mesh, const DistanceTable& table) {
  ByteWriter out(stream);
  const auto print_points = [&](const std::vector<SurfacePoint>& points) {
    io::print_lines(out, points, [&](const SurfacePoint& p) { io::print_point(out, mesh, p); });
  };
  out.text("{\"schema\":\"gvd-distance/1\",\n\"sources\":");
  print_points(table.sources);
  out.text(",\n\"targets\":");
  print_points(table.targets);
  // The vertices get arrays of their own, because points have the same form in all documents.
  const auto print_vertices = [&](std::string_view name, std::size_t points, const auto& vertex_of) {
    out.print(",\n\"{}\":[", name);
    for (std::size_t i = 0; i < points; ++i) out.print("{}{}", i > 0 ? "," : "", json_vertex(vertex_of(i)));
    out.text("]");
  };
  print_vertices("source_vertices", table.sources.size(),
                 [&](std::size_t i) { return table.source_vertex(GeneratorId(i)); });
  print_vertices("target_vertices", table.targets.size(), [&](std::size_t i) { return table.target_vertex(i); });
  print_distances(out, table);
  print_curves(out, mesh, table);
  out.text("}\n");
  out.finish();
}

std::vector<MeshCurve> make_curves(const Mesh& mesh, const DistanceTable& table) {
  std::vector<MeshCurve> curves;
  for (std::size_t i = 0; i < table.paths.size(); ++i) {
    if (table.paths[i].positions.size() > 1) curves.push_back(make_path_curve(table.paths[i], i));
  }
  for (const Isoline& line : table.isolines) {
    MeshCurve& curve = curves.emplace_back(MeshCurve{fmt::format("isoline_{:.10g}", line.level), {}, {}});
    for (const SurfacePoint& point : line.points) curve.points.push_back(position(mesh, point));
    if (line.closed) curve.points.push_back(curve.points.front());
    curve.distance.assign(curve.points.size(), line.level);
  }
  return curves;
}

}  // namespace gvd

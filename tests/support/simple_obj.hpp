#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// Reads an OBJ made of `v x y z` and `f i j k` lines alone. Independent of the library's readers on purpose: the
/// oracle tests must not share their faults. Throws Error{unreadable_input} for anything else than comments, or no
/// file.
inline Mesh read_simple_obj(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw Error(ErrorCode::unreadable_input, "no file " + path.string());
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (std::string line; std::getline(in, line);) {
    const char* at = line.c_str() + (line.empty() ? 0 : 1);
    char* rest = nullptr;
    double value[3];
    if (line.starts_with("v ") || line.starts_with("f ")) {
      for (double& x : value) x = std::strtod(at, &rest), at = rest;
      if (*rest != '\0' && *rest != '\r' && *rest != ' ') throw Error(ErrorCode::unreadable_input, "a line: " + line);
    }
    if (line.starts_with("v ")) positions.emplace_back(value[0], value[1], value[2]);
    if (line.starts_with("f ")) {
      faces.push_back({VertexId(int(value[0]) - 1), VertexId(int(value[1]) - 1), VertexId(int(value[2]) - 1)});
    }
  }
  return Mesh(std::move(positions), std::move(faces));
}

/// Writes an OBJ that `read_simple_obj` reads back bit by bit.
inline void write_simple_obj(const std::filesystem::path& path, const Mesh& mesh) {
  std::ofstream out(path);
  out.precision(std::numeric_limits<double>::max_digits10);
  for (const Vec3& p : mesh.positions()) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& [a, b, c] : mesh.face_vertices()) {
    out << "f " << a.value() + 1 << ' ' << b.value() + 1 << ' ' << c.value() + 1 << '\n';
  }
  if (!out) throw Error(ErrorCode::unwritable_output, "no file " + path.string());
}

}  // namespace gvd::test

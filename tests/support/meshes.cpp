#include "support/meshes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace gvd::test {
namespace {

constexpr double kPi = std::numbers::pi;

struct Builder {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;

  int add(const Vec3& p) {
    positions.push_back(p);
    return static_cast<int>(positions.size()) - 1;
  }
  void triangle(int a, int b, int c) { faces.push_back({VertexId(a), VertexId(b), VertexId(c)}); }
  void quad(int a, int b, int c, int d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  void append(const Mesh& mesh, double factor, const Vec3& offset) {
    const int shift = static_cast<int>(positions.size());
    for (const Vec3& p : mesh.positions()) add(factor * p + offset);
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto& [u, v, w] = mesh.vertices(FaceId(f));
      triangle(u.value() + shift, v.value() + shift, w.value() + shift);
    }
  }
  Mesh build() { return Mesh(std::move(positions), std::move(faces)); }
};

Builder icosphere(int subdivisions) {
  Builder b;
  const double t = (1 + std::sqrt(5.0)) / 2;
  for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{{-1, t, 0},
                                                                  {1, t, 0},
                                                                  {-1, -t, 0},
                                                                  {1, -t, 0},
                                                                  {0, -1, t},
                                                                  {0, 1, t},
                                                                  {0, -1, -t},
                                                                  {0, 1, -t},
                                                                  {t, 0, -1},
                                                                  {t, 0, 1},
                                                                  {-t, 0, -1},
                                                                  {-t, 0, 1}}) {
    b.add(Vec3(x, y, z).normalized());
  }
  for (const auto& [i, j, k] : std::vector<std::array<int, 3>>{
           {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}) {
    b.triangle(i, j, k);
  }
  for (int s = 0; s < subdivisions; ++s) {
    Builder finer;
    finer.positions = b.positions;
    std::map<std::pair<int, int>, int> middle;
    const auto midpoint = [&](VertexId u, VertexId v) {
      const std::pair<int, int> key = std::minmax({u.value(), v.value()});
      const auto [it, fresh] = middle.try_emplace(key, 0);
      if (fresh) it->second = finer.add((b.positions[u.index()] + b.positions[v.index()]).normalized());
      return it->second;
    };
    for (const auto& [u, v, w] : b.faces) {
      const int uv = midpoint(u, v), vw = midpoint(v, w), wu = midpoint(w, u);
      finer.triangle(u.value(), uv, wu);
      finer.triangle(uv, v.value(), vw);
      finer.triangle(wu, vw, w.value());
      finer.triangle(uv, vw, wu);
    }
    b = std::move(finer);
  }
  return b;
}

}  // namespace

Mesh make_sphere(int subdivisions) { return icosphere(subdivisions).build(); }

Mesh make_torus(int around, int across) {
  Builder b;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * kPi * i / around, v = 2 * kPi * j / across;
      const double r = 1 + 0.35 * std::cos(v);
      b.add({r * std::cos(u), r * std::sin(u), 0.35 * std::sin(v)});
    }
  }
  const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) b.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return b.build();
}

namespace {

/// The closed surface of those unit voxels of an nx x ny x 1 layer that `solid` keeps, scaled.
template <class Solid>
Builder slab_surface(int nx, int ny, const Vec3& scale, Solid solid) {
  Builder b;
  std::map<std::array<int, 3>, int> ids;
  const auto at = [&](int i, int j, int k) {
    const auto [it, fresh] = ids.try_emplace({i, j, k}, 0);
    if (fresh) it->second = b.add({scale.x() * i, scale.y() * j, scale.z() * k});
    return it->second;
  };
  const auto filled = [&](int i, int j) { return i >= 0 && j >= 0 && i < nx && j < ny && solid(i, j); };
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      if (!filled(i, j)) continue;
      b.quad(at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1));
      b.quad(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
      if (!filled(i - 1, j)) b.quad(at(i, j, 0), at(i, j, 1), at(i, j + 1, 1), at(i, j + 1, 0));
      if (!filled(i + 1, j)) b.quad(at(i + 1, j, 0), at(i + 1, j + 1, 0), at(i + 1, j + 1, 1), at(i + 1, j, 1));
      if (!filled(i, j - 1)) b.quad(at(i, j, 0), at(i + 1, j, 0), at(i + 1, j, 1), at(i, j, 1));
      if (!filled(i, j + 1)) b.quad(at(i, j + 1, 0), at(i, j + 1, 1), at(i + 1, j + 1, 1), at(i + 1, j + 1, 0));
    }
  }
  return b;
}

}  // namespace

Mesh make_plate(int n, double thickness) {
  return slab_surface(n, n, {1.0 / n, 1.0 / n, thickness}, [](int, int) { return true; }).build();
}

Mesh make_genus3(int n) {
  const int nx = 7 * n, ny = 3 * n;
  const auto solid = [n](int i, int j) { return (j / n) % 2 == 0 || (i / n) % 2 == 0; };
  return slab_surface(nx, ny, {1.0 / n, 1.0 / n, 0.6}, solid).build();
}

Mesh make_grid(int nx, int ny) {
  Builder b;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) b.add({double(i), double(j), 0});
  }
  const auto at = [&](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) b.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return b.build();
}

Mesh make_ring(int around, int across) {
  Builder b;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j <= across; ++j) {
      const double u = 2 * kPi * i / around;
      b.add({std::cos(u), std::sin(u), 0.5 * j / across});
    }
  }
  const auto at = [&](int i, int j) { return (i % around) * (across + 1) + j; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) b.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return b.build();
}

Mesh make_half_sphere(int subdivisions) {
  const Builder whole = icosphere(subdivisions);
  Builder half;
  std::vector<int> renamed(whole.positions.size(), -1);
  for (const auto& face : whole.faces) {
    Vec3 centre = Vec3::Zero();
    for (const VertexId v : face) centre += whole.positions[v.index()] / 3;
    if (centre.z() < 0) continue;
    std::array<VertexId, 3> kept;
    for (std::size_t i = 0; i < 3; ++i) {
      int& id = renamed[face[i].index()];
      if (id < 0) id = half.add(whole.positions[face[i].index()]);
      kept[i] = VertexId(id);
    }
    half.faces.push_back(kept);
  }
  return half.build();
}

Mesh make_bumpy_sphere(int subdivisions, unsigned seed) {
  Builder b = icosphere(subdivisions);
  std::mt19937 random(seed);
  std::array<Vec3, 5> waves;
  for (Vec3& wave : waves) {
    for (int i = 0; i < 3; ++i) wave[i] = 8.0 * (double(random()) / double(std::mt19937::max())) - 4.0;
  }
  for (Vec3& p : b.positions) {
    double radius = 1;
    for (const Vec3& wave : waves) radius += 0.12 * std::sin(wave.dot(p) + wave.x());
    p *= radius;
  }
  return b.build();
}

Mesh make_thin_faced_sphere(int subdivisions, unsigned seed) {
  Builder b = icosphere(subdivisions);
  std::mt19937 random(seed);
  const double edge = 1.1 / std::pow(2.0, subdivisions);
  for (Vec3& p : b.positions) {
    Vec3 shift;
    for (int i = 0; i < 3; ++i) shift[i] = double(random()) / double(std::mt19937::max()) - 0.5;
    p = (p + 0.6 * edge * shift).normalized();
    p.x() *= 4;
    p.z() *= 0.25;
  }
  return b.build();
}

Mesh make_two_components() {
  Builder b;
  b.append(make_sphere(2), 1, Vec3(0, 0, 0));
  b.append(make_torus(16, 8), 1, Vec3(4, 0, 0));
  return b.build();
}

Mesh make_nested_spheres(double inner_radius) {
  Builder b;
  b.append(make_sphere(2), 1, Vec3(0, 0, 0));
  b.append(make_sphere(2), inner_radius, Vec3(0, 0, 0));
  return b.build();
}

std::vector<NamedMesh> small_family() {
  std::vector<NamedMesh> family;
  family.push_back({"sphere", make_sphere(2)});
  family.push_back({"torus", make_torus(24, 12)});
  family.push_back({"plate", make_plate(10)});
  family.push_back({"grid", make_grid(12, 9)});
  family.push_back({"ring", make_ring(24, 6)});
  family.push_back({"half sphere", make_half_sphere(2)});
  family.push_back({"bumpy sphere", make_bumpy_sphere(3, 7)});
  family.push_back({"thin-faced sphere", make_thin_faced_sphere(3, 7)});
  family.push_back({"genus 3", make_genus3(3)});
  family.push_back({"two components", make_two_components()});
  return family;
}

}  // namespace gvd::test

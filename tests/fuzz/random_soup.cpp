#include "fuzz/random_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace gvd::test {
namespace {

constexpr double kFullTurn = 6.283185307179586;

Vec3 inside_cube(Random& random) {
  const double x = random.real(-1, 1), y = random.real(-1, 1), z = random.real(-1, 1);
  return {x, y, z};
}

Vec3 on_circle(int i, int n) { return {std::cos(kFullTurn * i / n), std::sin(kFullTurn * i / n), 0}; }

double power_of_ten(Random& random, double low, double high) { return std::pow(10, random.real(low, high)); }

/// Two triangles of the quadrilateral a b c d, along either diagonal.
void add_square(RandomSoup& soup, std::array<int, 4> corners, bool other_diagonal) {
  const auto [a, b, c, d] = corners;
  if (other_diagonal) {
    soup.polygons.insert(soup.polygons.end(), {{a, b, d}, {b, c, d}});
  } else {
    soup.polygons.insert(soup.polygons.end(), {{a, b, c}, {a, c, d}});
  }
}

/// The diagonals of a grid's squares: all in one direction, alternating, or all in the other direction.
bool other_diagonal(int pattern, int i, int j) { return pattern == 2 || (pattern == 1 && (i + j) % 2 == 0); }

RandomSoup make_tetrahedron(Random& random) {
  RandomSoup soup{"tetrahedron", {}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  for (int i = 0; i < 4; ++i) soup.positions.push_back(inside_cube(random));
  return soup;
}

RandomSoup make_octahedron(Random&) {
  return {"octahedron",
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// A triangle and its back; a vertex in the middle of each distinguishes them.
RandomSoup make_doubled_triangle(Random& random) {
  const std::array<Vec3, 4> tips{Vec3(0.5, std::sqrt(0.75), 0), Vec3(random.real(0, 1), random.real(0.1, 1), 0),
                                 Vec3(0, 1, 0), Vec3(0.5, power_of_ten(random, -4, -1), 0)};
  RandomSoup soup{"doubled triangle", {{0, 0, 0}, {1, 0, 0}, tips[random.below(4)]}, {}};
  const Vec3 middle = (soup.positions[0] + soup.positions[1] + soup.positions[2]) / 3;
  soup.positions.insert(soup.positions.end(), {middle, middle});
  soup.polygons = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  return soup;
}

/// A tube of squares or triangles; open, closed by polygons, closed by fans, or closed at one end only.
RandomSoup make_prism(Random& random) {
  RandomSoup soup{"prism", {}, {}};
  const int n = 3 + random.below(8), cap = random.below(4);
  const double height = random.below(4) == 0 ? power_of_ten(random, -3, 3) : 1;
  for (const double z : {0.0, height}) {
    for (int i = 0; i < n; ++i) soup.positions.push_back(on_circle(i, n) + Vec3(0, 0, z));
  }
  const bool whole = random.below(2) == 0;
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    if (whole) soup.polygons.push_back({i, j, n + j, n + i});
    if (!whole) add_square(soup, {i, j, n + j, n + i}, false);
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
  }
  if (cap == 0 || cap == 1) soup.polygons.push_back(bottom);
  if (cap == 0) soup.polygons.push_back(top);
  if (cap != 2) return soup;
  soup.positions.insert(soup.positions.end(), {{0, 0, 0}, {0, 0, height}});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    soup.polygons.insert(soup.polygons.end(), {{j, i, 2 * n}, {n + i, n + j, 2 * n + 1}});
  }
  return soup;
}

/// Up to four squares along each edge.
RandomSoup make_cube(Random& random) {
  RandomSoup soup{"cube", {}, {}};
  const int n = 1 + random.below(4), pattern = random.below(3);
  std::map<std::array<int, 3>, int> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [it, is_new] = known.try_emplace(at, static_cast<int>(soup.positions.size()));
    if (is_new) soup.positions.push_back(Vec3(at[0], at[1], at[2]) / n);
    return it->second;
  };
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    for (int k = 0; k < n * n; ++k) {
      const auto corner = [&](int i, int j) {
        std::array<int, 3> at{};
        at[axis] = side % 2 == 0 ? 0 : n;
        at[(axis + 1) % 3] = k / n + i;
        at[(axis + 2) % 3] = k % n + j;
        return vertex(at);
      };
      std::array<int, 4> square{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
      if (side % 2 == 0) std::swap(square[1], square[3]);
      add_square(soup, square, other_diagonal(pattern, k / n, k % n));
    }
  }
  return soup;
}

/// Flat or rough, whole or with holes.
RandomSoup make_grid(Random& random) {
  const int nx = 1 + random.below(9), ny = 1 + random.below(9), pattern = random.below(3);
  const bool holes = random.below(2) == 0;
  constexpr std::array kHeights{0.0, 0.0, 1e-9, 0.3, 3.0};
  const double height = kHeights[random.below(5)];
  RandomSoup soup{fmt::format("grid{} of height {}", holes ? " with holes" : "", height), {}, {}};
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) soup.positions.emplace_back(i, j, height * random.real(-1, 1));
  }
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      if (holes && random.below(8) == 0) continue;
      const int a = i * (ny + 1) + j, b = a + ny + 1;
      add_square(soup, {a, b, b + 1, a + 1}, other_diagonal(pattern, i, j));
    }
  }
  return soup;
}

RandomSoup make_torus(Random& random) {
  RandomSoup soup{"torus", {}, {}};
  const int nx = 3 + random.below(8), ny = 3 + random.below(6), pattern = random.below(3);
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const Vec3 tube = on_circle(j, ny);
      soup.positions.push_back((3 + tube.x()) * on_circle(i, nx) + Vec3(0, 0, tube.y()));
    }
  }
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const int a = i * ny, b = (i + 1) % nx * ny, next = (j + 1) % ny;
      add_square(soup, {a + j, b + j, b + next, a + next}, other_diagonal(pattern, i, j));
    }
  }
  return soup;
}

/// Two cones over one ring, which is narrow (needles) or wide (a flat disc).
RandomSoup make_double_cone(Random& random, double ring, double tip, const char* name) {
  RandomSoup soup{name, {}, {}};
  const int n = 3 + random.below(12);
  for (int i = 0; i < n; ++i) soup.positions.push_back(ring * on_circle(i, n));
  soup.positions.insert(soup.positions.end(), {{0, 0, tip}, {0, 0, -tip}});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    soup.polygons.insert(soup.polygons.end(), {{i, j, n}, {j, i, n + 1}});
  }
  if (random.below(3) == 0) soup.polygons.resize(1 + static_cast<std::size_t>(random.below(2 * n)));
  return soup;
}

RandomSoup make_needles(Random& random) { return make_double_cone(random, power_of_ten(random, -6, -1), 1, "needles"); }

RandomSoup make_disc(Random& random) { return make_double_cone(random, 1, power_of_ten(random, -6, 0), "disc"); }

/// Faces with no or almost no area: the points of the ring are collinear, and sometimes all points are.
RandomSoup make_collinear(Random& random) {
  RandomSoup soup = make_double_cone(random, 1, 1, "collinear points");
  const bool all = random.below(3) == 0;
  for (Vec3& p : soup.positions) {
    p.y() = 0;
    if (all) p.z() = 0;
  }
  return soup;
}

/// Random corners: edges of many faces, duplicate faces, duplicate corners, vertices in no face.
RandomSoup make_random_indices(Random& random) {
  RandomSoup soup{"random indices", {}, {}};
  const int n = 3 + random.below(20), faces = 1 + random.below(25), kind = random.below(3);
  for (int i = 0; i < n; ++i) {
    const int x = random.below(3), y = random.below(3), z = random.below(3);
    soup.positions.push_back(kind == 0 ? inside_cube(random) : Vec3(x, y, kind == 1 ? z : 0));
  }
  for (int f = 0; f < faces; ++f) {
    std::vector<int> polygon(random.below(5) == 0 ? 4 + static_cast<std::size_t>(random.below(3)) : 3);
    for (int& corner : polygon) corner = random.below(n);
    soup.polygons.push_back(polygon);
  }
  return soup;
}

constexpr std::array kShapes{&make_tetrahedron, &make_octahedron,    &make_doubled_triangle,
                             &make_prism,       &make_cube,          &make_grid,
                             &make_torus,       &make_needles,       &make_disc,
                             &make_collinear,   &make_random_indices};

RandomSoup make_shape(Random& random) { return kShapes[random.below(static_cast<int>(kShapes.size()))](random); }

/// Adds a second shape, apart from the first or overlapping it.
void add_another(RandomSoup& soup, Random& random) {
  const RandomSoup other = make_shape(random);
  const int first = static_cast<int>(soup.positions.size());
  const Vec3 shift(4.0 * random.below(2), 0, 0);
  for (const Vec3& p : other.positions) soup.positions.push_back(p + shift);
  for (std::vector<int> polygon : other.polygons) {
    for (int& corner : polygon) corner += first;
    soup.polygons.push_back(polygon);
  }
  soup.name += " and " + other.name;
}

/// Typical defects of files: duplicate, reversed or missing faces.
void damage(RandomSoup& soup, Random& random) {
  if (soup.polygons.empty()) return;
  for (int i = random.below(3); i >= 0; --i) {
    const auto f = static_cast<std::size_t>(random.below(static_cast<int>(soup.polygons.size())));
    switch (random.below(3)) {
      case 0:
        soup.polygons.push_back(soup.polygons[f]);
        break;
      case 1:
        std::reverse(soup.polygons[f].begin(), soup.polygons[f].end());
        break;
      default:
        if (soup.polygons.size() > 1) soup.polygons.erase(soup.polygons.begin() + static_cast<std::ptrdiff_t>(f));
    }
  }
  soup.name += ", damaged";
}

void transform(RandomSoup& soup, Random& random) {
  Vec3 scale(1, 1, 1), shift(0, 0, 0);
  const int kind = random.below(9);
  if (kind == 0) scale *= 1e8;
  if (kind == 1) scale *= 1e-8;
  if (kind == 2) scale *= random.below(2) == 0 ? 1e60 : 1e-60;
  if (kind == 3) scale.y() = power_of_ten(random, -9, -3);
  if (kind == 4) shift = Vec3(1e6, 1e6, -1e6);
  if (kind == 5) shift = Vec3(1e4, 0, 0);
  const double cosine = kind >= 6 ? 1 : 0.8, sine = kind >= 6 ? 0 : 0.6;
  for (Vec3& p : soup.positions) {
    const Vec3 q = p.cwiseProduct(scale);
    p = Vec3(cosine * q.x() - sine * q.y(), sine * q.x() + cosine * q.y(), q.z()) + shift;
  }
  constexpr std::array kNames{
      ", times 1e8", ", times 1e-8", ", times 1e60 or 1e-60", ", squashed", ", far away", ", moved", "", "", ""};
  soup.name += kNames[kind];
}

}  // namespace

RandomSoup make_random_soup(Random& random) {
  RandomSoup soup = make_shape(random);
  if (random.below(8) == 0) add_another(soup, random);
  if (random.below(8) == 0) damage(soup, random);
  transform(soup, random);
  return soup;
}

std::string write_obj(const RandomSoup& soup) {
  std::string text;
  for (const Vec3& p : soup.positions) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (const std::vector<int>& polygon : soup.polygons) {
    text += 'f';
    for (const int corner : polygon) text += fmt::format(" {}", corner + 1);
    text += '\n';
  }
  return text;
}

}  // namespace gvd::test

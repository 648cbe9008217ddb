// Written files are read back by OpenMesh, an independent reader.
#if defined(__GNUC__) && !defined(__clang__)
// OpenMesh's vectors begin uninitialised; the warning comes where its templates are instantiated, at the end of this
// file.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include "gvd/diagram.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "io/fixture.hpp"
#include "io/writers/format_writers.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_read_back {

using namespace test;

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Peer = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

Peer read_peer(const std::filesystem::path& path, bool with_colors) {
  Peer peer;
  peer.request_face_colors();
  OpenMesh::IO::Options options;
  if (with_colors) options += OpenMesh::IO::Options::FaceColor;
  REQUIRE(OpenMesh::IO::read_mesh(peer, path.string(), options));
  return peer;
}

std::array<Vec3, 3> corners(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

std::array<Vec3, 3> corners(const Peer& peer, int f) {
  std::array<Vec3, 3> result;
  std::size_t i = 0;
  for (const auto v : peer.fv_range(peer.face_handle(static_cast<unsigned>(f)))) {
    const OpenMesh::Vec3d& p = peer.point(v);
    result.at(i++) = Vec3(p[0], p[1], p[2]);
  }
  return result;
}

/// The largest difference of a coordinate, over the three rotations of the corners.
double difference(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  double least = 1e300;
  for (std::size_t shift = 0; shift < 3; ++shift) {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, (a[i] - b[(i + shift) % 3]).cwiseAbs().maxCoeff());
    least = std::min(least, largest);
  }
  return least;
}

/// `order[i]` is the face of `mesh` that the file has as face i.
void check_same(const Mesh& mesh, const Peer& peer, const std::vector<FaceId>& order, double tolerance) {
  REQUIRE(peer.n_faces() == order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    CHECK(difference(corners(mesh, order[i]), corners(peer, static_cast<int>(i))) <= tolerance);
  }
}

/// OpenMesh reads every coordinate through a float.
double tolerance(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return std::numeric_limits<float>::epsilon() * largest;
}

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> order;
  for (int f = 0; f < mesh.face_count(); ++f) order.push_back(FaceId(f));
  return order;
}

TEST_CASE("OpenMesh reads back every plain format") {
  const TemporaryFolder folder;
  for (const auto& [name, mesh] : small_family()) {
    INFO(name);
    for (const char* file : {"a.ply", "a.off", "a.obj"}) {
      INFO(file);
      write_mesh(folder / file, LabelledMesh{mesh});
      const Peer peer = read_peer(folder / file, false);
      CHECK(peer.n_vertices() == mesh.positions().size());
      check_same(mesh, peer, all_faces(mesh), tolerance(mesh));
    }
    write_mesh(folder / "a.stl", LabelledMesh{mesh});
    check_same(mesh, read_peer(folder / "a.stl", false), all_faces(mesh), tolerance(mesh));
  }
}

TEST_CASE("OpenMesh reads back labelled files") {
  const Labelled labelled;
  const TemporaryFolder folder;
  write_mesh(folder / "a.ply", labelled.view());
  check_same(labelled.mesh, read_peer(folder / "a.ply", false), all_faces(labelled.mesh), tolerance(labelled.mesh));
  write_mesh(folder / "a.off", labelled.view());
  check_same(labelled.mesh, read_peer(folder / "a.off", true), all_faces(labelled.mesh), tolerance(labelled.mesh));
  write_mesh(folder / "a.stl", labelled.view());
  CHECK(read_peer(folder / "a.stl", false).n_faces() == labelled.face_label.size());

  write_mesh(folder / "a.obj", labelled.view());
  std::vector<FaceId> order = all_faces(labelled.mesh);
  std::stable_sort(order.begin(), order.end(), [&](FaceId a, FaceId b) {
    const auto rank = [&](FaceId f) { return static_cast<std::uint32_t>(labelled.face_label[f].value()); };
    return rank(a) < rank(b);
  });
  check_same(labelled.mesh, read_peer(folder / "a.obj", false), order, tolerance(labelled.mesh));
}

TEST_CASE("VTP reads back with the same bits, without the points of bisectors") {
  for (const auto& [name, mesh] : small_family()) {
    for (const bool with_diagram : {false, true}) {
      INFO(name << " " << with_diagram);
      const Diagram diagram = compute_diagram(
          mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(mesh.vertex_count() - 1))});
      LabelledMesh written{mesh};
      if (with_diagram) written.diagram = &diagram;
      std::ostringstream out;
      write_mesh(out, written, MeshFormat::vtp);
      const CheckedMesh back = build_mesh(parse_soup(out.str(), MeshFormat::vtp, "file"), DefectPolicy::error);
      REQUIRE(back.mesh.vertex_count() == mesh.vertex_count());
      REQUIRE(back.mesh.face_count() == mesh.face_count());
      for (const VertexId v : mesh.vertices()) CHECK(back.mesh.position(v) == mesh.position(v));
      for (const FaceId f : mesh.faces()) CHECK(back.mesh.vertices(f) == mesh.vertices(f));
    }
  }
}

TEST_CASE("GLB reads back with the same faces, in their order") {
  for (const auto& [name, mesh] : small_family()) {
    INFO(name);
    IdVector<FaceId, GeneratorId> label(mesh.face_count());
    for (const FaceId f : mesh.faces()) label[f] = GeneratorId(f.value() % 5 - 1);
    LabelledMesh written{mesh};
    written.face_label = &label;
    std::ostringstream out;
    write_mesh(out, written, MeshFormat::glb);
    const PolygonSoup soup = parse_soup(out.str(), MeshFormat::glb, "file");
    REQUIRE(soup.polygon_count() == std::size_t(mesh.face_count()));
    std::map<std::array<double, 3>, VertexId> vertex_at;
    for (const VertexId v : mesh.vertices()) {
      const Vec3 p = mesh.position(v).cast<float>().cast<double>();
      REQUIRE(vertex_at.emplace(std::array{p.x() + 0, p.y() + 0, p.z() + 0}, v).second);
    }
    for (const FaceId f : mesh.faces()) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = soup.positions[soup.polygon(f.index())[k]];
        const auto found = vertex_at.find({p.x() + 0, p.y() + 0, p.z() + 0});
        REQUIRE(found != vertex_at.end());
        CHECK(found->second == mesh.vertices(f)[k]);
      }
    }
    const MeshSummary back = compute_mesh_summary(build_mesh(soup).mesh), wanted = compute_mesh_summary(mesh);
    CHECK(back.vertices == wanted.vertices);
    CHECK(back.euler_characteristic == wanted.euler_characteristic);
    CHECK(back.boundary_loops == wanted.boundary_loops);
  }
}

TEST_CASE("OpenMesh finds the regions' colours in COFF and in an OBJ's materials") {
  const Labelled labelled;
  const TemporaryFolder folder;
  for (const char* file : {"a.off", "a.obj"}) {
    INFO(file);
    const bool is_off = std::string_view(file) == "a.off";
    write_mesh(folder / file, labelled.view());
    if (is_off) write_bytes(folder / file, to_bytes(labelled.view(), MeshFormat::coff));
    std::array<int, 4> seen{};
    const Peer peer = read_peer(folder / file, true);
    for (const auto f : peer.faces()) {
      const OpenMesh::Vec3uc c = OpenMesh::color_cast<OpenMesh::Vec3uc>(peer.color(f));
      for (int label = -1; label < 3; ++label) {
        const Rgb color = color_in(labelled.view(), GeneratorId(label));
        // The .mtl has linear colours of four digits, and OpenMesh truncates them.
        const std::array<double, 3> wanted =
            is_off ? std::array{color.red / 255.0, color.green / 255.0, color.blue / 255.0} : io::to_linear(color);
        const auto close = [&](std::size_t i) { return std::abs(c[i] - 255 * wanted[i]) <= 1; };
        seen[label + 1] += close(0) && close(1) && close(2);
      }
    }
    CHECK(seen == std::array<int, 4>{6, 6, 6, 6});
  }
}

}  // namespace gvd::test_read_back

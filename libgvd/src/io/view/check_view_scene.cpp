// Check of a scene before a page is made of it: sizes of arrays, ranges of values.
//
// The page runs in a browser, where a wrong index shows as a hole and a label above 2^24 as a wrong colour. So whatever
// does not fit is refused here, with the element. Codes and lattice points travel through 32-bit floats, which set the
// limits below.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "gvd/error.hpp"
#include "io/view/view_steps.hpp"

namespace gvd::io {
namespace {

/// Largest label that the page can tell apart: codes travel through 32-bit floats, which are exact below 2^24.
constexpr std::int32_t kLargestLabel = (1 << 24) - 3;

/// The largest number of lattice points: their numbers travel through 32-bit floats, too.
constexpr std::int64_t kMostLatticePoints = 1 << 24;

[[noreturn]] void refuse(const std::string& message, std::int64_t element = -1) {
  throw Error(ErrorCode::precondition, message, element);
}

void check_size(std::string_view what, std::int32_t size, std::int32_t wanted) {
  if (size == 0 || size == wanted) return;
  refuse(fmt::format("the view has {} {} where there are {} elements; give one for each, or none", size, what, wanted));
}

void check_labels(const ViewScene& scene) {
  const auto check = [&](GeneratorId label, std::int64_t face) {
    const bool known = scene.cells.empty() || label.value() < scene.cells.count();
    if (known && label.value() <= kLargestLabel) return;
    refuse(fmt::format("face {} of the view has label {}, which has no cell; give a cell for each label", face,
                       label.value()),
           face);
  };
  for (const FaceId f : scene.face_label.ids()) check(scene.face_label[f], f.value());
  for (const FacePiece& piece : scene.pieces) check(piece.generator, piece.face.value());
}

void check_pieces(const ViewScene& scene) {
  for (const FacePiece& piece : scene.pieces) {
    if (!piece.face.valid() || piece.face.value() >= scene.mesh->face_count()) {
      refuse(fmt::format("a piece of the view lies in face {}, which the mesh does not have", piece.face.value()),
             piece.face.value());
    }
    for (const auto& corner : piece.corners) {
      if (std::isfinite(corner[0]) && std::isfinite(corner[1]) && std::isfinite(corner[2])) continue;
      refuse(fmt::format("a piece of face {} of the view has a corner that is not finite", piece.face.value()),
             piece.face.value());
    }
  }
}

void check_finite(std::string_view what, const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) refuse(fmt::format("{} {} of the view is not finite", what, i), std::int64_t(i));
  }
}

void check_distances(const std::vector<double>& distances) {
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::isfinite(distances[i]) && distances[i] >= 0) continue;
    refuse(fmt::format("distance {} of the view from another surface is not a positive number", i), std::int64_t(i));
  }
}

void check_surface_distance(const ViewScene& scene) {
  const Mesh& mesh = *scene.mesh;
  const DistanceSamples& samples = scene.surface_distance->samples;
  if (!scene.pieces.empty()) refuse("the view has distances of cut faces from another surface; give whole faces");
  if (samples.at_vertex.count() != mesh.vertex_count() || samples.steps.count() != mesh.face_count()) {
    refuse("the view has distances from another surface that are not of its mesh; give one for each vertex and face");
  }
  std::int64_t size = 0;
  for (const std::int32_t k : samples.steps) {
    if (k < 1 || k > DistanceSamples::kMaxSteps) refuse(fmt::format("a face of the view is cut into {} steps", k));
    size += DistanceSamples::lattice_size(k);
  }
  if (size != std::ssize(samples.lattice)) {
    refuse(fmt::format("the view has {} distances on lattices of {} points", samples.lattice.size(), size));
  }
  if (size > kMostLatticePoints) {
    refuse(fmt::format("the view has more than {} points on lattices", kMostLatticePoints));
  }
  check_distances(samples.at_vertex.raw());
  check_distances(samples.lattice);
  for (const double length : {scene.surface_distance->reference, scene.surface_distance->scale_end}) {
    if (!std::isfinite(length) || length <= 0) refuse("the scale of distances of the view must be a positive length");
  }
}

}  // namespace

void check_view_scene(const ViewScene& scene) {
  if (scene.mesh == nullptr || scene.mesh->face_count() == 0) {
    refuse("a scene of the view has no faces; give each a mesh");
  }
  check_size("face labels", scene.face_label.count(), scene.mesh->face_count());
  check_size("vertex distances", scene.vertex_distance.count(), scene.mesh->vertex_count());
  check_size("cell energies", scene.cell_energy.count(), scene.cells.count());
  check_size("generators of vertices", int(scene.vertex_generators.size()), scene.mesh->vertex_count());
  if (scene.surface_distance) check_surface_distance(scene);
  if (scene.overlay && (scene.overlay->mesh == nullptr || scene.overlay->mesh->face_count() == 0)) {
    refuse("an overlay of the view has no faces; give it a mesh");
  }
  check_pieces(scene);
  check_labels(scene);
  check_finite("generator", scene.generators);
  check_finite("added generator", scene.added_generators);
  check_finite("branch point", scene.branch_points);
  for (const std::vector<Vec3>& polyline : scene.bisectors) check_finite("bisector point", polyline);
}

}  // namespace gvd::io

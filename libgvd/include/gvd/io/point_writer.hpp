#pragma once

#include <ostream>
#include <string_view>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The file formats of points on a surface.
enum class PointFormat { ply, xyz, npy };
inline const Choices<PointFormat> kPointFormatNames{
    {"ply", PointFormat::ply}, {"xyz", PointFormat::xyz}, {"npy", PointFormat::npy}};

/// A generator, with the area of its cell and an integral over it.
struct SurfaceSample {
  SurfacePoint point;
  double area = 0;    ///< square mesh units
  double energy = 0;  ///< integral of the squared distance, mesh units to the fourth
};

/// Writes samples in their order, each with its position, the unit normal of the surface there (see
/// surface_point.hpp), its face, its barycentric coordinates, and area and energy of its cell.
///
/// PLY: binary, with the properties of docs/guide/lloyd.md. XYZ: text, with one line of position and normal per sample.
/// NPY: a little-endian array of doubles of the shape (samples, 12), with the columns x y z nx ny nz face b0 b1 b2 area
/// energy. Numbers have enough digits to read back as the same doubles. The stream is flushed and checked.
/// Throws Error{unwritable_output} if the stream fails. Cost: O(samples).
void write_points(std::ostream& out, const Mesh& mesh, const std::vector<SurfaceSample>& samples, PointFormat format);

}  // namespace gvd

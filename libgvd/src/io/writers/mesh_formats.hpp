#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

// One writer per format, each in a file of its name. The arrays' lengths are checked by then.

void write_ply(std::ostream& out, const LabelledMesh& mesh);
/// `material_library` is the .mtl's file name; empty for none.
void write_obj(std::ostream& out, const LabelledMesh& mesh, const std::string& material_library);
void write_off(std::ostream& out, const LabelledMesh& mesh);
void write_stl(std::ostream& out, const LabelledMesh& mesh);
void write_vtp(std::ostream& out, const LabelledMesh& mesh);
void write_glb(std::ostream& out, const LabelledMesh& mesh);

/// The faces of one region.
struct Region {
  GeneratorId label;
  std::vector<FaceId> faces;  ///< ascending
};

/// The regions that own a face, by label; what has none comes last. One region without labels.
std::vector<Region> collect_regions(const LabelledMesh& mesh);

/// Name of a region in the files that name things.
std::string region_name(GeneratorId label);

/// A bisector as a line in space.
struct BisectorLine {
  GeneratorId left;
  GeneratorId right;
  std::vector<Vec3> points;  ///< two or more; a closed one repeats its first point
  std::vector<double>
      distance;  ///< at each point, linear between the vertices of its face; infinity where none reaches
};

/// Every bisector of the diagram, if there is one, in the diagram's order; those of a single point are left out.
std::vector<BisectorLine> collect_bisector_lines(const LabelledMesh& mesh);

/// Throws Error{unwritable_output} where a coordinate is too large for a 32-bit float, or the mesh too small.
void check_single_precision(const Mesh& mesh, const char* format);

}  // namespace gvd::io

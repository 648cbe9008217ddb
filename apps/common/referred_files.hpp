#pragma once

#include "common/run.hpp"
#include "gvd/appearance.hpp"

// The files that inputs refer to: buffers and images of a glTF, descriptions of materials of an OBJ. They may be the
// only copies, as the input itself.
namespace gvd::app {

/// Throws Error{invalid_option} where an output of the run would replace a file that INPUT refers to. Materials of an
/// OBJ need not be there yet; for those that an .obj gets see `check_material_files`.
/// Cost: that of reading a glTF's description again, where an output is there already.
void check_referred_files(const Options& options, const Appearance& input);

/// The same for all runs of a call before the first one: where an output of any run would replace a file that any of
/// the inputs refers to. What does not exist or can't be read is left to its own run. Whether the materials of an .obj
/// replace those of its own input, too: see `check_material_files`.
/// Cost: O(bytes) of each OBJ, glTF and packed file, and O(log n) for each file that is written or referred to.
void check_referred_files(const std::vector<Options>& runs);

/// Throws Error{invalid_option} where the materials of the regions in an .obj would replace those that INPUT names.
/// `drops_materials`: those of the faces are not written, as by --region-materials.
void check_material_files(Run& run, const Appearance& appearance, bool drops_materials = false);

/// Notes that an OBJ at `path`, in another folder than INPUT, names files beside INPUT.
void note_material_files(Run& run, const std::string& path, const Appearance& appearance);

}  // namespace gvd::app

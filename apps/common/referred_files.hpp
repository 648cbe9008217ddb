#pragma once

#include "common/run.hpp"
#include "gvd/appearance.hpp"

// Protects the files to which inputs refer: buffers and images of a glTF, and files of materials of an OBJ. Like the
// input itself, they may be the only copies.
namespace gvd::app {

/// Throws Error{invalid_option} if an output of the run would replace a file to which INPUT refers. An OBJ's file of
/// materials need not exist yet; `check_material_files` checks the materials of an .obj that is written. Cost: reading
/// a glTF's description again if an output already exists.
void check_referred_files(const Options& options, const Appearance& input);

/// Checks all runs of a call before the first one: throws if an output of any run would replace a file to which any
/// input refers. Inputs that do not exist or can't be read are left to their own run, and so is the question whether
/// the materials of an .obj replace the materials of its own input (see `check_material_files`). Cost: O(bytes) for
/// each OBJ, glTF and packed file, and O(log n) for each file that is written or referred to.
void check_referred_files(const std::vector<Options>& runs);

/// Throws Error{invalid_option} if the regions' materials of an .obj would replace a file of materials that INPUT
/// names. `drops_materials`: whether the materials of faces are not written, as with --region-materials.
void check_material_files(Run& run, const Appearance& appearance, bool drops_materials = false);

/// Notes that an OBJ at `path`, in another folder than INPUT, refers to files beside INPUT.
void note_material_files(Run& run, const std::string& path, const Appearance& appearance);

}  // namespace gvd::app

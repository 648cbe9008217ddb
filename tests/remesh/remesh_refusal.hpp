#pragma once

#include <vector>

#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "support/catch.hpp"

namespace gvd::test {

/// The error of a remesh that finds no mesh. `given`: generators, or their diagram.
template <class Given = std::vector<SurfacePoint>>
Error remesh_refusal(const Mesh& mesh, const Given& given, const RemeshOptions& options = {}) {
  try {
    remesh(mesh, given, options);
  } catch (const Error& error) {
    return error;
  }
  FAIL("no error");
  return {ErrorCode::precondition, ""};
}

}  // namespace gvd::test

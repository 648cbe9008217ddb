// The release, which the build system alone knows: CMakeLists.txt names it once.

#include "gvd/version.hpp"

namespace gvd {

std::string_view version() { return GVD_VERSION; }

}  // namespace gvd

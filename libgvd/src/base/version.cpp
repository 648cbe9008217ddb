// The release of the library. CMakeLists.txt has the number, and passes it on as GVD_VERSION.

#include "gvd/version.hpp"

namespace gvd {

std::string_view version() { return GVD_VERSION; }

}  // namespace gvd

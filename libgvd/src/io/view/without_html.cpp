// Replaces blobs_html.cpp with GVD_WITH_XML=OFF, when there is no zlib. Such a build has no viewer either.
#include "gvd/error.hpp"
#include "io/view/view_blobs.hpp"

namespace gvd::io {

std::string ViewBlobs::html() const {
  throw Error(ErrorCode::invalid_option, "can't make an HTML page: built without zlib");
}

}  // namespace gvd::io

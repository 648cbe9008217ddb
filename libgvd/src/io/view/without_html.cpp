// The stand-in for the page, which GVD_WITH_XML=OFF leaves out for want of zlib. There is no viewer either then.
#include "gvd/error.hpp"
#include "io/view/view_blobs.hpp"

namespace gvd::io {

std::string ViewBlobs::html() const {
  throw Error(ErrorCode::invalid_option, "can't make an HTML page: built without zlib");
}

}  // namespace gvd::io

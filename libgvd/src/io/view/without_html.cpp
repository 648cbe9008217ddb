// What GVD_WITH_XML=OFF leaves out for want of zlib: the page. There is no viewer either then.
#include "gvd/error.hpp"
#include "io/view/view_blobs.hpp"

namespace gvd::io {

std::string ViewBlobs::html() const {
  throw Error(ErrorCode::invalid_option, "can't make an HTML page: built without zlib");
}

}  // namespace gvd::io

// Describes the options of a segmentation.

#include "gvd/segment_options.hpp"

namespace gvd {

void describe(OptionList& list, SegmentOptions& options) {
  list.option("labels", choice(options.labels, kFaceLabelNames),
              {.help = "How to label whole faces on a bisector",
               .more = ": for borders as short as its faces allow, or by the largest share"});
}

}  // namespace gvd

#pragma once

#include "comparison/report/drawing/figures.h"

namespace fretval {

/// The contact from above at the end of the last cycle of a contact on rings and angles: edges of the contact and of
/// both zones that stick, and the traction on the body as arrows. Of the files zones.csv and surface.csv of a case.
Figure plane_figure(const StoredResult& result);

}  // namespace fretval

// What an earlier run has kept of unsaved changes (viewer/recovery.hpp) comes back into the window.
#pragma once

namespace sphereview {

struct Recovery;
struct ViewerState;

// Makes the kept scene the document, with changes that are not saved. Where it is of a frame of a file that is as it was, it is of
// that frame again, with the other frames beside it.
void recover(ViewerState& state, const Recovery& recovery);

// Asks about each, the latest first; says on standard error what cannot be offered.
void offer_recovery(ViewerState& state);

}  // namespace sphereview

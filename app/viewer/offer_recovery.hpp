// Brings unsaved changes that an earlier run kept (viewer/recovery.hpp) back into the window.
#pragma once

namespace sphereview {

struct Recovery;
struct ViewerState;

// Makes the kept scene the document, with unsaved changes. A kept frame of an unchanged file becomes that frame again, with the
// other frames beside it.
void recover(ViewerState& state, const Recovery& recovery);

// Asks about each recovery, the latest first. Says on standard error which cannot be offered.
void offer_recovery(ViewerState& state);

}  // namespace sphereview

// Where the file browser goes and what it takes, apart from how it looks.
#pragma once

#include <filesystem>

#include "panels/dialog_parts.hpp"

namespace sphereview {

// Goes to a folder if it can be read; else stays, and says why.
bool enter(FileBrowser& browser, const std::filesystem::path& folder);

// The first listing, or another after the owner set `folder`: of the nearest folder above that can be read.
void enter_nearest(FileBrowser& browser);

// The button, Enter or a double click: goes where the path box says if something new stands there, or into a folder that
// was named; else this is the file.
Decision confirm(FileBrowser& browser, Dialogs& dialogs);

}  // namespace sphereview

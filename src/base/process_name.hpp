// Telling whether what another process left behind is still its own.
#pragma once

#include <string>

namespace sphereview {

// Names this process, of letters, digits and '-'. On Linux no later process has the same name; elsewhere one may, when the
// system gives a process's number again.
std::string process_name();

// Whether the process of that name still runs; false for what is no name.
bool process_runs(const std::string& name);

}  // namespace sphereview

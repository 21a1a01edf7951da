// Unsaved edits that survive the end of the program, in the platform's folder for such things.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

struct Recovery {
    std::string file;      // a native scene, to be read as any other
    std::string original;  // the file that was being edited, absolute; "" for an untitled scene
    std::chrono::system_clock::time_point time;
};

// Keeps the scene for a later run, whole or not at all, instead of what this process kept before. False when that cannot be
// done; for emergencies, so it throws nothing.
bool write_recovery(const Scene& scene, const std::string& original) noexcept;

// What processes that no longer run have kept, the newest first.
std::vector<Recovery> list_recoveries();

// False when the file is still there afterwards.
bool remove_recovery(const std::string& file) noexcept;

// Forgets what this process has kept: its edits were saved after all.
bool remove_own_recovery() noexcept;

}  // namespace sphereview

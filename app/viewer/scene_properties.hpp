// The properties in the scene's file. They are read with small scenes, and when they are asked for with large ones.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sphereview {

struct LoadedScene;
struct ViewerState;

inline constexpr std::size_t most_spheres_with_properties = 100'000;

// Notes the properties of the file whose scene has become the document.
void note_properties(ViewerState& state, const LoadedScene& loaded);

// Whether the file has properties that the scene lacks.
bool has_unread_properties(const ViewerState& state);

// Reads the file's properties beside the loop and gives them to the scene, unless the file has changed. If spheres were added,
// deleted or reordered, those get values that are where the file has them. Does nothing if all are read, or while a file is read or
// written. Properties that cannot be read count as missing.
void request_properties(ViewerState& state);

// The properties that the status bar tells of the sphere under the pointer: those of the list's filter and of the colours.
std::vector<std::string> told_properties(const ViewerState& state);

}  // namespace sphereview

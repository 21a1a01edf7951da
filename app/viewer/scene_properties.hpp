// What a file holds of each sphere besides place, size and colour: of small scenes it is read with them, of others when it is asked
// for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sphereview {

struct LoadedScene;
struct ViewerState;

inline constexpr std::size_t most_spheres_with_properties = 100'000;

// Notes what a file has, whose scene is now the document's.
void note_properties(ViewerState& state, const LoadedScene& loaded);

// Whether the file has some that the scene has not.
bool has_unread_properties(const ViewerState& state);

// Reads the file again beside the loop, and gives its properties to the scene, unless the file has
// changed meanwhile. Where spheres have come, gone or changed places, those get values that are where the file has them. Does
// nothing where all are read, or while something is read or written. Where they cannot be read, they count as not there.
void request_properties(ViewerState& state);

// The names of those whose values the status bar tells of the sphere under the pointer: what the list is filtered by, and
// what the spheres are coloured by.
std::vector<std::string> told_properties(const ViewerState& state);

}  // namespace sphereview

// A camera that sees everything. Made of + - * / and square roots alone, which IEEE 754 defines to the bit, and of sines and
// cosines of our own: C libraries differ in theirs by a bit, and then the exact picture of a data file would differ too.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "base/sine_cosine.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Which way a camera looks: three perpendicular directions of length 1. The default is the default camera's.
struct ViewAxes {
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 ahead{0.0, 0.0, 1.0};  // into the picture
};

// The front of data of other programs: their coordinates are right-handed, so with x to the right and y up their z comes out of the
// picture. Seen as scenes are, a molecule would be its own mirror image.
inline constexpr ViewAxes data_axes{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};

// From an eye at `azimuth` and `elevation`, in degrees: at 0, 0 (the front) it stands on the side of -z and looks along +z, as the
// default camera does; azimuth takes it round y, 90 to the side of +x; elevation, from -90 to 90, lifts it towards +y.
ViewAxes axes_from(double azimuth, double elevation);

// From the direction (1, 1, -1), which sees all three axes equally long.
ViewAxes isometric_axes();

// The way a camera without a fault looks; a mirrored one's axes are mirrored.
ViewAxes axes_of(const Camera& camera);

// The view, with z turned round where `present` is mirrored and the view is not, or the other way about: so going from one to the
// other never shows a mirror image.
ViewAxes with_hand_of(const ViewAxes& present, const ViewAxes& view);

// How a view is written, for messages and help; and what may stand there where a scene's saved views are meant as well.
inline constexpr std::string_view view_syntax = "front, back, left, right, top, bottom, iso or AZIMUTH,ELEVATION in degrees";
inline constexpr std::string_view any_view_syntax =
    "front, back, left, right, top, bottom, iso, AZIMUTH,ELEVATION in degrees or a saved view's name";

// Reads what view_syntax says: a finite azimuth, an elevation from -90 to 90. Nothing for anything else.
std::optional<ViewAxes> parse_view(std::string_view text);

// The nearest eye that looks this way, with the default camera's angle of view, and has every sphere that is not hidden wholly
// within 31/32 of the screen's square: at two opposite sides something touches that. It does not depend on a picture's size, since
// every picture shows the whole screen. Nothing if there is nothing to see. Never a faulty camera: radii so small that doubles
// cannot place an eye accordingly count as larger, and an eye beyond the largest double stays there. Orthographic: the smallest
// screen that shows all that, and an eye before everything, also when it turns about the middle.
std::optional<Camera> fitted(const Scene& scene, const ViewAxes& axes, Projection projection = Projection::perspective);

// The few spheres by which fitted() moves the camera: a scene of those of several scenes is fitted as one with all their spheres
// is, within rounding. The same ones on every machine. None of a scene that has nothing to see.
std::vector<Sphere> outermost(const Scene& scene, const ViewAxes& axes, Projection projection = Projection::perspective);

}  // namespace sphereview

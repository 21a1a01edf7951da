// A camera that sees everything. Uses + - * / and square roots alone, which IEEE 754 defines to the bit, and our own sines and
// cosines: C libraries differ in theirs by a bit, which would change the exact picture of a data file.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "base/sine_cosine.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The direction of a view: three perpendicular directions of length 1. The default is the default camera's.
struct ViewAxes {
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 ahead{0.0, 0.0, 1.0};  // into the picture
};

// The front of other programs' data. Its coordinates are right-handed: with x to the right and y up, z comes out of the picture.
// With the axes of scenes a molecule would be its own mirror image.
inline constexpr ViewAxes data_axes{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};

// The view from an eye at `azimuth` and `elevation` in degrees: at 0, 0 (the front) the eye is on the side of -z and looks along
// +z, as the default camera does. Azimuth moves it round y, 90 to the side of +x; elevation, -90 to 90, moves it towards +y.
ViewAxes axes_from(double azimuth, double elevation);

// The view from the direction (1, 1, -1), in which all three axes are equally long.
ViewAxes isometric_axes();

// The axes of a camera without a fault; mirrored for a mirrored camera.
ViewAxes axes_of(const Camera& camera);

// `view`, with z reversed if only one of `present` and `view` is mirrored: going from one to the other never shows a mirror image.
ViewAxes with_hand_of(const ViewAxes& present, const ViewAxes& view);

// The syntax of a view for messages and help, without and with a scene's saved views.
inline constexpr std::string_view view_syntax = "front, back, left, right, top, bottom, iso or AZIMUTH,ELEVATION in degrees";
inline constexpr std::string_view any_view_syntax =
    "front, back, left, right, top, bottom, iso, AZIMUTH,ELEVATION in degrees or a saved view's name";

// Reads a text of view_syntax: a finite azimuth, an elevation from -90 to 90. Nothing for another text.
std::optional<ViewAxes> parse_view(std::string_view text);

// The nearest eye in this direction, with the default camera's angle of view, that sees every shown sphere within 31/32 of the
// screen's square; spheres touch two opposite sides of that. Does not depend on a picture's size, since every picture shows the
// whole screen. Nothing if there is nothing to see. Never faulty: radii too small for doubles to place an eye count as larger, and
// an eye beyond the largest double stays there. Orthographic: the smallest screen that shows all, and an eye before everything,
// also when it turns about the middle.
std::optional<Camera> fitted(const Scene& scene, const ViewAxes& axes, Projection projection = Projection::perspective);

// The few spheres that determine fitted(): the outermost ones of several scenes together have the fit of all their spheres, within
// rounding. The same spheres on every machine; none if there is nothing to see.
std::vector<Sphere> outermost(const Scene& scene, const ViewAxes& axes, Projection projection = Projection::perspective);

}  // namespace sphereview

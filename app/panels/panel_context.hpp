// What panels are given and what they give back. Panels change nothing themselves.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/text.hpp"
#include "camera/navigation.hpp"
#include "edit/document.hpp"
#include "edit/selection.hpp"
#include "panels/commands.hpp"

namespace sphereview {

// What a panel asks for.
struct EditScene {
    Edit edit;
    std::string name;           // of the step, for the menu
    std::uint64_t gesture = 0;  // edits of one drag have the same; 0: a step of its own
    bool is_look = false;       // colours or sizes by a property, of nearly all spheres
};
struct SelectSpheres {
    Selection selection;
    bool shows_row = false;  // the list scrolls to the primary sphere: it was chosen elsewhere
};
struct RunCommand {
    CommandId command = CommandId::help;
};
struct OpenFile {
    std::string path;
};
struct ShowFrame {
    std::int64_t frame = 0;  // of the scene's file
};
struct MeasureSphere {
    std::uint32_t number = 0;
};
// The view flies there.
struct ShowView {
    Camera camera;
};
// Reads the properties of the scene's file, unless they are read already.
struct RequestProperties {};
// What to do with the pixels of the pixel inspector.
enum class InspectorWish { pin, unpin, compare, copy, copy_second };
// Pins a pixel of a picture of that size in the inspector.
struct PinPixel {
    Pixel pixel;
    PictureSize size;
};
using Action = std::variant<EditScene, SelectSpheres, RunCommand, OpenFile, ShowFrame, MeasureSphere, ShowView, RequestProperties,
                            InspectorWish, PinPixel>;

// Where a redraw drew its widgets, by name, in screen coordinates. Tests aim the mouse at these.
struct WidgetRectangle {
    float left = 0.0F;
    float top = 0.0F;
    float right = 0.0F;
    float bottom = 0.0F;
};
using WidgetRectangles = std::map<std::string, WidgetRectangle>;

// A part of the window, in ImGui's coordinates.
struct Rectangle {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;
};

struct PanelContext {
    const Document& document;
    const Selection& selection;
    const SceneBounds& bounds;               // the scene's; constant during a drag, whose speed depends on them
    std::span<const CommandInfo> commands;   // as they are now, in the order of the menus
    float scale = 1.0F;                      // of sizes that are not text
    std::uint64_t& gesture;                  // the number of the current drag; whoever begins one adds 1
    std::optional<std::uint32_t>& hovered;   // the sphere under the pointer, in the picture or in the list
    std::vector<Action>& actions;            // what is to be done after all panels are drawn, in order
    WidgetRectangles* rectangles = nullptr;  // collected when not null
    std::int64_t frame = 0;                  // number of the frame that is shown, of `frames` in the scene's file
    std::int64_t frames = 1;
    Light light{};      // the picture's: the scene's, or what the command line asks for instead
    CameraAxes view{};  // of the view
    Camera camera{};    // the view's; when the rays are seen from beside, that of the drawn eye
    // All properties that the file has. The scene holds those that were read (RequestProperties).
    std::span<const std::string> property_names{};
};

// Note a rectangle, or the one of ImGui's last widget or current window, where `rectangles` are collected.
void note_rectangle(const PanelContext& context, const std::string& name, ImVec2 low, ImVec2 size);
void note_widget(const PanelContext& context, const std::string& name);
void note_window(const PanelContext& context, const std::string& name);

// Whether the scene has a sphere of that number. A number may come from the picture of an earlier scene.
inline bool has_sphere(const Scene& scene, std::int64_t number) { return number >= 0 && number < std::ssize(scene.spheres); }
// A sphere's name; "" where it has none.
std::string name_of(const Scene& scene, std::uint32_t number);
// A sphere in words, "sphere 3" or "sphere 3 'sun'"; several spheres: "1,234 spheres".
std::string title_of(const Scene& scene, std::int64_t number);
std::string title_of(const Scene& scene, const std::vector<std::uint32_t>& numbers);

// Hides the spheres if any of them is shown, else shows them.
EditScene hide_or_show(const Scene& scene, const std::vector<std::uint32_t>& numbers);

// Text from outside, made safe for ImGui, as one line or with its own lines, and shorter than the 16,000 characters that ImGui can
// draw.
inline constexpr std::size_t most_shown = 2000;
inline std::string shown_text(std::string_view text) { return on_one_line(composed(text), most_shown); }
inline std::string shown_lines(std::string_view text) { return on_lines(composed(text), most_shown); }

// `text` as a label: ImGui would show nothing behind a "##" in it.
std::string as_label(std::string_view text);

}  // namespace sphereview

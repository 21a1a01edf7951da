// The scene's light: a ball that shows what it does, on which the sun can be dragged.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "camera/fit.hpp"
#include "panels/number_field.hpp"
#include "panels/side_panel.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"
#include "shade/brightness.hpp"

namespace sphereview {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

// Suns behind the ball are in a ring around it, this much wider than the ball.
constexpr float outer_radius = 1.45F;

// Angles are shown without what turning a direction into them adds: an exponent of ten.
constexpr int last_degree = -6;

// How a sun is called that nobody has placed yet: from the upper right, in the view's directions.
constexpr glm::dvec3 first_sun{0.55, 0.6, 0.58};

constexpr std::array<int, 7> usual_lights = {16, 32, 64, 128, 256, 512, 1024};

ImU32 grey(double brightness) {
    const auto byte = static_cast<int>(std::lround(255.0 * std::clamp(brightness, 0.0, 1.0)));
    return IM_COL32(byte, byte, byte, 255);
}

// Short numbers, for files that people read.
glm::dvec3 rounded(const glm::dvec3& direction) {
    constexpr int last_decimal = -4;
    return {rounded_to(direction.x, last_decimal) + 0.0, rounded_to(direction.y, last_decimal) + 0.0,
            rounded_to(direction.z, last_decimal) + 0.0};
}

class LightPanel {
public:
    LightPanel(const PanelContext& context, SidePanelState& state) : context_(context), state_(state), light_(context.light) {}

    void draw() {
        if (light_.sun) state_.last_sun = light_.sun;
        draw_mode();
        const float height = 4.0F * ImGui::GetFrameHeightWithSpacing() - ImGui::GetStyle().ItemSpacing.y;
        draw_ball(height);
        ImGui::SameLine();
        ImGui::BeginGroup();
        draw_sun();
        ImGui::EndGroup();
        double sky = sky_of(light_);
        if (part("sky", "How strong the sky is, and the key light in it", sky, most_sky)) {
            if (light_.sun) light_.sun->strength = sun_strength_of(light_);  // which would depend on whether the sky is said
            light_.sky = sky;
            change("Change the sky", gesture_);
        }
        if (part("key", "How much brighter the sky is around the key light, above left of the view", light_.key, most_key)) {
            change("Change the key light", gesture_);
        }
        draw_lights();
    }

private:
    // Only one shading shows light.
    void draw_mode() {
        constexpr auto studio =
            static_cast<CommandId>(static_cast<int>(CommandId::first_shading) + static_cast<int>(Shading::studio));
        if (info_of(context_.commands, studio).checked) return;
        dim_text("The shading Studio shows the light.");
        draw_command_buttons(context_, {{studio, "Show it", "studio"}});
    }

    void change(const std::string& name, std::uint64_t gesture) {
        context_.actions.emplace_back(EditScene{ChangeLight{light_}, name, gesture});
    }

    glm::dvec3 in_scene(const glm::dvec3& in_view) const {
        const CameraAxes& view = context_.view;
        return in_view.x * view.right + in_view.y * view.up - in_view.z * view.ahead;
    }
    // To the right, up and toward the person.
    glm::dvec3 in_view(const glm::dvec3& in_scene) const {
        const CameraAxes& view = context_.view;
        return {dot(in_scene, view.right), dot(in_scene, view.up), -dot(in_scene, view.ahead)};
    }

    // Where a direction is on the ball, in radii from its middle; and what is there.
    static ImVec2 place_of(const glm::dvec3& direction) {
        const double across = square_root(direction.x * direction.x + direction.y * direction.y);
        if (direction.z >= 0.0) return {static_cast<float>(direction.x), static_cast<float>(-direction.y)};
        // Straight behind, the ring's outer edge: anywhere on it.
        const double angle = std::atan2(-direction.z, across) * degrees;
        const double radius = 1.0 + (static_cast<double>(outer_radius) - 1.0) * angle / 90.0;
        const double x = across > 0.0 ? direction.x / across : 0.0;
        const double y = across > 0.0 ? direction.y / across : 1.0;
        return {static_cast<float>(radius * x), static_cast<float>(-radius * y)};
    }
    static glm::dvec3 direction_at(ImVec2 place) {
        const auto x = static_cast<double>(place.x);
        const auto y = -static_cast<double>(place.y);
        const double radius = square_root(x * x + y * y);
        if (radius <= 1.0) return {x, y, square_root(1.0 - radius * radius)};
        const double part = std::min((radius - 1.0) / (static_cast<double>(outer_radius) - 1.0), 1.0);
        const double angle = 90.0 * part / degrees;
        return {std::cos(angle) * x / radius, std::cos(angle) * y / radius, -std::sin(angle)};
    }

    void draw_ball(float side) {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        ImGui::InvisibleButton("##sun ball", {side, side});
        note_widget(context_, "sun ball");
        const ImVec2 middle{low.x + 0.5F * side, low.y + 0.5F * side};
        const float radius = 0.5F * side / outer_radius;
        const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
        if (hovered && !ImGui::IsItemActive()) {
            // Beside the panel: the ball stays in sight.
            ImGui::SetNextWindowPos({low.x - ImGui::GetStyle().WindowPadding.x, low.y}, ImGuiCond_Always, {1.0F, 0.0F});
            ImGui::SetTooltip("Drag the sun to where it shines from;\nin the ring around the ball, from behind.");
        }
        if (ImGui::IsItemActivated()) {
            ++context_.gesture;
            state_.sun_drag = {.light = context_.light, .last_sun = state_.last_sun, .cancelled = false};
        }
        if (ImGui::IsItemActive() && key_pressed(ImGuiKey_Escape)) state_.sun_drag.cancelled = true;
        if (ImGui::IsItemActive() && state_.sun_drag.cancelled) {
            light_ = state_.sun_drag.light;
            state_.last_sun = state_.sun_drag.last_sun;
            if (light_ != context_.light) change("Move the sun", context_.gesture);
        } else if (ImGui::IsItemActive()) {
            const ImVec2 mouse = ImGui::GetIO().MousePos;
            const glm::dvec3 direction = direction_at({(mouse.x - middle.x) / radius, (mouse.y - middle.y) / radius});
            if (!light_.sun) switch_on(rounded(in_scene(direction)));
            light_.sun->direction = rounded(in_scene(direction));
            if (light_ != context_.light) change("Move the sun", context_.gesture);
        }
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        draw.AddCircleFilled(middle, outer_radius * radius,
                             ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), 64);
        fill_ball(draw, middle, radius);
        if (!light_.sun) return;
        const glm::dvec3 sun = in_view(unit(light_.sun->direction));
        const ImVec2 at = place_of(sun);
        const ImVec2 handle{middle.x + radius * at.x, middle.y + radius * at.y};
        const float size = 5.0F * context_.scale;
        const ImU32 yellow = sun.z >= 0.0 ? IM_COL32(255, 214, 92, 255) : IM_COL32(166, 132, 50, 255);
        draw.AddCircleFilled(handle, size + 1.5F * context_.scale, IM_COL32(20, 20, 22, 255), 24);
        draw.AddCircleFilled(handle, size, yellow, 24);
    }

    // As the window shades a grey sphere that moves: docs/shading.md.
    double brightness(const glm::dvec3& normal) const {
        constexpr double own = 0.85;
        double e = brightness_of_free_sky(light_, normal);
        if (light_.sun) e += sun_strength_of(light_) * std::max(dot(normal, in_view(unit(light_.sun->direction))), 0.0);
        return own * std::min(shown_part(e), 1.0);
    }

    // Rings of triangles, each corner in its own brightness.
    void fill_ball(ImDrawList& draw, ImVec2 middle, float radius) const {
        constexpr int rings = 12;
        constexpr int corners = 48;
        const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
        draw.PrimReserve(6 * rings * corners, (rings + 1) * corners);
        const auto first = static_cast<unsigned>(draw._VtxCurrentIdx);
        for (int ring = 0; ring <= rings; ++ring) {
            // Denser near the rim, where the brightness changes fastest.
            const double r = std::sin(0.5 * std::numbers::pi * ring / rings);
            for (int corner = 0; corner < corners; ++corner) {
                const double angle = 2.0 * std::numbers::pi * corner / corners;
                const glm::dvec3 normal{r * std::cos(angle), r * std::sin(angle), square_root(std::max(1.0 - r * r, 0.0))};
                draw.PrimWriteVtx(
                    {middle.x + radius * static_cast<float>(normal.x), middle.y - radius * static_cast<float>(normal.y)}, white,
                    grey(brightness(normal)));
            }
        }
        for (unsigned ring = 0; ring < rings; ++ring) {
            for (unsigned corner = 0; corner < corners; ++corner) {
                const unsigned a = first + ring * corners + corner;
                const unsigned b = first + ring * corners + (corner + 1) % corners;
                for (const unsigned vertex : {a, b, b + corners, a, b + corners, a + corners}) {
                    draw.PrimWriteIdx(static_cast<ImDrawIdx>(vertex));
                }
            }
        }
        // The triangles' edge is not smooth; a line over it is.
        draw.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_WindowBg), 64, 1.5F * context_.scale);
    }

    void draw_sun() {
        begin_field(context_, "sun");
        bool on = light_.sun.has_value();
        if (draw_checkbox(context_, "##sun", on, "sun")) {
            if (on) {
                switch_on(state_.last_sun ? state_.last_sun->direction : rounded(in_scene(unit(first_sun))));
            } else {
                light_.sun.reset();
            }
            change(on ? "Switch the sun on" : "Switch the sun off", 0);
        }
        ImGui::BeginDisabled(!light_.sun);
        Sun sun = light_.sun.value_or(state_.last_sun.value_or(Sun{rounded(in_scene(unit(first_sun)))}));
        const glm::dvec3 direction = unit(sun.direction);
        // As --view has them: where data is seen right-handed, z points the other way.
        const double ahead = camera_axes(context_.document.scene().camera).mirrored ? -1.0 : 1.0;
        double azimuth = rounded_to(std::atan2(direction.x, -ahead * direction.z) * degrees, last_degree) + 0.0;
        double elevation = rounded_to(std::asin(std::clamp(direction.y, -1.0, 1.0)) * degrees, last_degree);
        const bool turned = number("azimuth", {.usual_size = 100.0, .unit = degree_sign}, azimuth);
        const bool raised = number("elevation", {.low = -90.0, .high = 90.0, .usual_size = 50.0, .unit = degree_sign}, elevation);
        if (turned || raised) {
            const glm::dvec3 view = axes_from(azimuth, elevation).ahead;
            sun.direction = {-view.x, -view.y, -ahead * view.z};
            set_sun(sun, "Move the sun");
        }
        Light with_sun = light_;
        with_sun.sun = sun;
        double strength = sun_strength_of(with_sun);
        if (number("strength", {.low = weakest_sun, .high = strongest_sun, .usual_size = 0.5}, strength)) {
            sun.strength = strength;
            set_sun(sun, "Change the sun");
        }
        ImGui::EndDisabled();
    }

    // As strong as it was last.
    void switch_on(const glm::dvec3& direction) {
        light_.sun = Sun{direction, state_.last_sun ? state_.last_sun->strength : std::nullopt};
    }

    void set_sun(const Sun& sun, const std::string& name) {
        light_.sun = sun;
        change(name, gesture_);
    }

    bool part(const char* name, const char* help, double& value, double most) {
        return number(name, {.low = 0.0, .high = most, .usual_size = 0.5, .help = help}, value);
    }

    bool number(const char* name, const NumberRule& rule, double& value) {
        const NumberChange changed = draw_number_line(context_, state_.numbers, name, rule, value);
        gesture_ = changed == NumberChange::dragged ? context_.gesture : 0;
        return changed != NumberChange::none;
    }

    void draw_lights() {
        begin_field(context_, "lights");
        std::vector<std::string> words = {"automatic"};
        for (const int lights : usual_lights) words.push_back(std::to_string(lights));
        const std::string now = light_.lights ? std::to_string(*light_.lights) : words.front();
        if (std::ranges::find(words, now) == words.end()) words.push_back(now);
        const auto present = static_cast<std::size_t>(std::ranges::find(words, now) - words.begin());
        const auto chosen = draw_choice(context_, "lights", words, present, "How many directions the light of the sky comes from");
        if (!chosen) return;
        light_.lights = *chosen == 0 ? std::nullopt : std::optional(usual_lights.at(*chosen - 1));
        change("Change the number of lights", 0);
    }

    const PanelContext& context_;
    SidePanelState& state_;
    Light light_;                // with all that changed in this redraw
    std::uint64_t gesture_ = 0;  // of the latest change of a number
};

}  // namespace

void draw_light_panel(const PanelContext& context, SidePanelState& state) { LightPanel(context, state).draw(); }

}  // namespace sphereview

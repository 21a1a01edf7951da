// The inspector's drawings: the plane through the ray, and the ray's quadratics as curves; and the part of a panel that shows them,
// in their own coordinates.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel_context.hpp"
#include "panels/ray_section.hpp"

namespace sphereview {

ImU32 faded(const ImVec4& color, float opacity);
// The theme's colour of text, for drawings.
ImU32 text_color(float opacity);
// A sphere's own colour, made brighter, or darker in the light theme, where it would not be visible on the panel.
ImVec4 line_color(const Scene& scene, std::int32_t number);

// The importance of a text in a drawing: less important texts are left out where there is no room.
enum class Importance { most, more, some, least };

// A part of a panel that shows a rectangle of a plane.
class Canvas {
public:
    // As wide as the panel. `name`: the widget's.
    Canvas(const PanelContext& context, const char* name, float height_by_width, const SectionWindow& window);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    ImVec2 low() const { return low_; }
    ImVec2 high() const { return {low_.x + size_.x, low_.y + size_.y}; }
    float scale() const { return scale_; }
    bool hovered() const { return hovered_; }
    bool clicked() const { return clicked_; }
    const SectionWindow& window() const { return window_; }

    // Places far outside are moved near enough for floats to draw straight lines.
    ImVec2 at(const glm::dvec2& place) const;
    glm::dvec2 place_of(ImVec2 point) const;
    // The length of `count` pixels in the plane's units.
    double pixels(float count) const { return static_cast<double>(count * scale_ / size_.x) * (window_.high.x - window_.low.x); }

    void line(const glm::dvec2& from, const glm::dvec2& to, ImU32 color, float thickness) const;
    void dashes(const glm::dvec2& from, const glm::dvec2& to, ImU32 color, float thickness) const;
    void curve(const std::vector<glm::dvec2>& points, ImU32 color, float thickness, bool dashed = false) const;
    void fill(const std::vector<glm::dvec2>& points, ImU32 color) const;
    void point(const glm::dvec2& place, float radius, ImU32 color, bool filled);
    // Keeps a disc, such as a point, free of texts. Noted as "NAME mark 0" and so on.
    void keep_free(ImVec2 middle, float radius);
    // Notes a text, which is drawn above all else when the drawing is complete. `across`, `down`: the part of the text that lies at
    // the place: 0 its left or upper edge, 1 its right or lower edge.
    void text(ImVec2 place, float across, float down, const std::string& words, ImU32 color, Importance importance);
    void cross(const glm::dvec2& place, float reach, ImU32 color, float thickness) const;
    ImDrawList& list() const { return *list_; }

private:
    std::vector<ImVec2> places_of(const std::vector<glm::dvec2>& points) const;

    struct Text {
        ImVec2 place;
        float across;
        float down;
        std::string words;  // in glyphs
        ImU32 color;
        Importance importance;
    };
    // Draws the texts, the most important first: inside, clear of marks and of earlier texts, beside its place; a text without room
    // is left out. Noted as "NAME text WORDS".
    void draw_texts();

    struct Box {
        ImVec2 low;
        ImVec2 high;

        bool overlaps(const Box& other) const {
            return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
        }
    };

    const PanelContext& context_;
    std::string name_;
    std::vector<Text> texts_;
    std::vector<Box> taken_;  // by marks and then by texts
    SectionWindow window_;
    float scale_;
    ImVec2 low_;
    ImVec2 size_{};
    ImDrawList* list_ = nullptr;
    bool hovered_ = false;
    bool clicked_ = false;
};

// The colours of a discriminant above 0, at 0 and below.
ImVec4 color_of_sign(int sign);

// Each is as wide as the window. The mouse over a sphere shows its numbers. Returns the sphere that was clicked. `name`: the
// widget's.
std::optional<std::int32_t> draw_ray_section(const PanelContext& context, const char* name, const SectionSubject& of,
                                             std::optional<std::int32_t> subject);
std::optional<std::int32_t> draw_quadratic_plot(const PanelContext& context, const char* name, const PixelExplanation& explanation,
                                                std::int32_t subject);

// Shows the numbers of a drawing's sphere. `behind`: the words for a sphere there, "behind the eye".
void show_numbers(const Scene& scene, const PixelExplanation& explanation, std::int32_t number, const std::string& behind);

}  // namespace sphereview

#include "panels/inspector.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "panels/math_text.hpp"
#include "panels/ray_drawings.hpp"
#include "panels/widgets.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// A number rounded to what matters, unless its words say what no double can.
std::string short_of(double value, const std::string& words, int digits = digits_that_matter) {
    return words.starts_with('(') ? words : number_text(value, digits);
}

std::string place_in_words(const InspectedPlace& place) {
    return "Pixel " + std::to_string(place.pixel.x) + ", " + std::to_string(place.pixel.y) + " of " +
           std::to_string(place.size.width) + " × " + std::to_string(place.size.height);
}

class Inspector {
public:
    Inspector(const PanelContext& context, const Inspection& inspection, InspectorState& state)
        : context_(context), inspection_(inspection), state_(state), scene_(context.document.scene()) {}

    void draw() {
        draw_head();
        ImGui::BeginChild("inspected");
        if (!inspection_.first) {
            draw_dim_words("Point at the picture to see the arithmetic of a pixel. A click pins the pixel.");
        } else {
            if (inspection_.second) draw_comparison();
            const bool second = inspection_.second && state_.second_in_detail;
            draw_pixel(second ? *inspection_.second : *inspection_.first);
        }
        ImGui::EndChild();
    }

private:
    void ask(InspectorWish wish) { context_.actions.emplace_back(wish); }

    void draw_head() {
        const float side = ImGui::GetFrameHeight();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("Pixel inspector");
        ImGui::SameLine(std::max(ImGui::GetContentRegionAvail().x - side + ImGui::GetCursorPosX(), width_of("Pixel inspector")));
        if (draw_button(context_, "x##inspector", "close inspector", "", true, {side, side}))
            context_.actions.emplace_back(RunCommand{CommandId::toggle_inspector});
        if (!inspection_.first) return;
        if (!inspection_.pinned) {
            draw_dim_words("Follows the pointer. A click, or Space, pins the pixel.");
        } else if (inspection_.second_is_next) {
            draw_colored_words("Click the pixel to compare with.", color_of_sign(0));
        } else {
            draw_dim_words("Pinned: Escape lets it go.");
        }
        if (draw_button(
                context_, inspection_.pinned ? "Unpin" : "Pin", "unpin",
                inspection_.pinned ? "Lets the pixel go (Escape)" : "Holds this pixel (Space, or a click in the picture)")) {
            ask(inspection_.pinned ? InspectorWish::unpin : InspectorWish::pin);
        }
        same_line_for("Compare");
        if (draw_button(context_, "Compare", "compare pixels", "The next click pins a second pixel beside this one (Shift+click)",
                        inspection_.pinned)) {
            ask(InspectorWish::compare);
        }
        same_line_for("Copy as text");
        if (draw_button(context_, "Copy as text", "copy explanation", "Puts the words of `sphereview explain` on the clipboard")) {
            ask(state_.second_in_detail && inspection_.second ? InspectorWish::copy_second : InspectorWish::copy);
        }
    }

    std::string seen_in_words(const InspectedPixel& pixel) const {
        const std::int32_t number = pixel.explanation.visible();
        return has_sphere(scene_, number) ? title_of(scene_, number) : "the background";
    }

    void draw_comparison() {
        const InspectedPixel& one = *inspection_.first;
        const InspectedPixel& other = *inspection_.second;
        ImGui::Spacing();
        if (ImGui::BeginTable("compared", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_PadOuterX)) {
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, width_of(in_glyphs("b² − 4ac")));
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
            const auto row = [](const char* name, const std::string& a, const std::string& b, const std::string& all_a = "",
                                const std::string& all_b = "") {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                draw_dim_words(name);
                ImGui::TableNextColumn();
                draw_words(a, all_a);
                ImGui::TableNextColumn();
                draw_words(b, all_b);
            };
            const auto pixel = [](const InspectedPixel& p) {
                return std::to_string(p.place.pixel.x) + ", " + std::to_string(p.place.pixel.y);
            };
            row("pixel", "1: " + pixel(one), "2: " + pixel(other));
            row("D", vector_text(one.explanation.direction, 4), vector_text(other.explanation.direction, 4),
                vector_in_words(one.explanation.direction), vector_in_words(other.explanation.direction));
            row("shows", seen_in_words(one), seen_in_words(other));
            const ExplainedHit* a = one.explanation.hits.empty() ? nullptr : &one.explanation.hits.front();
            const ExplainedHit* b = other.explanation.hits.empty() ? nullptr : &other.explanation.hits.front();
            const auto number = [&](const char* name, double ExplainedHit::*member) {
                const auto text = [&](const ExplainedHit* hit, bool all) {
                    if (hit == nullptr) return std::string("—");
                    return all ? shortest(hit->*member) : number_text(hit->*member);
                };
                row(name, text(a, false), text(b, false), text(a, true), text(b, true));
            };
            if (a != nullptr || b != nullptr) {
                number("a", &ExplainedHit::a);
                number("b", &ExplainedHit::b);
                number("c", &ExplainedHit::c);
                number("b² − 4ac", &ExplainedHit::discriminant);
                number("t", &ExplainedHit::t);
                const auto normal = [](const ExplainedHit* hit) {
                    return hit == nullptr ? std::string("—") : vector_text(hit->normal, 3);
                };
                row("normal", normal(a), normal(b));
            }
            ImGui::EndTable();
        }
        note_widget(context_, "compared");
        ImGui::TextUnformatted("In detail:");
        for (const bool second : {false, true}) {
            ImGui::SameLine();
            if (ImGui::RadioButton(second ? "pixel 2" : "pixel 1", state_.second_in_detail == second))
                state_.second_in_detail = second;
            note_widget(context_, second ? "detail 2" : "detail 1");
        }
    }

    void draw_pixel(const InspectedPixel& pixel) {
        const PixelExplanation& e = pixel.explanation;
        ImGui::Spacing();
        draw_words(place_in_words(pixel.place));
        const std::string seen = "shows " + seen_in_words(pixel);
        same_line_for(seen.c_str());
        draw_dim_words(seen);
        draw_drawings(pixel);
        draw_ray(e);
        if (e.hits.empty()) {
            ImGui::Separator();
            draw_words("No hit: the pixel shows the background, " + to_string(scene_.background) + ".");
        }
        std::size_t shown = 0;
        for (const ExplainedHit& hit : e.hits) {
            if (!has_sphere(scene_, hit.number)) continue;  // the explanation may be of the scene of the last redraw
            if (shown == most_hits_explained) break;
            draw_hit(hit, shown == 0);
            if (shown == 0) draw_light(pixel);
            ++shown;
        }
        const std::uint64_t all_hits = e.hits.size() + static_cast<std::uint64_t>(e.farther);
        if (all_hits > shown) {
            ImGui::Separator();
            draw_dim_words("and " + in_groups(all_hits - shown) + " more hits, farther away");
        }
        for (const SphereOnLine& passed : e.passed) {
            if (has_sphere(scene_, passed.number)) draw_passed(passed, behind_in_words(e));
        }
        if (!pixel.place.with_passed) draw_dim_words("Pin the pixel (Space) to see what its ray just misses in so large a scene.");
        ImGui::Separator();
        draw_rest(e);
        draw_dim_words(std::string("Decided: ") + level_in_words(e.level) + ".");
    }

    void draw_drawings(const InspectedPixel& pixel) {
        const PixelExplanation& e = pixel.explanation;
        const SectionSubject of{scene_,
                                pixel.place.camera,
                                pixel.place.size,
                                pixel.place.pixel,
                                e,
                                pixel.light ? std::optional(pixel.light->direction) : std::nullopt,
                                pixel.light ? pixel.light->blocker : std::nullopt,
                                true,
                                kind_of(pixel)};
        if (state_.subject && !is_explained(e, *state_.subject)) state_.subject.reset();
        const std::int32_t subject = state_.subject.value_or(first_explained(e));
        const auto choose = [&](std::optional<std::int32_t> clicked) {
            if (clicked && is_explained(e, *clicked)) state_.subject = clicked;
        };
        choose(draw_ray_section(context_, "ray drawing", of, subject));
        if (!has_sphere(scene_, subject)) return;
        draw_dim_words("The plane through the ray and the centre C of " + title_of(scene_, subject) +
                       (std::ssize(e.hits) + std::ssize(e.passed) > 1 ? "; click another sphere to cut through it." : "."));
        choose(draw_quadratic_plot(context_, "quadratic drawing", e, subject));
        draw_dim_words("a t² + b t + c over t. Below the axis it has two zeros: the ray goes in and comes out.");
    }

    void draw_ray(const PixelExplanation& e) {
        ImGui::Separator();
        const bool parallel = e.projection == Projection::orthographic;
        draw_words("P = O + t D");
        draw_words("O = " + vector_text(e.origin) + (parallel ? "  the pixel's place in the plane of the eye" : "  the eye"),
                   origin_in_words(e));
        draw_words("D = " + vector_text(e.direction) + (parallel ? "  the same for all pixels" : "  through the pixel's centre"),
                   direction_in_words(e));
        ImGui::Spacing();
        draw_dim_words("‖P − C‖² = r², with P = O + t D:");
        draw_words("D·D t² + 2 D·(O − C) t + (O − C)·(O − C) − r² = 0");
        draw_dim_words("t₁, t₂ = (−b ∓ √(b² − 4ac)) / 2a");
    }

    void draw_title(std::int32_t number, const std::string& widget, const char* word, const ImVec4& color) {
        ImGui::Separator();
        const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(number)];
        draw_swatch(context_, sphere.color);
        ImGui::SameLine();
        ImGui::TextUnformatted(title_of(scene_, number).c_str());
        note_widget(context_, widget);
        if (ImGui::IsItemClicked()) state_.subject = number;
        if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        explain_item("Click: the drawings are about this sphere.");
        if (word != nullptr) {
            ImGui::SameLine();
            ImGui::TextColored(color, "%s", word);
        }
        draw_dim_words("C = " + vector_text(sphere.center) + ", r = " + number_text(sphere.radius));
    }

    void draw_coefficients(const std::string& a, const std::string& b, const std::string& c, const auto& numbers) {
        draw_words("a = D·D = " + short_of(numbers.a, a), "a = " + a);
        draw_words("b = 2 D·(O − C) = " + short_of(numbers.b, b), "b = " + b);
        draw_words("c = (O − C)·(O − C) − r² = " + short_of(numbers.c, c), "c = " + c);
    }

    void draw_hit(const ExplainedHit& hit, bool seen) {
        draw_title(hit.number, "hit " + std::to_string(hit.number), seen ? "seen" : nullptr, color_of_sign(1));
        const HitInWords words = in_words(hit);
        draw_coefficients(words.a, words.b, words.c, hit);
        draw_colored_words("b² − 4ac = " + short_of(hit.discriminant, words.discriminant) + "  " + words.roots,
                           color_of_sign(hit.discriminant_sign), "discriminant = " + words.discriminant);
        const int digits = digits_to_tell(hit.t1, hit.t2);
        draw_words("t₁ = " + short_of(hit.t1, words.t1, digits), "t₁ = " + words.t1);
        draw_words("t₂ = " + short_of(hit.t2, words.t2, digits), "t₂ = " + words.t2);
        draw_dim_words(typeset(why(hit)));
        draw_words("t = " + short_of(hit.t, words.t, digits), "t = " + words.t);
        draw_words("P = O + t D = " + vector_text(hit.point), "point = " + words.point);
        draw_words("n = (P − C) / r = " + vector_text(hit.normal), "normal = " + words.normal);
        if (hit.as_near_as_last) {
            draw_colored_words("exactly as near as the sphere before it, which comes first in the file", color_of_sign(0));
        }
    }

    static const char* kind_of(const InspectedPixel& pixel) { return pixel.light && !pixel.light->is_sun() ? "light" : "sun"; }

    void draw_light_section(const InspectedPixel& pixel, const InspectedLight& light) {
        const auto shadow = shadow_ray(scene_, pixel.explanation, light.direction, light.blocker);
        if (!shadow) return;
        draw_ray_section(context_, "light drawing",
                         {scene_, pixel.place.camera, pixel.place.size, pixel.place.pixel, *shadow, {}, {}, false, kind_of(pixel)},
                         {});
        draw_dim_words("The ray from the point P to the " + std::string(kind_of(pixel)) +
                       (light.blocker && has_sphere(scene_, *light.blocker)
                            ? ": " + title_of(scene_, *light.blocker) + " is in the way."
                            : std::string(".")));
    }

    // The ray from the point to the sun or to a light of the sky.
    void draw_light(const InspectedPixel& pixel) {
        if (pixel.light) {
            const InspectedLight& light = *pixel.light;
            draw_light_section(pixel, light);
            const std::string name = light.is_sun() ? "sun" : "light " + std::to_string(light.number);
            draw_words(name + ": L = " + vector_text(light.direction), vector_in_words(light.direction));
            note_widget(context_, "light ray");
            if (!light.is_sun()) draw_dim_words("of the sky's lights the nearest to the key light");
            draw_colored_words((light.is_sun() ? "The sun " : "It ") + typeset(light.why) + ".",
                               color_of_sign(light.shines ? 1 : -1));
        }
        if (!pixel.sky.empty()) draw_words("sky: " + typeset(pixel.sky) + ".");
        if (pixel.color) draw_color(*pixel.color);
    }

    // From the sum of the lights to the colour, to be checked by hand.
    void draw_color(const ColorExplanation& color) {
        const LightVector& b = color.sum;
        draw_words("B = " + vector_text(in_units(b)) + ", the sum of the lights that shine",
                   "B = (" + std::to_string(b.x) + ", " + std::to_string(b.y) + ", " + std::to_string(b.z) + ") / 2^28");
        note_widget(context_, "light sum");
        const std::vector<std::string> in_full = in_words(color, 17);
        const std::vector<std::string> lines = in_words(color, digits_that_matter);
        for (std::size_t i = 0; i < lines.size(); ++i) draw_words(typeset(lines[i]), in_full[i]);
        draw_swatch(context_, color.own);
        ImGui::SameLine();
        draw_words("→");
        ImGui::SameLine();
        draw_swatch(context_, color.shown);
        note_widget(context_, "lit colour");
    }

    void draw_passed(const SphereOnLine& passed, const char* behind) {
        const bool missed = passed.discriminant_sign < 0;
        draw_title(passed.number, "passed " + std::to_string(passed.number), missed ? "missed" : behind, color_of_sign(-1));
        draw_coefficients(shortest(passed.a), shortest(passed.b), shortest(passed.c), passed);
        const std::string discriminant = number_text(passed.discriminant);
        if (missed) {
            draw_colored_words("b² − 4ac = " + discriminant + "  < 0: no root", color_of_sign(-1),
                               "discriminant = " + shortest(passed.discriminant));
            // The square of the line's distance from the centre is r^2 - discriminant / (4 a).
            const double r = scene_.spheres[static_cast<std::size_t>(passed.number)].radius;
            const double distance = std::sqrt(r * r - passed.discriminant / (4.0 * passed.a));
            draw_dim_words("the ray passes the centre at a distance of " + number_text(distance, digits_to_tell(distance, r)) +
                           " > r");
        } else {
            draw_words("b² − 4ac = " + discriminant, "discriminant = " + shortest(passed.discriminant));
            draw_words("t₁ = " + number_text(passed.t1) + ", t₂ = " + number_text(passed.t2),
                       "t₁ = " + shortest(passed.t1) + "\nt₂ = " + shortest(passed.t2));
            draw_dim_words("no root is positive: the ray begins beyond the sphere");
        }
    }

    void draw_rest(const PixelExplanation& e) {
        const auto count = [](std::int64_t spheres) { return in_groups(static_cast<std::uint64_t>(spheres)); };
        const std::string behind = behind_in_words(e);
        if (e.elsewhere > 0) {
            // Some were not tried: which of them pass by and which lie behind is not known, whatever those above do.
            draw_words("in all " + count(e.missed + e.elsewhere + e.behind) + " not hit: missed, or " + behind);
        } else {
            if (e.missed > 0) draw_colored_words(count(e.missed) + " missed: discriminant < 0", color_of_sign(-1));
            if (e.behind > 0) draw_words(count(e.behind) + " " + behind + ": no positive root");
        }
        if (e.hidden > 0) draw_dim_words(count(e.hidden) + " hidden");
    }

    const PanelContext& context_;
    const Inspection& inspection_;
    InspectorState& state_;
    const Scene& scene_;
};

}  // namespace

void draw_inspector(const PanelContext& context, const Inspection& inspection, InspectorState& state) {
    Inspector(context, inspection, state).draw();
}

}  // namespace sphereview

#include "panels/timeline.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

// What stands on a button, about its middle, so large.
struct IconPlace {
    ImVec2 middle;
    float size;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {middle.x + x * size, middle.y + y * size}; }
};

void draw_arrow_head(const IconPlace& icon, ImVec2 tip, ImVec2 along) {
    constexpr float length = 0.4F;
    const ImVec2 back{tip.x - length * along.x, tip.y - length * along.y};
    const ImVec2 side{-length * 0.75F * along.y, length * 0.75F * along.x};
    ImGui::GetWindowDrawList()->AddTriangleFilled(icon.at(tip.x, tip.y), icon.at(back.x + side.x, back.y + side.y),
                                                  icon.at(back.x - side.x, back.y - side.y), icon.color);
}

// Its tip and its back stand at such places across, in sizes from the middle.
void draw_triangle(const IconPlace& icon, float tip, float back) {
    ImGui::GetWindowDrawList()->AddTriangleFilled(icon.at(tip, 0.0F), icon.at(back, 0.5F), icon.at(back, -0.5F), icon.color);
}

// Upright, from such a place across to another.
void draw_bar(const IconPlace& icon, float left, float right) {
    ImGui::GetWindowDrawList()->AddRectFilled(icon.at(left, -0.5F), icon.at(right, 0.5F), icon.color);
}

// What comes behind the last frame.
void draw_repeat(const IconPlace& icon, Repeat repeat) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float line = 0.13F * icon.size;
    if (repeat == Repeat::loop) {
        constexpr float end = 1.6F * std::numbers::pi_v<float>;
        constexpr float radius = 0.42F;
        draw.PathArcTo(icon.middle, radius * icon.size, 0.0F, end, 24);
        draw.PathStroke(icon.color, 0, line);
        const ImVec2 to{std::cos(end), std::sin(end)};
        draw_arrow_head(icon, {radius * to.x - 0.16F * to.y, radius * to.y + 0.16F * to.x}, {-to.y, to.x});
        return;
    }
    draw.AddLine(icon.at(-0.5F, 0.0F), icon.at(0.4F, 0.0F), icon.color, line);
    draw_arrow_head(icon, {0.55F, 0.0F}, {1.0F, 0.0F});
    if (repeat == Repeat::back_and_forth) {
        draw_arrow_head(icon, {-0.55F, 0.0F}, {-1.0F, 0.0F});
    } else {
        draw_bar(icon, 0.58F, 0.72F);
    }
}

// What stands behind the frame's number.
std::string frames_text(const PanelContext& context, const TimelineFacts& facts) {
    return "of 0.." + in_groups(static_cast<std::uint64_t>(context.frames - 1)) + (facts.counting ? "+" : "");
}

std::string words_of(EditsReach reach) {
    return reach == EditsReach::none ? "" : reach == EditsReach::all_frames ? "changes: all frames" : "changes: this frame";
}

class Timeline {
public:
    Timeline(const PanelContext& context, const TimelineFacts& facts, PlayChoices& choices)
        : context_(context), facts_(facts), choices_(choices) {}

    void draw() {
        choose_what_fits();
        left_ = ImGui::GetCursorScreenPos();
        command(shows_ends_, CommandId::first_frame, "first frame", [](const IconPlace& icon) {
            draw_triangle(icon, -0.32F, 0.45F);
            draw_bar(icon, -0.45F, -0.3F);
        });
        command(shows_steps_, CommandId::previous_frame, "previous frame", [](const IconPlace& icon) {
            draw_triangle(icon, -0.15F, 0.45F);
            draw_bar(icon, -0.37F, -0.22F);
        });
        command(true, CommandId::play, "play", [this](const IconPlace& icon) {
            const IconPlace large{icon.middle, 1.25F * icon.size, icon.color};
            if (facts_.playing) {
                draw_bar(large, -0.38F, -0.12F);
                draw_bar(large, 0.12F, 0.38F);
            } else {
                draw_triangle(large, 0.5F, -0.35F);
            }
        });
        command(shows_steps_, CommandId::next_frame, "next frame", [](const IconPlace& icon) {
            draw_triangle(icon, 0.15F, -0.45F);
            draw_bar(icon, 0.22F, 0.37F);
        });
        command(shows_ends_, CommandId::last_frame, "last frame", [](const IconPlace& icon) {
            draw_triangle(icon, 0.32F, -0.45F);
            draw_bar(icon, 0.3F, 0.45F);
        });
        left_.x += gap();
        draw_line();
        draw_number();
        if (shows_time_) draw_time();
        if (shows_mark_ && !shows_reach_) draw_reach_mark();
        if (shows_reach_) draw_reach();
        if (shows_repeat_) draw_repeat_button();
        if (shows_speed_) draw_speed();
    }

    float least_width() const { return shortest_line() + button() + number_width() + mark_width() + 4.0F * gap(); }

private:
    float button() const { return std::round(1.1F * ImGui::GetFrameHeight()); }
    float gap() const { return 8.0F * context_.scale; }
    // Where the file has no times, nothing is as recorded.
    PlaySpeed speed() const { return {choices_.speed.frames, facts_.usual_step ? choices_.speed.recorded : std::nullopt}; }
    std::string speed_words(const PlaySpeed& speed) const { return words_of(speed, facts_.time_unit); }
    float speed_width() const {
        const float widest = width_of(speed_words({play_speeds.back(), {}}));
        return std::max(widest, width_of(speed_words(speed()))) + 2.0F * ImGui::GetStyle().FramePadding.x;
    }
    float field_width() const { return button_width(std::to_string(context_.frames)); }
    float inner_gap() const { return ImGui::GetStyle().ItemInnerSpacing.x; }
    float number_width() const { return field_width() + inner_gap() + width_of(frames_text(context_, facts_)); }
    float reach_width() const {
        return std::max(width_of(words_of(EditsReach::all_frames)), width_of(words_of(EditsReach::this_frame)));
    }
    float time_width() const {
        const std::size_t letters = std::max(choices_.time_letters, facts_.time.size());
        return width_of(words_of_time(std::string(letters, '0'), facts_.time_unit));
    }
    float mark_width() const { return 0.7F * ImGui::GetFontSize(); }
    float shortest_line() const { return 30.0F * context_.scale; }

    // In a narrow window what can be done otherwise yields to the line, and the line to what can be read nowhere else.
    void choose_what_fits() {
        const float good_line = 120.0F * context_.scale;
        float room = ImGui::GetContentRegionAvail().x - shortest_line() - button() - 2.0F * gap();
        const auto take = [&](bool& shows, float width) {
            shows = room >= width;
            if (shows) room -= width;
        };
        take(shows_number_, number_width() + gap());
        if (facts_.edits != EditsReach::none) take(shows_mark_, mark_width() + gap());
        if (!facts_.time.empty()) take(shows_time_, time_width() + gap());
        room -= good_line - shortest_line();
        take(shows_steps_, 2.0F * button());
        take(shows_speed_, speed_width() + gap());
        take(shows_repeat_, button() + gap());
        take(shows_ends_, 2.0F * button());
        // Instead of the mark.
        if (shows_mark_) take(shows_reach_, reach_width() + gap() - mark_width());
        line_width_ = good_line + room;
    }

    template <typename Icon>
    bool draw_button(const char* name, bool enabled, const std::string& help, const Icon& icon) {
        const ImVec2 size{button(), ImGui::GetFrameHeight()};
        ImGui::SetCursorScreenPos(left_);
        ImGui::BeginDisabled(!enabled);
        const bool pressed = ImGui::InvisibleButton((std::string("##") + name).c_str(), size);
        const bool hovered = ImGui::IsItemHovered();
        const bool held = ImGui::IsItemActive();
        if (hovered || held) {
            ImGui::GetWindowDrawList()->AddRectFilled(left_, {left_.x + size.x, left_.y + size.y},
                                                      ImGui::GetColorU32(held ? ImGuiCol_ButtonActive : ImGuiCol_ButtonHovered),
                                                      ImGui::GetStyle().FrameRounding);
        }
        icon(IconPlace{{left_.x + 0.5F * size.x, left_.y + 0.5F * size.y},
                       std::round(0.5F * size.y),
                       ImGui::GetColorU32(enabled ? ImGuiCol_Text : ImGuiCol_TextDisabled, enabled ? 1.0F : 0.6F)});
        ImGui::EndDisabled();
        note_widget(context_, name);
        explain_item(help);
        left_.x += size.x;
        return pressed;
    }

    template <typename Icon>
    void command(bool shown, CommandId id, const char* name, const Icon& icon) {
        if (!shown) return;
        const CommandInfo& info = info_of(context_.commands, id);
        const std::string help = std::string(info.help) + "\n" + every_shortcut(info.shortcut);
        if (draw_button(name, info.enabled, help, icon)) context_.actions.emplace_back(RunCommand{id});
    }

    void draw_line() {
        const float height = ImGui::GetFrameHeight();
        const float knob = 0.28F * height;
        const float inner = std::max(line_width_ - 2.0F * knob, 1.0F);
        const float begin = left_.x + knob;
        const auto last = static_cast<float>(std::max<std::int64_t>(context_.frames - 1, 1));
        const auto x_of = [&](std::int64_t frame) {
            return begin + inner * std::clamp(static_cast<float>(frame) / last, 0.0F, 1.0F);
        };
        const auto frame_at = [&](float x) {
            const double part = std::clamp(static_cast<double>((x - begin) / inner), 0.0, 1.0);
            return static_cast<std::int64_t>(std::llround(part * static_cast<double>(context_.frames - 1)));
        };
        ImGui::SetCursorScreenPos(left_);
        ImGui::InvisibleButton("##timeline", {std::max(line_width_, 1.0F), height});
        note_widget(context_, "timeline");
        const bool held = ImGui::IsItemActive();
        const bool hovered = ImGui::IsItemHovered();
        choices_.handle_held = held;
        const float mouse = ImGui::GetIO().MousePos.x;
        const std::int64_t present = facts_.wanted.value_or(context_.frame);
        if (held) show(frame_at(mouse));

        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float middle = std::round(left_.y + 0.5F * height);
        const float thick = std::max(std::round(2.0F * context_.scale), 1.0F);
        const float end = begin + inner;
        draw.AddRectFilled({begin, middle - thick}, {end, middle + thick}, ImGui::GetColorU32(ImGuiCol_FrameBgActive), thick);
        draw_ticks(x_of, middle, inner);
        const float shown = x_of(context_.frame);
        draw.AddRectFilled({begin, middle - thick}, {shown, middle + thick}, ImGui::GetColorU32(ImGuiCol_SliderGrab), thick);
        const float handle = x_of(present);
        if (facts_.wanted) {  // what is shown, and on the way to what
            draw.AddRectFilled({std::min(shown, handle), middle - 0.5F * thick}, {std::max(shown, handle), middle + 0.5F * thick},
                               ImGui::GetColorU32(ImGuiCol_SliderGrab, 0.6F));
            draw.AddCircle({handle, middle}, knob, ImGui::GetColorU32(ImGuiCol_SliderGrabActive), 24, thick);
            draw.AddCircleFilled({shown, middle}, 0.6F * knob, ImGui::GetColorU32(ImGuiCol_SliderGrab), 24);
        } else {
            const float radius = held || hovered ? knob * 1.15F : knob;
            draw.AddCircleFilled({handle, middle}, radius, ImGui::GetColorU32(ImGuiCol_SliderGrabActive), 24);
        }
        if (hovered || held) {
            std::string text = "frame " + in_groups(static_cast<std::uint64_t>(held ? present : frame_at(mouse)));
            if (facts_.wanted) text += facts_.wanted_in_vain ? ", cannot be read" : ", being read";
            // Above the line, where it covers no number.
            ImGui::SetNextWindowPos({std::clamp(mouse, begin, end), left_.y - 0.5F * gap()}, ImGuiCond_Always, {0.5F, 1.0F});
            ImGui::SetTooltip("%s", text.c_str());
        }
        left_.x += line_width_ + gap();
    }

    // A mark for each frame, where they do not run together.
    template <typename Place>
    void draw_ticks(const Place& x_of, float middle, float inner) {
        const std::int64_t steps = context_.frames - 1;
        if (steps < 2 || inner / static_cast<float>(steps) < 8.0F * context_.scale) return;
        const float low = middle + 5.0F * context_.scale;
        for (std::int64_t frame = 0; frame <= steps; ++frame) {
            const float x = std::round(x_of(frame));
            ImGui::GetWindowDrawList()->AddRectFilled({x, low}, {x + std::max(context_.scale, 1.0F), low + 3.0F * context_.scale},
                                                      ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.7F));
        }
    }

    void draw_words(const std::string& text, float width, const ImVec4& color, const char* name, const std::string& help) {
        ImGui::SetCursorScreenPos({left_.x + std::max(width - width_of(text), 0.0F), left_.y});
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(color, "%s", text.c_str());
        note_widget(context_, name);
        explain_item(help);
        left_.x += width + gap();
    }

    void draw_number() {
        if (!shows_number_) return;
        std::string help = "The frame that is shown, of all; the first is 0.";
        if (facts_.counting)
            help = "So many frames are found in " + fixed(100.0 * facts_.counted, 0) + " % of the file; the rest is being counted.";
        if (facts_.edits != EditsReach::none && !shows_mark_) help += "\n" + words_of(facts_.edits);
        ImGui::SetCursorScreenPos(left_);
        ImGui::SetNextItemWidth(field_width());
        const NumberRule rule{.low = 0.0, .high = static_cast<double>(context_.frames - 1), .whole = true, .usual_size = 100.0};
        const std::int64_t present = facts_.wanted.value_or(context_.frame);
        auto number = static_cast<double>(present);
        if (sphereview::draw_number(context_, choices_.numbers, "frame", rule, number) != NumberChange::none)
            show(std::llround(number));
        left_.x += field_width() + inner_gap();
        const std::string range = frames_text(context_, facts_);
        draw_words(range, width_of(range), ImGui::GetStyleColorVec4(ImGuiCol_Text), "frame number", help);
    }

    void draw_time() {
        choices_.time_letters = std::max(choices_.time_letters, facts_.time.size());
        const ImVec4 color = ImGui::GetStyleColorVec4(facts_.wanted ? ImGuiCol_TextDisabled : ImGuiCol_Text);
        draw_words(words_of_time(facts_.time, facts_.time_unit), time_width(), color, "frame time",
                   "The time of the frame that is shown, as the file has it.");
    }

    void show(std::int64_t frame) {
        if (frame != facts_.wanted.value_or(context_.frame)) context_.actions.emplace_back(ShowFrame{frame});
    }

    bool has_own_edits() const { return facts_.edits == EditsReach::this_frame; }
    ImVec4 reach_color() const {
        return has_own_edits() ? on_panel({0.98F, 0.76F, 0.36F, 1.0F}) : ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    }
    std::string reach_help() const {
        return has_own_edits()
                   ? "Spheres were moved, added, deleted or reordered: of this frame alone.\nBefore another frame is shown you are "
                     "asked. Colours, radii, names and what is hidden go along,\nbut only as they were before spheres were "
                     "added, deleted or reordered."
                   : "Colours, radii, names, what is hidden, the camera, the light and the background\nare changed in all frames, "
                     "by the spheres' numbers. Undo takes that back.";
    }

    void draw_reach() {
        left_.x += gap();
        draw_words(words_of(facts_.edits), reach_width(), reach_color(), "edits reach", reach_help());
    }

    // Full: of this frame alone; a ring: of all.
    void draw_reach_mark() {
        const ImVec2 size{mark_width(), ImGui::GetFrameHeight()};
        ImGui::SetCursorScreenPos(left_);
        ImGui::InvisibleButton("##edits mark", size);
        note_widget(context_, "edits mark");
        explain_item(words_of(facts_.edits) + "\n" + reach_help());
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const ImVec2 middle{left_.x + 0.5F * size.x, left_.y + 0.5F * size.y};
        const ImU32 color = ImGui::GetColorU32(reach_color());
        const float radius = 0.4F * size.x;
        if (has_own_edits()) {
            draw.AddCircleFilled(middle, radius, color, 24);
        } else {
            draw.AddCircle(middle, radius, color, 24, std::max(0.35F * radius, 1.0F));
        }
        left_.x += size.x + gap();
    }

    void draw_repeat_button() {
        const Repeat repeat = choices_.repeat;
        const char* help = repeat == Repeat::once   ? "Ends with the last frame"
                           : repeat == Repeat::loop ? "Goes on with the first frame behind the last"
                                                    : "Plays back and forth";
        const bool pressed = draw_button("repeat", true, help, [&](const IconPlace& icon) {
            const bool on = repeat != Repeat::once;
            draw_repeat({icon.middle, 1.2F * icon.size, on ? ImGui::GetColorU32(ImGuiCol_CheckMark) : icon.color}, repeat);
        });
        left_.x += gap();
        if (!pressed) return;
        choices_.repeat = repeat == Repeat::once ? Repeat::loop : repeat == Repeat::loop ? Repeat::back_and_forth : Repeat::once;
    }

    void draw_speed() {
        ImGui::SetCursorScreenPos(left_);
        ImGui::SetNextItemWidth(speed_width());
        const bool open = ImGui::BeginCombo("##speed", speed_words(speed()).c_str(),
                                            ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest);
        note_widget(context_, "speed");
        if (!open) {
            explain_item(speed().recorded ? "As recorded: so much of the file's time a second" : "Frames a second");
            return;
        }
        for (const double frames : play_speeds) offer_speed({frames, {}});
        if (facts_.usual_step) {
            ImGui::TextDisabled("as recorded");  // on one line, whatever the width above it
            for (const double time : recorded_speeds(*facts_.usual_step)) offer_speed({choices_.speed.frames, time});
        }
        ImGui::EndCombo();
    }

    void offer_speed(const PlaySpeed& offered) {
        const std::string words = speed_words(offered);
        if (ImGui::Selectable(words.c_str(), offered == speed())) choices_.speed = offered;
        note_widget(context_, "speed " + words);
    }

    const PanelContext& context_;
    const TimelineFacts& facts_;
    PlayChoices& choices_;
    ImVec2 left_{};  // where the next item begins
    float line_width_ = 0.0F;
    bool shows_number_ = false;
    bool shows_time_ = false;
    bool shows_steps_ = false;
    bool shows_ends_ = false;
    bool shows_speed_ = false;
    bool shows_repeat_ = false;
    bool shows_mark_ = false;
    bool shows_reach_ = false;
};

}  // namespace

float least_timeline_width(const PanelContext& context, const TimelineFacts& facts) {
    PlayChoices choices;
    return Timeline(context, facts, choices).least_width();
}

float timeline_height() { return ImGui::GetFrameHeight(); }

void draw_timeline(const PanelContext& context, const TimelineFacts& facts, PlayChoices& choices) {
    Timeline(context, facts, choices).draw();
}

}  // namespace sphereview

#include "panels/status_bar.hpp"

#include <imgui.h>

#include <algorithm>

#include "base/text.hpp"
#include "panels/labels.hpp"

namespace sphereview {

namespace {

float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

// Columns from left to right, each as wide as the widest text it may ever hold.
class Columns {
public:
    explicit Columns(float scale) : origin_(ImGui::GetCursorScreenPos()), gap_(24.0F * scale) {
        right_ = origin_.x + ImGui::GetContentRegionAvail().x;
    }

    // Text that does not fit is cut off at the column's edge. `right`: numbers, whose last digits stay in place.
    void put(const std::string& text, float width, bool right = false) {
        const float end = std::min(left_ + origin_.x + width, right_);
        const float begin = origin_.x + left_ + (right ? std::max(0.0F, width - width_of(text)) : 0.0F);
        if (begin < end) {
            ImGui::PushClipRect({begin, origin_.y}, {end, origin_.y + ImGui::GetTextLineHeight()}, true);
            ImGui::SetCursorScreenPos({begin, origin_.y});
            ImGui::TextUnformatted(text.c_str());
            ImGui::PopClipRect();
        }
        left_ += width + gap_;
    }

    float rest() const { return std::max(0.0F, right_ - origin_.x - left_); }

private:
    ImVec2 origin_;
    float gap_;
    float left_ = 0.0F;
    float right_ = 0.0F;
};

std::string spheres_text(std::size_t spheres, std::size_t hidden, std::size_t selected) {
    std::string text = in_groups(spheres) + (spheres == 1 ? " sphere" : " spheres");
    if (hidden > 0) text += ", " + in_groups(hidden) + " hidden";
    if (selected > 0) text += ", " + in_groups(selected) + " selected";
    return text;
}

// As --frame counts them.
std::string frame_text(std::int64_t frame, std::int64_t frames) {
    return "frame " + std::to_string(frame) + " of 0.." + std::to_string(frames - 1);
}

std::string pixel_text(int x, int y) { return std::to_string(x) + ", " + std::to_string(y); }

// Seconds can be anything a driver says, also before the first frame.
std::string time_text(double seconds) { return fixed(std::clamp(seconds * 1000.0, 0.0, 99'999.9), 1) + " ms"; }

std::string under_pointer(const PanelContext& context, const Status& status) {
    if (!status.pixel) return "";
    const Scene& scene = context.document.scene();
    if (!status.sphere || *status.sphere >= scene.spheres.size()) return "background";
    return on_one_line(title_of(scene, *status.sphere));
}

}  // namespace

void draw_status_bar(const PanelContext& context, const Status& status) {
    const std::size_t spheres = context.document.scene().spheres.size();
    Columns columns(context.scale);
    columns.put(status.renderer, std::min(width_of(status.renderer), 0.3F * columns.rest()));
    columns.put(spheres_text(spheres, status.hidden, context.selection.size()),
                width_of(spheres_text(spheres, std::max<std::size_t>(spheres, 1), std::max<std::size_t>(spheres, 1))));
    if (context.frames > 1) {
        columns.put(frame_text(context.frame, context.frames), width_of(frame_text(context.frames - 1, context.frames)));
    }
    columns.put(time_text(status.frame_seconds), width_of("9,999.9 ms"), true);
    columns.put(status.step > 1 ? "1/" + std::to_string(status.step) : "", width_of("1/16"));
    columns.put(status.pixel ? pixel_text(status.pixel->x, status.pixel->y) : "", width_of(pixel_text(99'999, 99'999)), true);
    columns.put(under_pointer(context, status), columns.rest());
}

}  // namespace sphereview

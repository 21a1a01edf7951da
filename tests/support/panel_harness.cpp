#include "support/panel_harness.hpp"

#include <gtest/gtest.h>

#include "viewer/perform.hpp"

namespace sphereview {

namespace {

constexpr double redraw_seconds = 1.0 / 60.0;

}  // namespace

std::vector<CommandInfo> all_commands() {
    std::vector<CommandInfo> commands = commands_of(ViewerState({}, {}));
    for (CommandInfo& info : commands) {
        info.enabled = true;
        info.checked = false;
    }
    return commands;
}

PanelHarness::PanelHarness(Draw draw, Scene scene, float width, float height)
    : document(std::move(scene)), draw_(std::move(draw)), bounds_(bounds_of(document.scene())) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {width, height};
    io.ConfigInputTextCursorBlink = false;
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* self, const char* text) { static_cast<PanelHarness*>(self)->clipboard_ = text; };
    io.GetClipboardTextFn = [](void* self) { return static_cast<PanelHarness*>(self)->clipboard_.c_str(); };
    unsigned char* pixels = nullptr;
    int columns = 0;
    int rows = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &columns, &rows);
#if IMGUI_VERSION_NUM < 18700
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
#endif
    // A window's size, and what a widget's place depends on, are settled after some redraws.
    redraws(3);
}

PanelHarness::~PanelHarness() { ImGui::DestroyContext(); }

PanelHarness::Draw PanelHarness::in_window(Draw draw, float width, float height) {
    return [draw = std::move(draw), width, height](const PanelContext& context) {
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize({width, height});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
        draw(context);
        ImGui::End();
    };
}

void PanelHarness::redraw(double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = static_cast<float>(seconds);
    bool pressed = false;
    for (const bool down : io.MouseDown) pressed = pressed || down;
    if (!pressed) bounds_ = bounds_of(document.scene());
    rectangles.clear();
    hovered.reset();
    std::vector<Action> actions;
    ImGui::NewFrame();
    if (logging_) ImGui::LogToClipboard(0);
    draw_({document, selection, bounds_, commands, scale, gesture, hovered, actions, &rectangles, frame_of_file, frames_of_file,
           document.scene().light, camera_axes(view()), view(), property_names});
    ImGui::Render();
    if (applies) {
        for (const Action& action : actions) {
            if (const auto* edit = std::get_if<EditScene>(&action)) {
                document.apply(edit->edit, edit->name, edit->gesture);
                if (std::holds_alternative<ChangeCamera>(edit->edit)) moved_view.reset();
            }
            if (const auto* select = std::get_if<SelectSpheres>(&action)) selection = select->selection;
        }
        selection.keep_below(document.scene().spheres.size());
    }
    for (Action& action : actions) actions_.push_back(std::move(action));
}

void PanelHarness::redraws(int count) {
    for (int i = 0; i < count; ++i) redraw(redraw_seconds);
}

void PanelHarness::wait() { redraw(1.0); }

std::vector<CommandId> PanelHarness::commands_taken() {
    std::vector<CommandId> ids;
    for (const RunCommand& one : taken<RunCommand>()) ids.push_back(one.command);
    return ids;
}

ImVec2 PanelHarness::place(const std::string& widget, float across, float down) const {
    const auto found = rectangles.find(widget);
    if (found == rectangles.end()) {
        ADD_FAILURE() << "the last redraw has no widget \"" << widget << "\"";
        return {-1.0F, -1.0F};
    }
    const WidgetRectangle& r = found->second;
    return {r.left + across * (r.right - r.left), r.top + down * (r.bottom - r.top)};
}

void PanelHarness::move(ImVec2 place) {
    ImGui::GetIO().MousePos = place;
    redraws();
}

void PanelHarness::press(int button) {
    ImGui::GetIO().MouseDown[button] = true;
    redraws();
}

void PanelHarness::release(int button) {
    ImGui::GetIO().MouseDown[button] = false;
    redraws();
}

void PanelHarness::wheel(float clicks) {
    ImGui::GetIO().MouseWheel += clicks;
    redraws();
}

void PanelHarness::click(ImVec2 place, int button) {
    move(place);
    wait();
    press(button);
    release(button);
    redraws();
}

void PanelHarness::double_click(const std::string& widget) {
    click(widget);
    press();
    release();
    redraws();
}

void PanelHarness::drag(ImVec2 from, ImVec2 to, int steps) {
    move(from);
    wait();
    press();
    for (int i = 1; i <= steps; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(steps);
        move({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
    }
    release();
    redraws();
}

void PanelHarness::set_key(ImGuiKey key, bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[key] = down;
#else
    ImGui::GetIO().AddKeyEvent(key, down);
#endif
}

void PanelHarness::hold(ImGuiKey key) {
    set_key(key, true);
    redraws();
}

void PanelHarness::let_go(ImGuiKey key) {
    set_key(key, false);
    redraws();
}

void PanelHarness::tap(ImGuiKey key) {
    hold(key);
    let_go(key);
    redraws();
}

void PanelHarness::type(const std::string& utf8) {
    ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
    redraws(2);
}

void PanelHarness::modifiers(bool ctrl, bool shift) {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM < 18900
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
#else
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
#endif
    redraws();
}

std::string PanelHarness::text() {
    clipboard_.clear();
    logging_ = true;
    redraws();
    logging_ = false;
    return clipboard_;
}

int PanelHarness::vertices() const { return ImGui::GetDrawData()->TotalVtxCount; }

}  // namespace sphereview

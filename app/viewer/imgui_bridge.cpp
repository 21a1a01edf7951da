#include "viewer/imgui_bridge.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "gpu/picture_texture.hpp"
#include "platform/font_file.hpp"

namespace sphereview {

namespace {

constexpr float usual_font_size = 15.0F;

constexpr std::array<std::pair<std::string_view, ImGuiKey>, 21> imgui_keys = {{
    {"tab", ImGuiKey_Tab},
    {"left", ImGuiKey_LeftArrow},
    {"right", ImGuiKey_RightArrow},
    {"up", ImGuiKey_UpArrow},
    {"down", ImGuiKey_DownArrow},
    {"page up", ImGuiKey_PageUp},
    {"page down", ImGuiKey_PageDown},
    {"home", ImGuiKey_Home},
    {"end", ImGuiKey_End},
    {"insert", ImGuiKey_Insert},
    {"delete", ImGuiKey_Delete},
    {"backspace", ImGuiKey_Backspace},
    {"space", ImGuiKey_Space},
    {"enter", ImGuiKey_Enter},
    {"escape", ImGuiKey_Escape},
    {"a", ImGuiKey_A},
    {"c", ImGuiKey_C},
    {"v", ImGuiKey_V},
    {"x", ImGuiKey_X},
    {"y", ImGuiKey_Y},
    {"z", ImGuiKey_Z},
}};

void set_modifiers(ImGuiIO& io, const Modifiers& modifiers) {
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Ctrl, modifiers.control);
    io.AddKeyEvent(ImGuiMod_Shift, modifiers.shift);
    io.AddKeyEvent(ImGuiMod_Alt, modifiers.alt);
#elif IMGUI_VERSION_NUM >= 18700
    io.AddKeyEvent(ImGuiKey_ModCtrl, modifiers.control);
    io.AddKeyEvent(ImGuiKey_ModShift, modifiers.shift);
    io.AddKeyEvent(ImGuiKey_ModAlt, modifiers.alt);
#else
    io.KeyCtrl = modifiers.control;
    io.KeyShift = modifiers.shift;
    io.KeyAlt = modifiers.alt;
#endif
}

void set_key(ImGuiIO& io, std::string_view name, bool pressed) {
    for (std::size_t i = 0; i < imgui_keys.size(); ++i) {
        if (imgui_keys[i].first != name) continue;
#if IMGUI_VERSION_NUM >= 18700
        io.AddKeyEvent(imgui_keys[i].second, pressed);
#else
        io.KeysDown[i] = pressed;
#endif
    }
}

void forget_keys(ImGuiIO& io) {
    for (const auto& [name, key] : imgui_keys) set_key(io, name, false);
    set_modifiers(io, {});
}

PointerShape shape_for(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput: return PointerShape::text;
        case ImGuiMouseCursor_ResizeEW: return PointerShape::horizontal_resize;
        case ImGuiMouseCursor_ResizeNS: return PointerShape::vertical_resize;
        case ImGuiMouseCursor_Hand: return PointerShape::hand;
        default: return PointerShape::arrow;
    }
}

// A hash of all triangles: an ImDrawVert has no padding.
std::size_t hash_of(const ImDrawData& data) {
    std::size_t hash = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImVector<ImDrawVert>& vertices = data.CmdLists[i]->VtxBuffer;
        const std::string_view bytes(reinterpret_cast<const char*>(vertices.Data),
                                     static_cast<std::size_t>(vertices.Size) * sizeof(ImDrawVert));
        hash = 31 * hash + std::hash<std::string_view>{}(bytes);
    }
    return hash;
}

// Asked for as a C string that lives until the next time.
const char* clipboard_text(void* user) {
    static std::string text;
    text = static_cast<Window*>(user)->clipboard();
    return text.c_str();
}

}  // namespace

ImguiBridge::ImguiBridge(Window& window, double text_scale, Theme theme)
    : window_(window), context_(ImGui::CreateContext()), text_scale_(text_scale), theme_(theme) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is written to the current folder
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;  // an idle window draws nothing
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.BackendPlatformName = "sphereview";
#if IMGUI_VERSION_NUM >= 18700
    io.ConfigInputTrickleEventQueue = false;  // a redraw's events are such as it can tell apart (input_queue.hpp)
#else
    for (std::size_t i = 0; i < imgui_keys.size(); ++i) io.KeyMap[imgui_keys[i].second] = static_cast<int>(i);
#endif
#if IMGUI_VERSION_NUM < 19110
    io.ClipboardUserData = &window_;
    io.GetClipboardTextFn = clipboard_text;
    io.SetClipboardTextFn = [](void* user, const char* text) { static_cast<Window*>(user)->set_clipboard(text); };
#else
    ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
    platform.Platform_ClipboardUserData = &window_;
    platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
        return clipboard_text(ImGui::GetPlatformIO().Platform_ClipboardUserData);
    };
    platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
        static_cast<Window*>(ImGui::GetPlatformIO().Platform_ClipboardUserData)->set_clipboard(text);
    };
#endif
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

ImguiBridge::~ImguiBridge() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

void ImguiBridge::set_theme(Theme theme) {
    if (theme == theme_) return;
    theme_ = theme;
    font_pixels_ = 0.0F;  // the next redraw gives the style anew
}

void ImguiBridge::build_fonts() {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    // Latin, accents, Greek, Cyrillic, and the punctuation, powers, indices, arrows and operators that the panels use.
    static constexpr std::array<ImWchar, 15> ranges = {0x20,   0x17F,  0x300,  0x3FF,  0x400,  0x4FF,  0x2010, 0x205E,
                                                       0x2070, 0x209C, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};
    // The second is for what must stand in columns: a compiler's log.
    for (const FontFamily family : {FontFamily::sans_serif, FontFamily::monospaced}) {
        const std::string file = system_font_file(family);
        const ImFont* font =
            file.empty() ? nullptr : io.Fonts->AddFontFromFileTTF(file.c_str(), font_pixels_, nullptr, ranges.data());
        ImFontConfig own;
        own.SizePixels = font_pixels_;
        if (font == nullptr) io.Fonts->AddFontDefault(&own);
    }
#if IMGUI_VERSION_NUM >= 19200
    // From here on the backend makes the glyphs' texture as glyphs are drawn.
    ImGui::GetStyle().FontSizeBase = font_pixels_;
#else
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void ImguiBridge::feed(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    if (const auto* moved = std::get_if<PointerMoved>(&event)) {
        io.MousePos = ImVec2(static_cast<float>(moved->x), static_cast<float>(moved->y));
    } else if (std::holds_alternative<PointerLeft>(event)) {
        // A drag goes on outside the window.
        if (!io.MouseDown[0] && !io.MouseDown[1] && !io.MouseDown[2]) io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
    } else if (const auto* button = std::get_if<ButtonChanged>(&event)) {
        io.MouseDown[static_cast<int>(button->button)] = button->pressed;
        set_modifiers(io, button->modifiers);
    } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
        io.MouseWheel += static_cast<float>(wheel->y);
        io.MouseWheelH += static_cast<float>(wheel->x);
        set_modifiers(io, wheel->modifiers);
    } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
        // ImGui before 1.89 presses what the arrows have chosen with Space alone.
        const bool chooses = (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0 && !io.WantTextInput;
        if (key->name == "enter" && (chooses || !key->pressed)) set_key(io, "space", key->pressed);
        set_key(io, key->name, key->pressed);
        set_modifiers(io, key->modifiers);
    } else if (const auto* typed = std::get_if<CharacterTyped>(&event)) {
        io.AddInputCharacter(static_cast<unsigned>(typed->character));
    } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
        // Releases that go to another window are never heard of.
        if (!focus->focused) forget_keys(io);
    }
}

void ImguiBridge::begin_redraw(const std::vector<InputEvent>& events, double seconds_since_last, bool navigates) {
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigFlags = navigates ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
    const Window::Extent extent = window_.extent();
    const Window::Extent framebuffer = window_.framebuffer();
    // Where a screen coordinate is several pixels (macOS), ImGui's sizes are in screen coordinates, its fonts in pixels.
    const float pixels = extent.width > 0 ? static_cast<float>(framebuffer.width) / static_cast<float>(extent.width) : 1.0F;
    const float text_pixels = std::round(usual_font_size * static_cast<float>(window_.content_scale() * text_scale_));
    io.DisplaySize = ImVec2(static_cast<float>(extent.width), static_cast<float>(extent.height));
    io.DisplayFramebufferScale = ImVec2(pixels, pixels);
    io.DeltaTime = static_cast<float>(std::fmax(seconds_since_last, 1e-4));
    if (text_pixels != font_pixels_) {
        font_pixels_ = text_pixels;
        scale_ = text_pixels / usual_font_size / pixels;
        apply_style(scale_, theme_);
#if IMGUI_VERSION_NUM >= 19200
        ImGui::GetStyle().FontScaleMain = 1.0F / pixels;
#else
        io.FontGlobalScale = 1.0F / pixels;
#endif
        build_fonts();
    }
    for (const InputEvent& event : events) feed(event);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

bool ImguiBridge::end_redraw() {
    ImGui::Render();
    window_.set_pointer(shape_for(ImGui::GetMouseCursor()));
    const std::size_t drawn = hash_of(*ImGui::GetDrawData());
    return std::exchange(drawn_, drawn) != drawn;
}

void ImguiBridge::render() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

std::optional<ImTextureID> PictureTexture::follow(const std::shared_ptr<const Image>& picture) {
    if (!picture || std::max(picture->width(), picture->height()) > gl_limit(GL_MAX_TEXTURE_SIZE)) return std::nullopt;
    if (picture != uploaded_) {
        upload(*picture, texture_);
        constexpr GLint smallest = 4;  // levels: a picture that is drawn still smaller shows nothing any more
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, smallest);
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        uploaded_ = picture;
    }
    // A number in some releases of ImGui, a pointer in others.
    using Bits = std::conditional_t<sizeof(ImTextureID) == sizeof(std::uint64_t), std::uint64_t, std::uint32_t>;
    return std::bit_cast<ImTextureID>(Bits{texture_.name()});
}

}  // namespace sphereview

#include "platform/font_file.hpp"

#ifdef SPHEREVIEW_FONTCONFIG
#include <fontconfig/fontconfig.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include "base/text.hpp"
#elif defined(_WIN32)
#include <windows.h>

#include <array>
#include <filesystem>

#include "base/path.hpp"
#endif

namespace sphereview {

#ifdef SPHEREVIEW_FONTCONFIG

namespace {

template <auto destroy>
struct Destroy {
    template <typename T>
    void operator()(T* object) const {
        destroy(object);
    }
};

using Config = std::unique_ptr<FcConfig, Destroy<FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, Destroy<FcFontSetDestroy>>;

std::string text_of(FcPattern* font, const char* property) {
    FcChar8* text = nullptr;
    const bool found = FcPatternGetString(font, property, 0, &text) == FcResultMatch;
    return found ? reinterpret_cast<const char*>(text) : "";
}

bool begins_as_truetype(const std::string& path) {
    std::array<char, 4> bytes{};
    if (std::error_code ignored; !std::filesystem::is_regular_file(path, ignored)) return false;  // a FIFO would be waited for
    std::ifstream file(path, std::ios::binary);
    if (!file.read(bytes.data(), bytes.size())) return false;
    const std::string_view signature(bytes.data(), bytes.size());
    return signature == std::string_view("\0\1\0\0", 4) || signature == "true";
}

// The file, if stb_truetype, which ImGui reads fonts with, shows it as it should look.
std::string readable_file(FcPattern* font) {
    const std::string file = text_of(font, FC_FILE);
    int index = 0;  // above 0: a later face, or an instance of a variable font
    FcBool variable = FcFalse;
    FcPatternGetInteger(font, FC_INDEX, 0, &index);
    FcPatternGetBool(font, FC_VARIABLE, 0, &variable);
    FcCharSet* characters = nullptr;
    const bool has_letters = FcPatternGetCharSet(font, FC_CHARSET, 0, &characters) == FcResultMatch &&
                             FcCharSetHasChar(characters, U'A') != 0 && FcCharSetHasChar(characters, U'z') != 0;
    const bool good = index == 0 && variable == FcFalse && has_letters && text_of(font, FC_FONTFORMAT) == "TrueType" &&
                      has_ending(file, ".ttf") && begins_as_truetype(file);
    return good ? file : "";
}

}  // namespace

std::string system_font_file(FontFamily family) {
    const bool monospaced = family == FontFamily::monospaced;
    const Config config(FcInitLoadConfigAndFonts());
    const Pattern wanted(FcPatternCreate());
    if (!config || !wanted) return "";
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(monospaced ? "monospace" : "sans-serif"));
    FcPatternAddInteger(wanted.get(), FC_WEIGHT, FC_WEIGHT_REGULAR);
    FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
    FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const FontSet fonts(FcFontSort(config.get(), wanted.get(), FcFalse, nullptr, &result));
    if (!fonts) return "";
    for (int i = 0; i < fonts->nfont; ++i) {
        int spacing = FC_PROPORTIONAL;
        FcPatternGetInteger(fonts->fonts[i], FC_SPACING, 0, &spacing);
        if (monospaced && spacing != FC_MONO) continue;  // the list goes on with all other fonts
        std::string file = readable_file(fonts->fonts[i]);
        if (!file.empty()) return file;
    }
    return "";
}

#elif defined(_WIN32)

std::string system_font_file(FontFamily family) {
    std::array<wchar_t, MAX_PATH> windows{};
    if (GetSystemWindowsDirectoryW(windows.data(), MAX_PATH) == 0) return "";
    std::error_code none;
    for (const char* name : {family == FontFamily::monospaced ? "consola.ttf" : "segoeui.ttf",
                             family == FontFamily::monospaced ? "cour.ttf" : "tahoma.ttf"}) {
        const std::filesystem::path file = std::filesystem::path(windows.data()) / "Fonts" / name;
        if (std::filesystem::is_regular_file(file, none)) return text_from(file);
    }
    return "";
}

#else

std::string system_font_file(FontFamily) { return ""; }

#endif

}  // namespace sphereview

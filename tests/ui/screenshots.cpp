// Takes the README's screenshots: screenshots FOLDER
#include <cstdio>
#include <exception>
#include <fstream>

#include "support/folders.hpp"
#include "ui/viewer_window.hpp"

namespace {

using namespace sphereview::test;

void save(ViewerWindow& window, const std::string& path) {
    std::ofstream(path, std::ios::binary) << encode_png(window.server().screen());
    std::printf("%s\n", path.c_str());
}

// The place of a pixel of the picture, as parts of its sides.
Place at(ViewerWindow& window, double x, double y) {
    const auto& size = window.redraw().at("picture_size");
    return window.pixel(x * size[0].get<double>(), y * size[1].get<double>());
}

void take(const std::string& folder) {
    const TemporaryFolder files;
    files.write("home/config/sphereview/viewer.json", "{}");  // as who opens it for the first time sees it
    const ScreenOptions screen{1280, 800, 96};
    {
        ViewerWindow window(files, {source_file("scenes/planets.toml"), "--shade", "studio", "--samples", "16"}, screen);
        window.click_widget("row 2");
        window.wait_for("selection", {2});
        window.move_to(at(window, 0.72, 0.42));
        window.wait_until("a rest", [](const Json& redraw) { return redraw.at("exact") == true; });
        save(window, folder + "/viewer.png");
    }
    {
        ViewerWindow window(files, {}, screen);
        window.move_to({5, 5});
        window.wait_until("the start page", [](const Json& redraw) { return redraw.at("exact") == true; });
        save(window, folder + "/start.png");
    }
    ViewerWindow window(files, {source_file("scenes/planets.toml"), "--shade", "studio", "--samples", "16"}, screen);
    window.key("i");
    window.wait_until("the inspector", [](const Json& redraw) { return redraw.at("shown").at("inspector") == true; });
    window.click(window.on_screen(-26, -6.4));  // the shadow of a moon
    window.move_to(at(window, 0.5, 0.9));
    window.wait_until("a pinned pixel of a sphere", [](const Json& redraw) {
        return !redraw.at("inspected").is_null() && redraw.at("inspected").at("pinned") == true && redraw.at("exact") == true;
    });
    save(window, folder + "/inspector.png");
    window.keys({"i", "Tab"});
    window.wait_until("the picture alone", [](const Json& redraw) {
        return redraw.at("shown").at("inspector") == false && redraw.at("shown").at("panel") == false && redraw.at("exact") == true;
    });
    window.key("r");
    window.wait_until("the rays", [](const Json& redraw) {
        return !redraw.at("rays").is_null() && redraw.at("rays").at("picture") == true && redraw.at("exact") == true;
    });
    const std::vector<double> seen = window.rectangle("rays picture");
    // In the shadow of Io.
    window.click({seen[0] + 0.35 * (seen[2] - seen[0]), seen[1] + 0.56 * (seen[3] - seen[1])});
    window.wait_until("a pinned pixel", [](const Json& redraw) { return redraw.at("inspected").at("pinned") == true; });
    window.click_widget("rays row");
    window.move_to({5, 780});
    window.wait_until("the row's rays", [](const Json& redraw) {
        return redraw.at("rays").at("rays").get<int>() > 10 && redraw.at("hovered").is_null() && redraw.at("exact") == true;
    });
    save(window, folder + "/rays.png");
}

}  // namespace

int main(int argc, char** argv) {
    try {
        take(argc > 1 ? argv[1] : ".");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "screenshots: %s\n", error.what());
        return 1;
    }
}

#include "ui/editing.hpp"

#include <filesystem>

namespace sphereview::test {

namespace {

// The same two spheres in the program's own format.
constexpr const char* two_spheres_in_toml =
    "[[sphere]]\ncenter = [0, 0, 300]\nradius = 60\ncolor = [255, 0, 0]\n\n"
    "[[sphere]]\ncenter = [100, 0, 300]\nradius = 30\ncolor = [0, 255, 0]\n";

}  // namespace

void edit(ViewerWindow& window) {
    const double spheres = window.at("spheres").get<double>();
    window.key("Insert");
    window.wait_for("spheres", spheres + 1);
    window.wait_for("changed", true);
}

void choose_file(ViewerWindow& window, const std::string& name) {
    window.wait_for("dialogs", {"browser"});
    window.click_widget("browser name");
    window.key("ctrl+a");
    window.type(name);
    window.click_widget("browser ok");
}

void answer(ViewerWindow& window, const std::string& question, const std::string& answer) {
    window.wait_until("the question " + question,
                      [&](const Json& f) { return !f.at("dialogs").empty() && f.at("dialogs").back() == question; });
    window.click_widget("answer " + answer);
}

std::string kept_file(const TemporaryFolder& folder) {
    std::error_code none;
    for (const auto& file : std::filesystem::directory_iterator(folder.path("home/state/sphereview"), none)) {
        const std::string name = file.path().filename().string();
        if (name.starts_with("recovery-") && name.ends_with(".toml"))
            return "home/state/sphereview/" + name;  // before, it is hidden
    }
    return "";
}

std::string kept_changes(const TemporaryFolder& folder) {
    const std::string file = kept_file(folder);
    return file.empty() ? "" : folder.read(file);
}

void wait_for_no_dialogs(ViewerWindow& window) { window.wait_for("dialogs", Json::array()); }

std::string announced(ViewerWindow& window, const std::string& part, const std::string& member) {
    const auto holds = [&](const Json& f) { return f.at(member).get<std::string>().find(part) != std::string::npos; };
    return window.wait_until(member + " with " + part, holds).at(member).get<std::string>();
}

const Json& take_marks_away(ViewerWindow& window) {
    // Keys are taken in order: once the selection has changed and changed back, all that came before has been done.
    window.key("ctrl+a");
    window.wait_until("a selection", [](const Json& f) { return f.at("selected") != 0; });
    window.keys({"ctrl+shift+a", "Escape"});
    window.move_to({5, 5});
    return window.wait_until("no marks", [](const Json& f) {
        return f.at("selection").empty() && f.at("hovered").is_null() && f.at("announcement") == "" && f.at("exact") == true;
    });
}

std::string render_bytes(const TemporaryFolder& folder, const std::string& scene, std::vector<std::string> options) {
    options.insert(options.begin(), {"render", scene, "-o", folder.path("expected.png")});
    const Outcome outcome = run(options);
    EXPECT_EQ(outcome.status, 0) << outcome;
    return folder.read("expected.png");
}

void expect_rendered(ViewerWindow& window, const TemporaryFolder& folder, const std::string& scene,
                     std::vector<std::string> options) {
    const Json redraw = take_marks_away(window);
    const Json size = redraw.at("picture_size");
    options.insert(options.end(), {"--backend", "cpu", "-s", size[0].dump() + "x" + size[1].dump(), "--shade",
                                   redraw.at("shading").get<std::string>(), "--samples", redraw.at("samples").dump()});
    EXPECT_TRUE(same_picture(window.picture(), decode_png(render_bytes(folder, scene, options))))
        << testing::PrintToString(options);
}

void replace_by_rename(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
    std::filesystem::rename(folder.write("." + name + ".new", bytes), folder.path(name));
}

Editing::Editing(const std::string& name, const ScreenOptions& screen)
    : name_(name),
      scene_(folder_.write(name, name.ends_with(".toml") ? two_spheres_in_toml : two_spheres)),
      window_(folder_, {scene_}, screen) {
    window_.key("m");  // else the frame of the export is drawn over the picture
}

Place Editing::red(double right, double down) {
    const Place middle = window_.on_screen(0, 0);
    return {middle.x + right, middle.y + down};
}

void Editing::select_red() {
    window_.click(red());
    window_.wait_for("selection", {0});
}

void Editing::select(int number) {
    window_.click_widget("row " + std::to_string(number));
    window_.wait_for("selection", {number});
}

void Editing::expect_rendered() {
    if (window_.at("changed") == true) {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
    }
    test::expect_rendered(window_, folder_, scene_);
}

}  // namespace sphereview::test

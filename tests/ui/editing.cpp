#include "ui/editing.hpp"

namespace sphereview::test {

namespace {

// The same two spheres in the program's own format.
std::string in_native_format() {
    return "[[sphere]]\ncenter = [0, 0, 300]\nradius = 60\ncolor = [255, 0, 0]\n\n"
           "[[sphere]]\ncenter = [100, 0, 300]\nradius = 30\ncolor = [0, 255, 0]\n";
}

}  // namespace

Editing::Editing(const std::string& name)
    : name_(name),
      scene_(folder_.write(name, name.ends_with(".toml") ? in_native_format() : two_spheres)),
      window_(folder_, {scene_}) {
    window_.key("m");  // else the frame of the export is drawn over the picture
}

Place Editing::red(double right, double down) {
    const Json& size = window_.frame().at("picture_size");
    return window_.pixel(size[0].get<int>() / 2 + right, size[1].get<int>() / 2 + down);
}

void Editing::select_red() {
    window_.click(red());
    window_.wait_for("selection", {0});
}

void Editing::select(int number) {
    window_.click_widget("row " + std::to_string(number));
    window_.wait_for("selection", {number});
}

const Json& Editing::take_marks_away() {
    window_.key("ctrl+shift+a");
    window_.key("Escape");
    window_.move_to({5, 5});
    return window_.wait_until("no marks", [](const Json& f) {
        return f.at("selection").empty() && f.at("hovered").is_null() && f.at("announcement") == "" && f.at("exact") == true;
    });
}

void Editing::expect_rendered() {
    if (window_.frame().at("changed") == true) {
        window_.key("ctrl+s");
        window_.wait_for("changed", false);
    }
    const Json& frame = take_marks_away();
    EXPECT_TRUE(same_picture(window_.picture(), rendered(folder_, scene_, frame)));
}

void Editing::undo_all() {
    while (window_.frame().at("undo") != "") {
        const Json before = window_.frame().at("undo");
        window_.key("ctrl+z");
        const Json revision = window_.frame().at("revision");
        window_.wait_until("an undo", [&](const Json& f) { return f.at("undo") == "" || f.at("undo") != before; });
    }
}

}  // namespace sphereview::test

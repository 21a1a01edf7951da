#include "ui/file_steps.hpp"

#include <filesystem>

#include "support/text_match.hpp"

namespace sphereview::test {

void edit(ViewerWindow& window) {
    const auto spheres = window.frame().at("spheres").get<std::size_t>();
    window.key("Insert");
    window.wait_for("spheres", spheres + 1);
    window.wait_for("changed", true);
}

void choose_file(ViewerWindow& window, const std::string& name) {
    window.wait_for("dialogs", Json::array({"browser"}));
    window.click_widget("browser name");
    window.key("ctrl+a");
    window.type(name);
    window.click_widget("browser ok");
}

void answer(ViewerWindow& window, const std::string& question, const std::string& answer) {
    window.wait_until("the question " + question,
                      [&](const Json& frame) { return !frame.at("dialogs").empty() && frame.at("dialogs").back() == question; });
    window.click_widget("answer " + answer);
}

void wait_for_no_dialogs(ViewerWindow& window) { window.wait_for("dialogs", Json::array()); }

std::string announced(ViewerWindow& window, const std::string& part) {
    const Json& frame = window.wait_until("an announcement of " + part, [&](const Json& f) {
        return static_cast<bool>(contains(f.at("announcement").get<std::string>(), part));
    });
    return frame.at("announcement");
}

void replace_by_rename(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
    std::filesystem::rename(folder.write("." + name + ".new", bytes), folder.path(name));
}

}  // namespace sphereview::test

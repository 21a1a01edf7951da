#include "ui/viewer_window.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "support/text_match.hpp"

namespace sphereview::test {

namespace {

constexpr std::chrono::seconds patience{180};  // generous: a sanitized program on a busy machine
constexpr const char* log_name = "redraws.log";
constexpr const char* settings_file = "home/config/sphereview/viewer.json";

std::string number(double value) { return std::to_string(static_cast<int>(value + 0.5)); }

Environment environment_for(const TemporaryFolder& folder, const std::string& display) {
    const std::string home = folder.path("home");
    return {{"DISPLAY", display},
            {"HOME", home},
            {"XDG_CONFIG_HOME", home + "/config"},
            {"XDG_STATE_HOME", home + "/state"},
            {"XDG_PICTURES_DIR", std::nullopt},
            {"WAYLAND_DISPLAY", std::nullopt},
            {"LIBGL_ALWAYS_SOFTWARE", "1"}};
}

}  // namespace

ViewerWindow::ViewerWindow(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const ScreenOptions& screen,
                           const std::string& input)
    : folder_(folder), server_(screen) {
    std::filesystem::create_directories(folder.path("home"));
    // Colours that tests can name, pictures that are soon finished and nothing drawn over them, unless a test, or a window before,
    // has settings there.
    if (!folder.has(settings_file)) folder.write(settings_file, R"({"shading": "flat", "samples": 1, "axes": false})");
    std::filesystem::remove(folder.path(log_name));
    Command command{.arguments = arguments,
                    .folder = folder.path(),
                    .input = input,
                    .input_stays_open = !input.empty(),
                    .environment = environment_for(folder, server_.display())};
    command.arguments.insert(command.arguments.end(), {"--redraw-log", folder.path(log_name)});
    program_.emplace(command);
    if (!input.empty()) program_->close_input();
    wait_meanwhile("a first picture",
                   [](const Json& redraw) { return redraw.at("resting") == true || redraw.at("widgets").contains("cancel work"); });
}

bool ViewerWindow::read_log() {
    std::ifstream file(folder_.path(log_name), std::ios::binary);
    if (!file) return false;
    file.seekg(static_cast<std::streamoff>(log_at_));
    std::ostringstream text;
    text << file.rdbuf();
    const std::string more = text.str();
    log_at_ += more.size();
    partial_ += more;
    const std::size_t end = partial_.rfind('\n');
    if (end == std::string::npos) return false;
    const std::size_t begin = end == 0 ? 0 : partial_.rfind('\n', end - 1) + 1;  // npos + 1 is 0
    redraw_ = Json::parse(partial_.substr(begin, end - begin));
    partial_.erase(0, end + 1);
    return true;
}

const Json& ViewerWindow::redraw() {
    read_log();
    return redraw_;
}

const Json& ViewerWindow::wait_until(const std::string& what, const std::function<bool(const Json&)>& condition) {
    return wait_meanwhile(what, [&](const Json& redraw) { return redraw.at("resting") == true && condition(redraw); });
}

const Json& ViewerWindow::wait_meanwhile(const std::string& what, const std::function<bool(const Json&)>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < deadline) {
        if (program_->has_ended() && !read_log()) break;
        read_log();
        if (!redraw_.is_null() && condition(redraw_)) return redraw_;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const std::string last = redraw_.is_null() ? "nothing was drawn" : "last redraw: " + redraw_.dump();
    std::ostringstream end;  // with what the program, or a sanitizer, said
    if (program_->has_ended()) end << "; " << program_->wait();
    throw std::runtime_error((step_.empty() ? "" : step_ + ": ") + "waited in vain for " + what + end.str() + "; " + last);
}

const Json& ViewerWindow::wait_for(const std::string& member, const Json& value) {
    return wait_until(member + " to be " + value.dump(), [&](const Json& redraw) { return redraw.at(member) == value; });
}

Json ViewerWindow::wait_for_other(const std::string& member, const Json& value) {
    return wait_until("another " + member, [&](const Json& redraw) { return redraw.at(member) != value; }).at(member);
}

void ViewerWindow::xdotool(std::vector<std::string> arguments) {
    const Outcome outcome =
        run({.arguments = std::move(arguments), .program = XDOTOOL, .environment = {{"DISPLAY", server_.display()}}});
    if (outcome.status != 0) throw std::runtime_error("xdotool failed: " + outcome.errors);
}

void ViewerWindow::move_to(const Place& place) { xdotool({"mousemove", number(place.x), number(place.y)}); }

void ViewerWindow::click_many(const Place& place, int times, int button) {
    xdotool({"mousemove", number(place.x), number(place.y), "click", "--repeat", std::to_string(times), "--delay", "0",
             std::to_string(button)});
}

void ViewerWindow::double_click(const Place& place) {
    xdotool({"mousemove", number(place.x), number(place.y), "click", "--repeat", "2", "--delay", "20", "1"});
}

void ViewerWindow::drag(const Place& from, const Place& to, int button, const std::vector<std::string>& held) {
    std::vector<std::string> words;
    for (const std::string& key : held) words.insert(words.end(), {"keydown", key});
    words.insert(words.end(), {"mousemove", number(from.x), number(from.y), "mousedown", std::to_string(button)});
    constexpr int steps = 5;
    for (int i = 1; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        words.insert(words.end(), {"mousemove", number(from.x + part * (to.x - from.x)), number(from.y + part * (to.y - from.y))});
    }
    words.insert(words.end(), {"mouseup", std::to_string(button)});
    for (const std::string& key : held) words.insert(words.end(), {"keyup", key});
    xdotool(words);
}

void ViewerWindow::wheel(int clicks) {
    if (clicks != 0) xdotool({"click", "--repeat", std::to_string(std::abs(clicks)), "--delay", "2", clicks > 0 ? "4" : "5"});
}

void ViewerWindow::keys(const std::vector<std::string>& names) {
    // GLFW takes two presses of a key within a millisecond for one that the input method has doubled.
    xdotool(all_words({"key", "--delay", "3"}, names));
}

void ViewerWindow::resize(int width, int height) {
    xdotool({"search", "--onlyvisible", "--name", "sphereview", "windowsize", std::to_string(width), std::to_string(height)});
}

bool ViewerWindow::drop(const std::vector<std::string>& paths) {
    const Place middle = pixel(100, 100);
    return server_.drop(paths, static_cast<int>(middle.x), static_cast<int>(middle.y));
}

std::vector<double> ViewerWindow::rectangle(const std::string& widget) {
    const Json sides = redraw_.at("widgets").at(widget);
    return {sides[0].get<double>(), sides[1].get<double>(), sides[2].get<double>(), sides[3].get<double>()};
}

Place ViewerWindow::widget(const std::string& name, double along) {
    wait_until("the widget " + name, [&](const Json& redraw) { return redraw.at("widgets").contains(name); });
    const std::vector<double> sides = rectangle(name);
    return {sides[0] + along * (sides[2] - sides[0]), 0.5 * (sides[1] + sides[3])};
}

void ViewerWindow::choose(const std::string& menu, const std::string& item) {
    click_widget("menu " + menu);
    click_widget("item " + item);
}

Place ViewerWindow::pixel(double x, double y) {
    const Json area = redraw_.at("picture");
    return {area[0].get<double>() + x, area[1].get<double>() + y};
}

Place ViewerWindow::on_screen(double x, double y) {
    const Json size = redraw_.at("picture_size");
    const double unit = std::min(size[0].get<double>(), size[1].get<double>()) / 100.0;
    return pixel(size[0].get<double>() / 2 + unit * x, size[1].get<double>() / 2 - unit * y);
}

Picture ViewerWindow::picture() {
    const Picture screen = server_.screen();
    const Json area = redraw_.at("picture");
    const auto left = area[0].get<std::size_t>();
    const auto top = area[1].get<std::size_t>();
    Picture picture{redraw_.at("picture_size")[0].get<int>(), redraw_.at("picture_size")[1].get<int>(), 3, {}};
    const auto row_bytes = static_cast<std::size_t>(picture.width) * 3;
    for (std::size_t row = 0; row < static_cast<std::size_t>(picture.height); ++row) {
        picture.bytes.append(screen.bytes, ((top + row) * static_cast<std::size_t>(screen.width) + left) * 3, row_bytes);
    }
    return picture;
}

std::vector<Json> logged_redraws(const TemporaryFolder& folder) {
    std::vector<Json> redraws;
    for (const std::string& line : lines(folder.read(log_name))) redraws.push_back(Json::parse(line));
    return redraws;
}

testing::AssertionResult same_picture(const Picture& found, const Picture& expected) {
    if (found.width != expected.width || found.height != expected.height) {
        return testing::AssertionFailure() << found.width << " x " << found.height << " pixels instead of " << expected.width
                                           << " x " << expected.height;
    }
    if (found == expected) return testing::AssertionSuccess();
    int count = 0;
    std::string first;
    for (int y = 0; y < found.height; ++y) {
        for (int x = 0; x < found.width; ++x) {
            const std::vector<int> was = found.at(x, y);
            const std::vector<int> should = expected.at(x, y);
            if (was == should || ++count > 1) continue;
            first = std::to_string(x) + "," + std::to_string(y) + ": " + testing::PrintToString(was) + " instead of " +
                    testing::PrintToString(should);
        }
    }
    return testing::AssertionFailure() << count << " pixels differ, the first at " << first;
}

}  // namespace sphereview::test

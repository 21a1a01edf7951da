// The shipped viewer in a window of its own, and hands for it.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "support/picture.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "ui/x_server.hpp"

namespace sphereview::test {

// A place on the screen. The window's top left corner is the screen's.
struct Place {
    double x = 0.0;
    double y = 0.0;
};

// The program with its window, its own X server and its own home folder; killed on destruction if it still runs. Each wait throws,
// with the step and the last redraw, when what is waited for does not come in a time that no healthy run needs.
class ViewerWindow {
public:
    // In `folder` lie the log of redraws, the home folder and what a test puts there. Returns when the first picture is drawn and
    // the window rests, or shows that it reads. Without settings in the home folder, the shading is flat, with a sample a pixel,
    // and no axes are shown. `input` is its standard input.
    ViewerWindow(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const ScreenOptions& screen = {},
                 const std::string& input = "");

    // Says what follows, for the messages of waits that end in vain.
    void step(const std::string& name) { step_ = name; }
    // The last line of the log (app/viewer/redraw_log.hpp).
    const Json& redraw();
    // A member of that.
    Json at(const std::string& member) { return redraw().at(member); }
    // Waits until a redraw at rest (nothing more to do) fulfils the condition.
    const Json& wait_until(const std::string& what, const std::function<bool(const Json&)>& condition);
    // The same of any redraw, also while something is read or written.
    const Json& wait_meanwhile(const std::string& what, const std::function<bool(const Json&)>& condition);
    // Waits until a member, at rest, has a value, or another value than that.
    const Json& wait_for(const std::string& member, const Json& value);
    Json wait_for_other(const std::string& member, const Json& value);

    // Real input, through xdotool. None waits for what it causes.
    void move_to(const Place& place);
    void click(const Place& place, int button = 1) { click_many(place, 1, button); }
    void click_many(const Place& place, int times, int button = 1);  // without a pause
    void double_click(const Place& place);
    void press(int button = 1) { xdotool({"mousedown", std::to_string(button)}); }
    void release(int button = 1) { xdotool({"mouseup", std::to_string(button)}); }
    // Moves in steps, as a hand does, while keys are held.
    void drag(const Place& from, const Place& to, int button = 1, const std::vector<std::string>& held = {});
    void wheel(int clicks);                                        // > 0: away from the person
    void key(const std::string& name) { xdotool({"key", name}); }  // as xdotool calls it: "ctrl+z", "F12"
    void keys(const std::vector<std::string>& names);              // one after the other, faster than redraws
    void key_many(const std::string& name, int times) { keys(std::vector<std::string>(static_cast<std::size_t>(times), name)); }
    void key_down(const std::string& name) { xdotool({"keydown", name}); }
    void key_up(const std::string& name) { xdotool({"keyup", name}); }
    void type(const std::string& text) { xdotool({"type", "--delay", "1", "--", text}); }
    void resize(int width, int height);  // the window
    void press_close_button() { server_.press_close_button(); }
    bool drop(const std::vector<std::string>& paths);

    // Whether the last redraw had a widget, and its rectangle: left, top, right, bottom.
    bool draws(const std::string& widget) { return at("widgets").contains(widget); }
    std::vector<double> rectangle(const std::string& widget);
    // The middle of a widget, once it is drawn; `along`: 0 its left end, 1 its right.
    Place widget(const std::string& name, double along = 0.5);
    void click_widget(const std::string& name) { click(widget(name)); }
    // Opens a menu and clicks an item, or opens a menu in that menu and clicks its item.
    void choose(const std::string& menu, const std::string& item);

    // Where the window shows a pixel of its picture; or a point of the default screen: (0, 0) is the middle, 50 a half of the
    // shorter side.
    Place pixel(double x, double y);
    Place on_screen(double x, double y);
    // What the window's picture shows now: read off the screen.
    Picture picture();

    // Waits for the program's end.
    Outcome wait_for_end() { return program_->wait(); }
    void send(int signal_number) { program_->send(signal_number); }
    XServer& server() { return server_; }
    // What the program has used of a processor so far, in seconds.
    double processor_seconds() const { return program_->processor_seconds(); }

private:
    void xdotool(std::vector<std::string> arguments);
    bool read_log();

    const TemporaryFolder& folder_;
    XServer server_;
    std::optional<Running> program_;
    std::size_t log_at_ = 0;
    std::string partial_;
    Json redraw_;
    std::string step_;
};

// All redraws of the window, the first first.
std::vector<Json> logged_redraws(const TemporaryFolder& folder);

// Whether two pictures are equal; says how many pixels differ and where the first is.
testing::AssertionResult same_picture(const Picture& found, const Picture& expected);

}  // namespace sphereview::test

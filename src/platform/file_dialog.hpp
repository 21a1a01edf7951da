// The desktop's own file dialog, where it has a program for that.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sphereview {

struct FileFilter {
    std::string name;                  // "Scenes"
    std::vector<std::string> endings;  // ".toml", ".txt"; empty: all files
};

struct FileDialogRequest {
    bool saving = false;  // a name may be new; the dialog asks before an existing file is taken
    std::string title;
    std::string folder;               // where it begins, absolute
    std::string name;                 // suggested, "" for none
    std::vector<FileFilter> filters;  // the first is chosen at the beginning
};

struct FileChosen {
    std::string path;
};
struct FileDialogCancelled {};
struct FileDialogFailed {
    std::string reason;  // one line
};

// A dialog of zenity or kdialog, in a process of its own. SPHEREVIEW_FILE_DIALOG=none in the environment says that there is
// none, for people who prefer the program's own browser.
class SystemFileDialog {
public:
    using Result = std::variant<FileChosen, FileDialogCancelled, FileDialogFailed>;

    static bool available();

    // Opens the dialog and returns. `on_end` is called, from another thread, when there is a result; never after destruction,
    // which it must not begin itself.
    SystemFileDialog(const FileDialogRequest& request, std::function<void()> on_end);
    ~SystemFileDialog();  // closes the dialog
    SystemFileDialog(const SystemFileDialog&) = delete;
    SystemFileDialog& operator=(const SystemFileDialog&) = delete;

    // Nothing while the person has not answered.
    std::optional<Result> result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sphereview

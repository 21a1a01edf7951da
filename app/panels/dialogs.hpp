// Questions that the person must answer before anything else.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// A question with some answers, asked one at a time. `answer` is called from draw_dialog() with the number of the answer that was
// chosen; Escape and the close button choose `cancel`, Enter the first.
struct Question {
    std::string id;  // for tests: "save-changes"
    std::string title;
    std::string text;
    std::vector<std::string> answers;
    int cancel = 0;
    std::function<void(int)> answer;
};

// "Export picture": a name and a size. `accept` gets them; it may put another question (the file exists).
struct ExportForm {
    std::string path;
    int width = 1000;
    int height = 1000;
    std::string error;  // shown when not empty: why the last try did not work
    std::function<void(const std::string& path, PictureSize size)> accept;
};

// A file browser of our own, for where the system has no dialog of its own.
struct FileBrowser {
    bool saving = false;  // a name may be new
    std::string title;
    std::string folder;  // absolute
    std::string name;
    std::vector<std::string> endings;  // shown files: ".txt", ".toml"; empty: all
    std::string listed_folder;         // of `entries`
    struct Entry {
        std::string name;
        bool is_folder = false;
    };
    std::vector<Entry> entries;
    std::string error;
    std::function<void(const std::string& path)> accept;
};

using Dialog = std::variant<Question, ExportForm, FileBrowser>;

// Of the dialog, for tests: a question's id, "export", "browser".
std::string id_of(const Dialog& dialog);

// The dialogs that wait; the last is the one that is shown.
using Dialogs = std::vector<Dialog>;

// Draws the last dialog, in the middle of the window, above everything. Takes it away when it is answered, before it calls
// what was to be called, which may put others.
void draw_dialogs(const PanelContext& context, Dialogs& dialogs);

}  // namespace sphereview

// Questions that the person must answer before anything else.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "panels/film_form.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// A question with some answers, at least one, asked one at a time. `answer` is called from draw_dialogs() with the number of the
// answer that was chosen; Escape and the close button choose `cancel`, Enter the focused one: the first, until the keyboard moves
// on. Widgets: "answer 0" and "answer Save".
struct Question {
    std::string id{};  // for tests: "save-changes"
    std::string title{};
    std::string text{};
    std::vector<std::string> answers{};
    int cancel = 0;
    std::function<void(int)> answer{};
    int focused = 0;
};

// Whether what is there may be replaced: `answer` gets true for yes. Enter alone says no.
Question replace_question(const std::string& title, const std::string& text, std::function<void(bool)> answer);

// What a folder holds.
struct FileEntry {
    std::string name;
    bool is_folder = false;
    std::uint64_t bytes = 0;
    std::int64_t changed = 0;  // seconds since 1970
};

// How entries are sorted: folders always come first.
enum class FileColumn { name, size, date };
struct FileOrder {
    FileColumn by = FileColumn::name;
    bool descending = false;

    bool operator==(const FileOrder&) const = default;
};

// Whether a picture gets what the window shows over its own: "axes and scale bar".
struct MarksChoice {
    std::string words;
    bool drawn = false;
};

// Files that belong together: "TOML" with ".toml".
struct FileKind {
    std::string name;
    std::vector<std::string> endings;  // none: all files
    std::string part{};                // a name of this kind has this in it, too
    std::string usual{};               // the name that a file of this kind gets instead of one of a kind with another part
};

// The file dialog. `accept` gets an absolute path; a new one only when `saving`, an existing one then only when the person agrees
// to replace it. With a `size` the file is a picture, whose size is chosen, too: at first that one; with a `film` as well it is a
// film, or several pictures. Widgets: those of panels/film_form.hpp, "browser path",
// "browser name", "browser ok", "browser cancel", "browser up", "browser home", "place 0", "browser hidden", "browser kind",
// "browser kind TOML (.toml)", "browser sort name" ("size", "date"), "entry NAME", "export width", "export height", "export sizes",
// "export 1920 x 1080", "export view", "export marks".
struct FileBrowser {
    bool saving = false;  // a name may be new
    std::string title;
    std::string folder;  // absolute; "" for the home folder
    std::string name;
    // One of them is chosen. To open, the files of that one are shown; to save, those of all: there the name's ending chooses, and
    // a name with none of the endings gets the first of the chosen kind.
    std::vector<FileKind> kinds;
    std::size_t kind = 0;
    bool only_kinds = false;          // so does the name of a file that is there, before anyone is asked whether to replace it
    std::vector<std::string> places;  // folders to go to by a click
    std::optional<PictureSize> size;
    std::shared_ptr<FilmForm> film{};        // with a size
    std::shared_ptr<MarksChoice> marks{};    // likewise, and without a film, which has its own
    PictureSize view;                        // of the picture in the window, for a button
    std::int64_t most_pixels = 429'496'729;  // as image/image.hpp has it
    std::string error;                       // what is wrong, or why the last try did not work
    std::function<void(const std::string& path, PictureSize size)> accept;

    // What the dialog remembers from redraw to redraw.
    std::vector<FileEntry> entries;
    std::string listed_folder;  // of `entries`
    std::size_t listed_kind = 0;
    bool listed_hidden = false;  // whether `entries` has hidden files
    FileOrder order;
    bool hidden_files = false;                                  // shown too
    bool to_top = false;                                        // the list begins at its top in the next redraw
    std::string typed_folder;                                   // what the path box holds
    float below_list = 0.0F;                                    // how high what stands below the list was
    enum class Focus { none, name, path } focus = Focus::name;  // the box that gets the keyboard in the next redraw
};

// Why no picture can be of the size; "" if one can, or there is no size.
std::string size_fault(const FileBrowser& browser);

using Dialog = std::variant<Question, FileBrowser>;

// Of the dialog, for tests: a question's id, "export", "film", "browser".
std::string id_of(const Dialog& dialog);

// Dialogs that wait for an answer. Only the last can be answered; the others lie dimmed below.
using Dialogs = std::vector<Dialog>;

// The keys that were pressed, not repeated, since the last redraw.
struct DialogKeys {
    bool enter = false;
    bool escape = false;
    int step = 0;  // through a question's answers: Right and Tab +1, Left and Shift+Tab -1; unless typing somewhere
};

// Draws the dialogs in the middle of the window, above everything. Removes the last one when it is answered, and then calls
// its callback, which may add dialogs. Not movable: callbacks hold references to `dialogs` while it is not empty.
void draw_dialogs(const PanelContext& context, Dialogs& dialogs, const DialogKeys& keys);

// What follows is what the dialogs share: for dialogs.cpp and file_browser.cpp.

// What the person decided in this redraw.
struct Decision {
    bool done = false;           // the dialog goes away
    std::function<void()> then;  // called after all dialogs are drawn and this one, if done, is gone; may add dialogs
};

// Each draws the content of its dialog. `keys`: none but for the dialog on top.
Decision draw_content(const PanelContext& context, Question& question, const DialogKeys& keys, Dialogs& dialogs);
Decision draw_content(const PanelContext& context, FileBrowser& browser, const DialogKeys& keys, Dialogs& dialogs);

// Draws the fields for the size, on a line.
void draw_size(const PanelContext& context, FileBrowser& browser);

// Draws the text in red, a few lines high at most; nothing for "". fault_height(): of what is drawn, in pixels.
void draw_fault(const std::string& text, float width);
float fault_height(const std::string& text, float width);

// The two buttons at the end of a form, noted as "NAME ok" and "NAME cancel". Enter is the first, Escape the second; `ok` can be
// pressed only if `possible`.
enum class FormEnd { open, ok, cancel };
FormEnd draw_form_end(const PanelContext& context, const std::string& name, const char* ok, bool possible, const DialogKeys& keys);
// How wide the two are.
float form_end_width(const PanelContext& context);

}  // namespace sphereview

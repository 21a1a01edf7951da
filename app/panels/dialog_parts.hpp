// What the dialogs share; for dialogs.cpp and the files of the dialogs.
#pragma once

#include <functional>
#include <string>

#include "panels/dialogs.hpp"

namespace sphereview {

// What the person decided in this frame.
struct Decision {
    bool done = false;           // the dialog goes away
    std::function<void()> then;  // called after all dialogs are drawn and this one, if done, is gone; may add dialogs
};

// Each draws the content of its dialog. `keys`: none but for the dialog on top.
Decision draw_content(const PanelContext& context, Question& question, const DialogKeys& keys, Dialogs& dialogs);
Decision draw_content(const PanelContext& context, ExportForm& form, const DialogKeys& keys, Dialogs& dialogs);
Decision draw_content(const PanelContext& context, FileBrowser& browser, const DialogKeys& keys, Dialogs& dialogs);

// Asks whether a file may be replaced. If so, the dialog below the question goes away, and `then` is called.
void ask_to_replace(Dialogs& dialogs, const std::string& path, std::function<void()> then);

// Wrapped text; what is higher than `most` is scrolled, so that the buttons below stay in the window.
void draw_text(const std::string& text, float width, float most);

// Draws the text in red, a few lines high at most; nothing for "". fault_height(): of what is drawn, in pixels.
void draw_fault(const std::string& text, float width);
float fault_height(const std::string& text, float width);

// The two buttons at the end of a form, noted as "NAME ok" and "NAME cancel". Enter is the first, Escape the second; `ok` can be
// pressed only if `possible`.
enum class FormEnd { open, ok, cancel };
FormEnd draw_form_end(const PanelContext& context, const std::string& name, const char* ok, bool possible, const DialogKeys& keys);

}  // namespace sphereview

#include "platform/file_dialog.hpp"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

#include "base/child_process.hpp"

namespace sphereview {

namespace {

struct Program {
    std::string path;
    bool is_kdialog = false;
};

std::string_view environment(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? std::string_view() : value;
}

bool desktop_is_kde() {
    std::string_view desktops = environment("XDG_CURRENT_DESKTOP");  // "ubuntu:GNOME"
    while (!desktops.empty()) {
        const std::size_t end = std::min(desktops.find(':'), desktops.size());
        if (desktops.substr(0, end) == "KDE") return true;
        desktops.remove_prefix(std::min(end + 1, desktops.size()));
    }
    return false;
}

// The desktop's own first. An empty path where there is none.
Program dialog_program() {
    if (environment("SPHEREVIEW_FILE_DIALOG") == "none") return {};
    const Program zenity{find_program("zenity"), false};
    const Program kdialog{find_program("kdialog"), true};
    if (desktop_is_kde()) return kdialog.path.empty() ? zenity : kdialog;
    return zenity.path.empty() ? kdialog : zenity;
}

// "*.toml *.txt"
std::string patterns(const FileFilter& filter) {
    if (filter.endings.empty()) return "*";
    std::string text;
    for (const std::string& ending : filter.endings) text += (text.empty() ? "*" : " *") + ending;
    return text;
}

// The folder with a slash behind it stands for itself.
std::string start_of(const FileDialogRequest& request) {
    return request.folder + (request.folder.ends_with('/') ? "" : "/") + request.name;
}

std::vector<std::string> zenity_arguments(const FileDialogRequest& request) {
    std::vector<std::string> arguments = {"--file-selection", "--title=" + request.title, "--filename=" + start_of(request)};
    if (request.saving) {
        arguments.emplace_back("--save");
        arguments.emplace_back("--confirm-overwrite");
    }
    for (const FileFilter& filter : request.filters) {
        arguments.push_back("--file-filter=" + filter.name + " | " + patterns(filter));
    }
    return arguments;
}

std::vector<std::string> kdialog_arguments(const FileDialogRequest& request) {
    std::string filters;
    for (const FileFilter& filter : request.filters) {
        filters += (filters.empty() ? "" : "\n") + filter.name + " (" + patterns(filter) + ")";
    }
    return {"--title", request.title, request.saving ? "--getsavefilename" : "--getopenfilename", start_of(request), filters};
}

// What ended it comes last, after warnings.
std::string last_line(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

SystemFileDialog::Result meaning(const ChildResult& child, const std::string& program) {
    using End = ChildResult::End;
    const std::string said = last_line(child.errors);
    const std::string because = said.empty() ? "" : ": " + said;
    if (child.end == End::not_started) return FileDialogFailed{program + " cannot be started" + because};
    if (child.end != End::exited) return FileDialogFailed{program + " was ended by signal " + std::to_string(child.code)};
    if (child.code == 0) {
        std::string path = child.output;
        if (path.ends_with('\n')) path.pop_back();
        if (path.empty()) return FileDialogFailed{program + " names no file" + because};
        return FileChosen{std::move(path)};
    }
    // GTK also ends with 1 where it cannot show anything; what else it says are warnings.
    const bool no_display = child.errors.find("open display") != std::string::npos;
    if (child.code == 1 && !no_display) return FileDialogCancelled{};
    return FileDialogFailed{program + " failed with status " + std::to_string(child.code) + because};
}

}  // namespace

struct SystemFileDialog::State {
    State(const Program& program, const FileDialogRequest& request, std::function<void()> call)
        : name(program.path.empty() ? "zenity or kdialog"
               : program.is_kdialog ? "kdialog"
                                    : "zenity"),
          on_end(std::move(call)),
          child(program.path, program.is_kdialog ? kdialog_arguments(request) : zenity_arguments(request),
                ChildProcess::Group::own),
          thread([this] { run(); }) {}

    void run() {
        Result answer = meaning(child.wait({}), name);
        {
            const std::lock_guard lock(mutex);
            if (ending) return;
            result = std::move(answer);
        }
        on_end();
    }

    std::string name;
    std::function<void()> on_end;
    ChildProcess child;
    mutable std::mutex mutex;  // of what follows
    bool ending = false;
    std::optional<Result> result;
    std::thread thread;  // last: it uses the others
};

bool SystemFileDialog::available() { return !dialog_program().path.empty(); }

SystemFileDialog::SystemFileDialog(const FileDialogRequest& request, std::function<void()> on_end)
    : state_(std::make_unique<State>(dialog_program(), request, std::move(on_end))) {}

SystemFileDialog::~SystemFileDialog() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->ending = true;
    }
    state_->child.kill();
    state_->thread.join();
}

std::optional<SystemFileDialog::Result> SystemFileDialog::result() const {
    const std::lock_guard lock(state_->mutex);
    return state_->result;
}

}  // namespace sphereview

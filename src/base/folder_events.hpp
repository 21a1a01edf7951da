// What the system tells of folders, and waiting for it: inotify on Linux.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sphereview {

struct FolderEvent {
    enum class What {
        created,  // a name came up; what is behind it may not be written yet
        written,  // it is being written
        closed,   // it was written, and the writer is done
        moved_in,
        gone,  // deleted or moved away
        lost,  // the folder itself is not what it was, or events were lost; no name
    };

    int folder = -1;  // of add(); -1 for all
    What what = What::lost;
    std::string name;
    bool is_folder = false;
};

class FolderEvents {
public:
    // `from_system`: else there are no events, only waiting.
    explicit FolderEvents(bool from_system);
    ~FolderEvents();
    FolderEvents(const FolderEvents&) = delete;
    FolderEvents& operator=(const FolderEvents&) = delete;

    // The folder's number, the same for all paths to it; nothing where the system will not tell. From any thread.
    std::optional<int> add(const std::filesystem::path& folder);
    void remove(int folder);

    // Waits until something happens, wake() was called or `until` has come; nothing: without end.
    std::vector<FolderEvent> wait(std::optional<std::chrono::steady_clock::time_point> until);

    // Makes wait() return, now or the next time. From any thread.
    void wake();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace sphereview

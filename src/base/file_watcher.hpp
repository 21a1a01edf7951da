// Noticing that files change on disk.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sphereview {

// Watches files from a thread of its own. A file that is replaced by a rename, or deleted and written again, is followed by
// its name, also through symbolic links. On Linux the system tells (inotify on the folders), and the thread sleeps until then;
// elsewhere, and where that fails, it looks twice a second at time, size and identity.
class FileWatcher {
public:
    enum class Method { system, looking };

    // `on_change` is called from the watcher's thread whenever take_changed() may have something to say.
    explicit FileWatcher(std::function<void()> on_change, Method method = Method::system);
    ~FileWatcher();
    FileWatcher(const FileWatcher&) = delete;
    FileWatcher& operator=(const FileWatcher&) = delete;

    // The files to watch from now on, instead of those before. A folder stands for all files in it.
    void watch(std::vector<std::string> paths);

    // Which of them were written, replaced or created, and then left alone (closed, or unchanged for a moment), since the
    // last call, as they were named to watch(). Whether the content is another is for the caller to see.
    std::vector<std::string> take_changed();

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace sphereview

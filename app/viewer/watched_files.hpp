// The files that the viewer follows: the scene's and the shaders.
#pragma once

#include <string>

#include "base/file_watcher.hpp"
#include "platform/window.hpp"

namespace sphereview {

class WatchedFiles {
public:
    explicit WatchedFiles(std::string shader_folder) : watcher_(Window::wake), shader_folder_(std::move(shader_folder)) {}

    // Follows another scene from now on, if it is another.
    void follow_scene(const std::string& path) {
        if (path == scene_ && started_) return;
        started_ = true;
        scene_ = path;
        std::vector<std::string> paths;
        if (!scene_.empty()) paths.push_back(scene_);
        if (!shader_folder_.empty()) paths.push_back(shader_folder_);
        watcher_.watch(std::move(paths));
    }

    struct Changes {
        bool scene = false;
        bool shaders = false;
    };
    Changes take() {
        Changes changes;
        for (const std::string& path : watcher_.take_changed()) (path == scene_ ? changes.scene : changes.shaders) = true;
        return changes;
    }

private:
    FileWatcher watcher_;
    std::string shader_folder_;
    std::string scene_;
    bool started_ = false;
};

}  // namespace sphereview

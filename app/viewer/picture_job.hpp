// Pictures as `render` writes them, made beside the window's loop: what the window shows at rest, and PNG files.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/render_picture.hpp"
#include "base/background_job.hpp"
#include "image/image.hpp"

namespace sphereview {

struct ViewerState;

// The spheres as they were, for other threads.
struct SceneSnapshot {
    std::uint64_t revision = 0;  // of the document; 0: none
    std::shared_ptr<const Scene> scene;
};

// The picture that the window shows at rest.
struct RestPicture {
    std::uint64_t revision;  // of the document that it is of
    PictureOptions options;
    std::shared_ptr<Image> image;  // empty until the job has ended, and if it failed
    BackgroundJob job;

    bool is_made() const { return job.ended() && image->width() > 0; }
};

// A PNG file that is being made.
struct Exporting {
    std::string path;
    PictureOptions options;
    std::shared_ptr<std::string> png;
    BackgroundJob job;
    std::function<void(const std::string& why)> fail;
    std::function<void()> then = [] {};  // called once the file is whole
};

// What `render` would be asked for the picture in the window, or for one of another size.
PictureOptions picture_options(const ViewerState& state, PictureSize size);

// Forgets the window's rest picture, and cancels its job, if the window has come to show something else. Returns whether what is
// left is finished: then the window shows that.
bool rest_picture_is_shown(ViewerState& state);

// Begins to make it, if it is not there, nor any other picture being made. To be called when the window rests.
void make_rest_picture(ViewerState& state);

// Begins to write a file; none may be on its way. `fail` is called with what went wrong, now or later.
void start_export(ViewerState& state, const std::string& path, PictureSize size, std::function<void(const std::string& why)> fail);

// Acts on an export that has ended. Returns whether one has.
bool finish_export(ViewerState& state);

}  // namespace sphereview

// File > Compare with picture: `sphereview compare` beside the window's loop.
#pragma once

#include <memory>
#include <string>

#include "image/image.hpp"
#include "panels/comparison.hpp"

namespace sphereview {

struct ViewerState;

// A comparison as it is shown.
struct ShownComparison {
    ComparisonWords words;
    // Null for an equal picture.
    std::shared_ptr<const Image> difference{};
    std::shared_ptr<const Image> found{};
    std::shared_ptr<const Image> right{};
    ComparisonView view{};

    const std::shared_ptr<const Image>& shown() const {
        return view.picture == ComparedPicture::found ? found : view.picture == ComparedPicture::right ? right : difference;
    }
};

// Asks for a picture, then compares it.
void ask_for_comparison(ViewerState& state);

// Begins to compare a picture with the right one of the present scene by its own camera. Cancels an earlier comparison. Shows an
// error if that is impossible.
void compare_with(ViewerState& state, const std::string& path);

}  // namespace sphereview

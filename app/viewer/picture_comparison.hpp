// File > Compare with picture: what `sphereview compare` does, beside the window's loop.
#pragma once

#include <memory>
#include <string>

#include "image/image.hpp"
#include "panels/comparison.hpp"

namespace sphereview {

struct ViewerState;

// What is shown of a comparison.
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

// Begins to compare the picture with the right one of the scene as it is now, seen by the scene's own camera, instead of what is
// being compared now. Says why where that cannot be done.
void compare_with(ViewerState& state, const std::string& path);

}  // namespace sphereview

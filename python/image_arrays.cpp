#include "python/image_arrays.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "base/error.hpp"

namespace sphereview {

namespace py = pybind11;

py::array array_of(Image&& image) {
    auto owner = std::make_unique<Image>(std::move(image));
    const std::array<py::ssize_t, 3> shape{owner->height(), owner->width(), owner->channels()};
    std::uint8_t* const bytes = owner->bytes().data();
    const py::capsule keeper(owner.get(), [](void* kept) { delete static_cast<Image*>(kept); });
    owner.release();
    return py::array_t<std::uint8_t>(shape, bytes, keeper);
}

Image image_from(const py::array_t<std::uint8_t, py::array::c_style>& array) {
    const auto side = [&](int axis) { return array.shape(axis) >= 1 && array.shape(axis) <= most_pixels; };
    const bool good = array.ndim() == 3 && side(0) && side(1) && array.shape(0) <= most_pixels / array.shape(1) &&
                      (array.shape(2) == 3 || array.shape(2) == 4);
    if (!good) {
        throw InputError("expected a picture of the shape (height, width, 3) or (height, width, 4), of at most " +
                         std::to_string(most_pixels) + " pixels");
    }
    Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)), static_cast<int>(array.shape(2)));
    std::copy_n(array.data(), array.size(), image.bytes().data());
    return image;
}

}  // namespace sphereview

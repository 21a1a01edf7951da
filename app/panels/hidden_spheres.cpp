#include "panels/hidden_spheres.hpp"

namespace sphereview {

std::size_t HiddenSpheres::count(const Document& document) {
    if (revision_ == document.revision()) return count_;
    const std::vector<Sphere>& spheres = document.scene().spheres;
    const auto look_at = [&](std::size_t number) {
        const bool hidden = spheres[number].hidden;
        if (hidden && !hidden_[number]) ++count_;
        if (!hidden && hidden_[number]) --count_;
        hidden_[number] = hidden;
    };
    ChangesSince changes;
    if (revision_ != 0) changes = document.changes_since(revision_);
    if (revision_ == 0 || changes.order) {
        hidden_.assign(spheres.size(), false);
        count_ = 0;
        for (std::size_t number = 0; number < spheres.size(); ++number) look_at(number);
    } else {
        for (const std::uint32_t number : changes.spheres) look_at(number);
    }
    revision_ = document.revision();
    return count_;
}

}  // namespace sphereview

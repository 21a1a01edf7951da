// Drawn spheres and their lists, which follow a scene's edits at a cost in proportion to the edited spheres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "edit/change_log.hpp"
#include "exact/drawn.hpp"
#include "scene/camera.hpp"
#include "scene/scene.hpp"
#include "tiles/edited_lists.hpp"

namespace sphereview {

// After any edits a renderer finds in them what it would find in lists that are built from nothing. follow() says when only
// building from nothing will do: more than most_changes spheres changed, a sphere equals another or hides an equal one, a sphere
// is beyond float, or a tile has no room.
class LiveLists {
public:
    // The most spheres that may change at once, and the most gaps and late indices.
    static constexpr std::size_t most_changes = DrawnSpheres::room_for_late;

    LiveLists() = default;
    // `lists`: of the spheres and the camera.
    LiveLists(DrawnSpheres drawn, EditedLists lists, const Camera& camera);
    // The same spheres seen by another camera or on another grid. Only while edited() is false.
    void replace_lists(EditedLists lists, const Camera& camera);

    const DrawnSpheres& drawn() const { return drawn_; }
    const CandidateLists& lists() const { return lists_.lists(); }
    // Whether the scene may differ from the one that the lists were built of.
    bool edited() const { return edited_; }

    // Takes over the changes, apart from colours, that led to the present `scene`. False when building anew is the only or the
    // quicker way; then the object is of no use, and every later call returns false.
    bool follow(const Scene& scene, const ChangesSince& changes);

    // What changed since the last call: indices of drawn spheres, ascending, and places among the candidates.
    struct Changed {
        std::vector<std::uint32_t> spheres;
        std::vector<Places> candidates;
    };
    Changed take_changed();

private:
    bool take_over(const Scene& scene, const ChangesSince& changes);
    bool change(const Scene& scene, std::uint32_t number);
    bool remove(const Scene& scene, const std::vector<std::uint32_t>& numbers);
    bool take_out(const Scene& scene, std::size_t index);
    bool put_in(const Scene& scene, std::uint32_t number, std::optional<std::size_t> index, const glm::vec4& values);

    DrawnSpheres drawn_;
    EditedLists lists_;
    Camera camera_;
    std::size_t built_size_ = 0;
    bool edited_ = false;
    bool whole_ = true;  // false: follow() has failed, and spheres and lists do not fit together
    std::vector<std::uint32_t> changed_spheres_;
};

}  // namespace sphereview

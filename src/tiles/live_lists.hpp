// A scene as renderers take it, with its lists, that follows edits in proportion to what they touch.
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

// Built anew now and then, always when it says so: what it finds after edits, all find that build everything anew.
class LiveLists {
public:
    // How many spheres may change at once, and how many gaps and late indices may gather.
    static constexpr std::size_t most_changes = DrawnSpheres::room_for_late;

    LiveLists() = default;
    // `lists`: of the spheres and the camera.
    LiveLists(DrawnSpheres drawn, EditedLists lists, const Camera& camera);
    // The same spheres again, but seen otherwise; if nothing was edited.
    void replace_lists(EditedLists lists, const Camera& camera);

    const DrawnSpheres& drawn() const { return drawn_; }
    const CandidateLists& lists() const { return lists_.lists(); }
    // Whether anything of the scene may be another than when this was built.
    bool edited() const { return edited_; }

    // Takes over how `scene`, as it is now, differs from the one that this is of, but for colours. False where building anew is
    // the only or the quicker way; then this is of no use any more, and it stays false.
    bool follow(const Scene& scene, const ChangesSince& changes);

    // What changed since this was asked last: indices of spheres, ascending, and places among the candidates.
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
    bool whole_ = true;  // what is drawn and what is listed fit together
    std::vector<std::uint32_t> changed_spheres_;
};

}  // namespace sphereview

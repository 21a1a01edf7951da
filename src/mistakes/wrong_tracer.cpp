#include "mistakes/wrong_tracer.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace sphereview {

Camera seen_wrongly(Camera camera, const WrongTracer& tracer, PictureSize size) {
    if (tracer.orientation == Orientation::y_down || tracer.orientation == Orientation::turned) camera.up = -camera.up;
    if (tracer.orientation == Orientation::x_mirrored || tracer.orientation == Orientation::turned) camera.right = -camera.right;
    if (tracer.orientation == Orientation::swapped) std::tie(camera.right, camera.up) = std::pair(-camera.up, -camera.right);

    const glm::dvec3 half_column = camera.right / static_cast<double>(size.shorter_side());
    const glm::dvec3 half_row = camera.up / static_cast<double>(size.shorter_side());
    const auto move = [&camera](const glm::dvec3& way) {
        camera.center += way;
        if (camera.orthographic()) camera.eye += way;  // the direction stays
    };
    switch (tracer.place) {
        case RayPlace::center: break;
        case RayPlace::top_left: move(half_row - half_column); break;
        case RayPlace::top_right: move(half_row + half_column); break;
        case RayPlace::bottom_left: move(-half_row - half_column); break;
        case RayPlace::bottom_right: move(half_column - half_row); break;
        case RayPlace::edges:
            camera.right *= size.width / std::max(size.width - 1.0, 1.0);
            camera.up *= size.height / std::max(size.height - 1.0, 1.0);
            break;
        case RayPlace::stretched:
            camera.right *= static_cast<double>(size.shorter_side()) / size.width;
            camera.up *= static_cast<double>(size.shorter_side()) / size.height;
            break;
    }
    return camera;
}

std::vector<WrongTracer> with_one_more_mistake(const WrongTracer& tracer, PictureSize size) {
    std::vector<WrongTracer> more;
    const bool square = size.width == size.height;
    // The mistakes of one kind, where there is none yet.
    const auto add = [&]<typename Kind>(Kind WrongTracer::*kind, std::size_t count, const auto& can_differ) {
        if (tracer.*kind != Kind{}) return;
        for (std::size_t i = 1; i < count; ++i) {
            WrongTracer wrong = tracer;
            wrong.*kind = static_cast<Kind>(i);
            if (can_differ(wrong)) more.push_back(wrong);
        }
    };
    // Of two mistakes with the same picture only the first is named. If hits behind the eye count, so do spheres around it.
    const auto is_possible = [](const WrongTracer& wrong) {
        return wrong.side == SideRule::in_front || wrong.root != RootRule::inside_missed;
    };
    const auto any = [](const WrongTracer&) { return true; };
    add(&WrongTracer::root, root_rule_words.size(), is_possible);
    add(&WrongTracer::side, side_rule_words.size(), is_possible);
    add(&WrongTracer::discriminant, discriminant_rule_words.size(), any);
    add(&WrongTracer::rule, hit_rule_words.size(), any);
    add(&WrongTracer::orientation, orientation_words.size(),
        [&](const WrongTracer& wrong) { return square || wrong.orientation != Orientation::swapped; });
    add(&WrongTracer::place, ray_place_words.size(),
        [&](const WrongTracer& wrong) { return !square || wrong.place != RayPlace::stretched; });
    return more;
}

std::vector<MistakeWords> mistakes_of(const WrongTracer& tracer) {
    std::vector<MistakeWords> all = {orientation_words[static_cast<std::size_t>(tracer.orientation)],
                                     ray_place_words[static_cast<std::size_t>(tracer.place)],
                                     root_rule_words[static_cast<std::size_t>(tracer.root)],
                                     side_rule_words[static_cast<std::size_t>(tracer.side)],
                                     discriminant_rule_words[static_cast<std::size_t>(tracer.discriminant)],
                                     hit_rule_words[static_cast<std::size_t>(tracer.rule)]};
    std::erase_if(all, [](const MistakeWords& words) { return words.name.empty(); });
    return all;
}

}  // namespace sphereview

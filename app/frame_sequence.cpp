#include "app/frame_sequence.hpp"

#include <algorithm>
#include <utility>

#include "app/kept_fit.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "camera/fit.hpp"
#include "formats/atoms.hpp"
#include "light/light_set.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

void append(std::string& text, double number) { text += shortest(number) + " "; }

void append(std::string& text, const Camera& camera) {
    for (const glm::dvec3& v : {camera.eye, camera.center, camera.right, camera.up}) {
        for (int i = 0; i < 3; ++i) append(text, v[i]);
    }
    text += name_of(camera.projection);
}

// A few spheres of a frame, and how far the camera has turned when it sees them.
struct SeenSpheres {
    std::vector<Sphere> spheres;
    double degrees;
};

}  // namespace

std::vector<Shot> shots_of(const std::vector<std::int64_t>& frames, std::int64_t turntable) {
    std::vector<Shot> shots;
    const bool one_frame = frames.size() == 1 && turntable > 0;
    const auto count = one_frame ? turntable : static_cast<std::int64_t>(frames.size());
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t frame = one_frame ? frames[0] : frames[static_cast<std::size_t>(i)];
        shots.push_back({one_frame ? i : frame, frame, turntable > 0 ? degrees_of(i, turntable) : 0.0});
    }
    return shots;
}

FrameSequence::FrameSequence(const std::string& path, const RenderOptions& options, Progress& progress)
    : options_(options),
      look_(options.look),
      knows_range_(options.look.range.has_value()),
      knows_scale_(options.look.scale.has_value()),
      knows_order_(options.look.order.has_value()) {
    reader_.emplace(path, with_properties(options.data, options.look));
    progress.start(reader_->name() + ": looking for frames");
    reader_->watch([&progress](double done) { progress.update(done); });
    std::vector<FrameRange> ranges = options.frames.ranges;
    if (ranges.empty()) ranges = {{options.data.frame, {}, 1, true}};
    const auto frames = [&] {
        try {
            return frames_in(ranges, reader_->name(), [this](std::int64_t enough) { return reader_->count(enough); });
        } catch (const InputError& error) {
            if (reader_->fault().empty()) throw;
            throw InputError(error.what() + ("; " + reader_->fault()));  // why there are no more
        }
    }();
    reader_->watch({});
    progress.clear();
    is_damaged_ = reader_->is_damaged();  // up to the frames that are asked for
    if (!reader_->fault().empty()) early_end_ = sphereview::early_end(reader_->fault(), reader_->count());
    shots_ = shots_of(frames, options.frames.turntable);
}

FrameSequence::FrameSequence(LoadedScene scene, const RenderOptions& options)
    : options_(options),
      look_(options.look),
      shots_(shots_of({0}, options.frames.turntable)),
      present_(std::move(scene)),
      present_frame_(0) {}

// Up to the first of the list of which `is_it` is true. What is wrong with a frame on the way, its own picture says.
template <typename IsIt>
void FrameSequence::look_through(const IsIt& is_it) {
    std::int64_t before = -1;  // around one frame go many shots
    for (const Shot& shot : shots_) {
        if (shot.frame == std::exchange(before, shot.frame)) continue;
        try {
            if (is_it(shot.frame)) return;
        } catch (const ReadError&) {
            throw;  // what is wrong with the file concerns all frames
        } catch (const InputError&) {
        }
    }
}

// One radius for all points: made of each frame's own distances it would come and go.
SphereData FrameSequence::read_data(std::int64_t frame) {
    SphereData data = reader_->read(frame);
    if (!data.asks_for_radius || std::exchange(knows_radius_, true)) return data;
    std::int64_t present = frame;
    look_through([&](std::int64_t other) {
        if (std::exchange(present, other) != other) data = reader_->read(other);
        radius_ = data.radius_of_points;
        return radius_.has_value();
    });
    if (radius_) {
        reader_->set_radius_of_points(*radius_);
        radius_warnings_ = data.warnings;
    }
    return present == frame ? std::move(data) : reader_->read(frame);
}

const LoadedScene& FrameSequence::read(std::int64_t frame) {
    read_alone(frame);
    // One range, one scale and one order of categories for all: made of each frame's own values, colours and sizes would come and
    // go.
    const auto settle = [&](bool asks, bool& knows, const auto& take) {
        if (!asks || std::exchange(knows, true)) return;
        look_through([&](std::int64_t other) {
            read_alone(other);
            return take();
        });
        read_alone(frame);
    };
    const AppliedLook& look = present_.look;
    settle(look.coloring && !look.coloring->is_category(), knows_range_, [&] {
        look_.range_of_frames = look.found_range;
        return look_.range_of_frames.has_value();
    });
    settle(look.coloring && look.coloring->is_category(), knows_order_, [&] {
        if (look.coloring && look.coloring->is_category()) look_.order = look.coloring->order;
        return look_.order.has_value();
    });
    settle(look.sizing.has_value(), knows_scale_, [&] {
        look_.scale = look.found_scale;
        return look_.scale.has_value();
    });
    return present_;
}

void FrameSequence::read_alone(std::int64_t frame) {
    if (frame == present_frame_) return;
    present_frame_ = -1;
    present_ = {};
    SphereData data = read_data(frame);
    const std::size_t count = data.scene.spheres.size();
    require_memory_for_spheres(reader_->name(), count, bytes_to_draw_a_sphere);
    present_ = {std::move(data), reader_->name(), reader_->format()};
    hide_and_light(present_.scene, changes_);  // what is hidden counts for no range
    if (look_.any()) present_.look = apply_look(present_.scene, look_, present_.name, present_.property_names);
    color_and_size(present_.scene, changes_);
    present_frame_ = frame;
}

void FrameSequence::prepare(Progress& progress) {
    const LoadedScene& first = read(shots_.front().frame);
    middle_ = bounds_of(first.scene).middle();
    const FitOptions& fit = options_.fit;
    camera_ = chosen_camera(first, fit);
    fitted_ = is_to_fit(first, fit);
    const ViewAxes present = first.has_camera() || fit.camera ? axes_of(camera_) : data_axes;
    const ViewAxes axes = fitted_ ? with_hand_of(present, fit.view.value_or(present)) : axes_of(camera_);
    if (options_.frames.turntable > 0) turn_.emplace(axes, options_.frames.axis);
    if (fitted_) camera_ = fitted_camera(first, axes, progress);
    // While frames are read these are not looked at, which may be on another thread.
    append(shared_, camera_);  // from which the key light comes
    for (int i = 0; options_.scale_bar && i < 3; ++i) append(shared_, middle_[i]);
    if (look_.range_of_frames) {
        append(shared_, look_.range_of_frames->low);
        append(shared_, look_.range_of_frames->high);
    }
    for (const std::string& name : look_.order ? look_.order->names : std::vector<std::string>())
        shared_ += name + std::string(1, '\0');
    for (const std::optional<double>& number : {look_.scale, radius_}) shared_ += number ? shortest(*number) + " " : "- ";
}

std::string FrameSequence::sum_of(const Shot& shot) const {
    std::string text = shared_ + std::to_string(shot.frame) + " ";
    append(text, camera_of(shot));
    return sha256(text);
}

std::optional<std::string> FrameSequence::question_of_fit(const ViewAxes& axes) const {
    // What a person has changed has no words, and what the look makes of spheres has those of the command line.
    if (!changes_.spheres.empty() || (look_.any() && options_.words.empty())) return std::nullopt;
    std::string text(name_of(camera_.projection));
    for (const glm::dvec3& v : {axes.right, axes.up, axes.ahead}) {
        for (int i = 0; i < 3; ++i) append(text, v[i]);
    }
    text += std::to_string(options_.frames.turntable) + " " + std::to_string(static_cast<int>(options_.frames.axis)) + " ";
    text += (options_.data.radius ? shortest(*options_.data.radius) : "-") + (options_.data.virtual_sites ? " all\n" : " atoms\n");
    for (const std::string& word : look_.any() ? options_.words : std::vector<std::string>()) text += word + "\n";
    for (const Shot& shot : shots_) text += std::to_string(shot.frame) + " " + shortest(shot.degrees) + "\n";
    return sha256(text);
}

// Null for a frame that is wrong, which the camera need not see: its own picture says so. A film has no picture without that.
const LoadedScene* FrameSequence::read_to_fit(std::int64_t frame) {
    try {
        return &read(frame);
    } catch (const ReadError&) {
        throw;  // what is wrong with the file concerns all frames
    } catch (const InputError&) {
        if (options_.film.movie || options_.streams_film()) throw;
        return nullptr;
    }
}

// Sees everything in every shot.
Camera FrameSequence::fitted_camera(const LoadedScene& first, const ViewAxes& axes, Progress& progress) {
    const Projection projection = camera_.projection;
    const std::int64_t first_frame = shots_.front().frame;
    const std::string name = first.name;
    // Each frame once, and from each side once.
    std::set<std::pair<std::int64_t, double>> wanted;
    for (const Shot& shot : shots_) wanted.emplace(options_.frames.fit_first ? first_frame : shot.frame, shot.degrees);
    const bool are_frames = wanted.begin()->first != wanted.rbegin()->first;
    const std::optional<FileStamp> stamp = reader_ && are_frames ? reader_->stamp() : std::nullopt;
    const std::optional<std::string> question = stamp ? question_of_fit(axes) : std::nullopt;
    if (const auto kept = question ? read_fit(*stamp, *question) : std::nullopt) {
        middle_ = kept->middle;
        return kept->camera;
    }
    const std::optional<double> radius = radius_;
    const LookOptions look = look_;
    progress.start(name + ": fitting the camera", static_cast<double>(wanted.size()), "frame");
    std::vector<SeenSpheres> seen;
    Scene all;
    double done = 0.0;
    for (const auto& [frame, degrees] : wanted) {
        const ViewAxes turned = turn_ ? turn_->axes(axes, degrees) : axes;
        if (const LoadedScene* loaded = read_to_fit(frame)) {
            seen.push_back({outermost(loaded->scene, turned, projection), degrees});
            all.spheres.insert(all.spheres.end(), seen.back().spheres.begin(), seen.back().spheres.end());
        }
        progress.update(++done / static_cast<double>(wanted.size()));
    }
    progress.clear();
    middle_ = bounds_of(all).middle();
    if (turn_) {
        // Instead of the camera the spheres turn, the other way.
        all.spheres.clear();
        for (const SeenSpheres& some : seen) {
            for (Sphere sphere : some.spheres) {
                sphere.center = turn_->place(sphere.center, middle_, -some.degrees);
                all.spheres.push_back(sphere);
            }
        }
    }
    const Camera camera = fitted(all, axes, projection).value_or(camera_);
    // What another frame than the first has given, who does not read them all would not have.
    if (question && radius == radius_ && look == look_) keep_fit(*stamp, *question, {camera, middle_});
    return camera;
}

LoadedScene FrameSequence::load(const Shot& shot) {
    LoadedScene loaded = read(shot.frame);
    // Read once more by the radius that was found, a frame says nothing of it.
    std::vector<std::string> warnings = std::exchange(radius_warnings_, {});
    for (std::string& warning : loaded.warnings) {
        if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(std::move(warning));
    }
    loaded.warnings = std::move(warnings);
    if (loaded.look.has_values_beyond && !options_.look.range) beyond_range_.insert(shot.frame);
    loaded.scene.camera = camera_of(shot);
    loaded.middle = middle_;
    loaded.fitted = fitted_ && (!options_.frames.fit_first || shot.frame == shots_.front().frame);
    if (turn_) loaded.scene.light.toward_key = key_direction(camera_axes(camera_));
    return loaded;
}

std::string FrameSequence::values_beyond_range() const {
    if (beyond_range_.empty()) return "";
    const std::size_t others = beyond_range_.size() - 1;
    return reader_->name() + ": frame " + std::to_string(*beyond_range_.begin()) +
           (others == 0   ? " holds"
            : others == 1 ? " and another hold"
                          : " and " + in_groups(others) + " others hold") +
           " values beyond " + shortest(look_.range_of_frames->low) + " to " + shortest(look_.range_of_frames->high) +
           ", the first frame's range; --range gives another";
}

std::vector<std::string> FrameSequence::not_said(const std::vector<std::string>& lines) {
    std::vector<std::string> others;
    for (const std::string& line : lines) {
        if (said_.insert(line).second) others.push_back(line);
    }
    return others;
}

}  // namespace sphereview

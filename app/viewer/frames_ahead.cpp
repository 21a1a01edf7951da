#include "viewer/frames_ahead.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <utility>

#include "app/failure.hpp"
#include "formats/frame_reader.hpp"

namespace sphereview {

namespace {

std::size_t bytes_of(const Scene& scene) {
    constexpr std::size_t of_name = 110;
    constexpr std::size_t of_value = 8;
    return scene.spheres.size() * (sizeof(Sphere) + of_value * scene.properties.size()) + scene.names.size() * of_name;
}

}  // namespace

struct FramesAhead::Task {
    std::optional<std::int64_t> frame;  // none: to count
    bool is_first = false;              // of what is wanted
    LookOptions look;
    std::uint64_t looks;
};

// Both threads use it.
struct FramesAhead::Shared {
    Shared(LookOptions first_look, std::size_t most) : look(std::move(first_look)), most_bytes(most) {}

    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    bool ended = false;
    std::vector<std::int64_t> wanted;
    LookOptions look;
    std::uint64_t looks = 0;  // how often that has become another
    std::size_t most_bytes;
    std::map<std::int64_t, LoadedScene> read;
    std::map<std::int64_t, std::string> faults;
    std::map<std::int64_t, double> times;  // of all frames that were read
    std::optional<PassedFrame> passed;
    std::string no_file;  // why none can be read
    Count count;
    std::atomic<bool> asked = false;  // perhaps something else is to be done than to count
    std::atomic<double> part = 0.0;

    bool is_wanted(std::int64_t frame) const { return std::ranges::find(wanted, frame) != wanted.end(); }
    bool is_done(std::int64_t frame) const { return !no_file.empty() || read.contains(frame) || faults.contains(frame); }
    // What is to be read next, as far as there is room.
    std::optional<std::int64_t> next() const {
        std::size_t bytes = 0;
        for (const auto& [number, loaded] : read) bytes += bytes_of(loaded.scene);
        for (const std::int64_t frame : wanted) {
            if (is_done(frame)) continue;
            if (frame == wanted.front() || bytes < most_bytes) return frame;
            break;
        }
        return std::nullopt;
    }
    // Waits for it; nothing at the end.
    std::optional<Task> next_task() {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return ended || next() || !count.all; });
        asked = false;
        if (ended) return std::nullopt;
        const std::optional<std::int64_t> frame = next();
        return Task{frame, frame && *frame == wanted.front(), look, looks};
    }
    // Called with the mutex held.
    void tell() {
        asked = true;
        changed.notify_all();
    }
    void fail(std::string why) {
        const std::lock_guard lock(mutex);
        no_file = std::move(why);
        count.all = true;
        changed.notify_all();
    }
    void forget_unwanted() {
        std::erase_if(read, [&](const auto& one) { return !is_wanted(one.first); });
        std::erase_if(faults, [&](const auto& one) { return !is_wanted(one.first); });
    }
};

FramesAhead::FramesAhead(std::string path, LoadOptions options, std::size_t most_bytes)
    : shared_(std::make_shared<Shared>(options.look, most_bytes)),
      job_(
          [shared = shared_, path = std::move(path), options = std::move(options)](WorkControl&) {
              try {
                  work(*shared, path, options);
              } catch (...) {
                  shared->fail(describe_current_exception(path).message);
              }
          },
          WorkPriority::usual) {
    if (!job_.ended()) return;
    try {
        job_.rethrow();  // where there can be no thread
    } catch (...) {
        shared_->fail(describe_current_exception().message);
    }
}

FramesAhead::~FramesAhead() {
    const std::lock_guard lock(shared_->mutex);
    shared_->ended = true;
    shared_->tell();
}

void FramesAhead::want(std::vector<std::int64_t> frames) {
    const std::lock_guard lock(shared_->mutex);
    if (frames == shared_->wanted) return;
    shared_->wanted = std::move(frames);
    shared_->forget_unwanted();
    shared_->tell();
}

void FramesAhead::set_look(const LookOptions& look) {
    const std::lock_guard lock(shared_->mutex);
    if (look == shared_->look) return;
    shared_->look = look;
    ++shared_->looks;
    shared_->read.clear();
    shared_->passed.reset();
    shared_->tell();
}

std::optional<LoadedScene> FramesAhead::take(std::int64_t frame) {
    const std::lock_guard lock(shared_->mutex);
    const auto read = shared_->read.find(frame);
    if (read == shared_->read.end()) return std::nullopt;
    LoadedScene loaded = std::move(read->second);
    shared_->read.erase(read);
    shared_->passed.reset();
    std::erase(shared_->wanted, frame);
    shared_->tell();
    return loaded;
}

std::optional<PassedFrame> FramesAhead::take_passed() {
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->passed, std::nullopt);
}

std::optional<double> FramesAhead::time_of(std::int64_t frame) const {
    const std::lock_guard lock(shared_->mutex);
    const auto time = shared_->times.find(frame);
    return time == shared_->times.end() ? std::nullopt : std::optional(time->second);
}

std::optional<std::string> FramesAhead::fault_of(std::int64_t frame) const {
    const std::lock_guard lock(shared_->mutex);
    if (!shared_->no_file.empty()) return shared_->no_file;
    const auto fault = shared_->faults.find(frame);
    return fault == shared_->faults.end() ? std::nullopt : std::optional(fault->second);
}

bool FramesAhead::has_no_file() const {
    const std::lock_guard lock(shared_->mutex);
    return !shared_->no_file.empty();
}

void FramesAhead::wait_for(std::int64_t frame) const {
    std::unique_lock lock(shared_->mutex);
    shared_->changed.wait(lock, [&] { return shared_->is_done(frame); });
}

FramesAhead::Count FramesAhead::count() const {
    const std::lock_guard lock(shared_->mutex);
    Count count = shared_->count;
    count.part = shared_->part;
    return count;
}

void FramesAhead::work(Shared& shared, const std::string& path, const LoadOptions& options) {
    FrameReader reader(path, with_properties(options.data, options.look));
    reader.watch([&shared](double part) { shared.part = part; });
    while (const std::optional<Task> task = shared.next_task()) {
        if (task->frame) {
            read_one(shared, reader, options, *task);
        } else {
            count_on(shared, reader);
        }
    }
}

// Where the look has become another meanwhile, what was read is forgotten.
void FramesAhead::read_one(Shared& shared, FrameReader& reader, LoadOptions options, const Task& task) {
    options.look = task.look;
    LoadedScene loaded;
    std::string fault;
    try {
        SphereData data = reader.read(*task.frame);
        // One radius for all: made of each frame's own distances it would come and go.
        if (data.radius_of_points) reader.set_radius_of_points(*data.radius_of_points);
        loaded = {std::move(data), reader.name(), reader.format()};
        complete(loaded, options);
    } catch (...) {
        fault = describe_current_exception(reader.name()).message;
    }
    const std::lock_guard lock(shared.mutex);
    if (fault.empty()) shared.count.frames = std::max(shared.count.frames, *task.frame + 1);
    if (loaded.time) shared.times[*task.frame] = loaded.time->value;
    if (task.looks == shared.looks) {
        const bool is_wanted = shared.is_wanted(*task.frame);
        if (is_wanted && fault.empty()) {
            shared.read.emplace(*task.frame, std::move(loaded));
        } else if (is_wanted) {
            shared.faults.emplace(*task.frame, std::move(fault));
        } else if (task.is_first && fault.empty()) {
            shared.passed = PassedFrame{*task.frame, std::move(loaded)};
        }
    }
    shared.changed.notify_all();
}

// Until something else is to be done, or all are known.
void FramesAhead::count_on(Shared& shared, FrameReader& reader) {
    constexpr std::int64_t told_every = 64;
    std::int64_t known = 0;
    {
        const std::lock_guard lock(shared.mutex);
        known = shared.count.frames;
    }
    bool all = false;
    while (!all && !shared.asked) {
        const std::int64_t found = reader.count(known + 1);
        all = found <= known;
        known = found;
        if (!all && known % told_every != 0) continue;
        const std::lock_guard lock(shared.mutex);
        shared.count.frames = known;
    }
    const std::lock_guard lock(shared.mutex);
    shared.count.frames = known;
    shared.count.all = all;
    if (all) shared.count.fault = reader.fault();
}

}  // namespace sphereview

#include "base/folder_events.hpp"

#include <condition_variable>
#include <mutex>

#ifdef __linux__
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#endif

namespace sphereview {

using Clock = std::chrono::steady_clock;

namespace {

// Waiting where there are no descriptors to wait for.
struct Bell {
    std::mutex mutex;
    std::condition_variable condition;
    bool rung = false;

    void wait(std::optional<Clock::time_point> until) {
        std::unique_lock lock(mutex);
        const auto is_rung = [this] { return rung; };
        if (until) {
            condition.wait_until(lock, *until, is_rung);
        } else {
            condition.wait(lock, is_rung);
        }
        rung = false;
    }
    void ring() {
        {
            const std::lock_guard lock(mutex);
            rung = true;
        }
        condition.notify_all();
    }
};

}  // namespace

#ifdef __linux__

namespace {

constexpr std::uint32_t told =
    IN_CREATE | IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

FolderEvent::What meaning(std::uint32_t mask) {
    using What = FolderEvent::What;
    if ((mask & IN_CLOSE_WRITE) != 0) return What::closed;
    if ((mask & IN_MOVED_TO) != 0) return What::moved_in;
    if ((mask & IN_CREATE) != 0) return What::created;
    if ((mask & IN_MODIFY) != 0) return What::written;
    if ((mask & (IN_DELETE | IN_MOVED_FROM)) != 0) return What::gone;
    return What::lost;
}

}  // namespace

struct FolderEvents::State {
    int events = -1;
    int waker = -1;
    Bell bell;  // where the descriptors cannot be had

    explicit State(bool from_system) {
        if (!from_system) return;
        events = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
        waker = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
        if (events < 0 || waker < 0) close_both();
    }
    ~State() { close_both(); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void close_both() {
        for (int* descriptor : {&events, &waker}) {
            if (*descriptor >= 0) close(*descriptor);
            *descriptor = -1;
        }
    }
    void read_events(std::vector<FolderEvent>& happened) const {
        alignas(inotify_event) std::array<char, 16384> buffer{};
        for (ssize_t count; (count = read(events, buffer.data(), buffer.size())) > 0;) {
            for (std::size_t at = 0; at < static_cast<std::size_t>(count);) {
                inotify_event event{};
                std::memcpy(&event, buffer.data() + at, sizeof event);
                const char* name = event.len > 0 ? buffer.data() + at + sizeof event : "";
                happened.push_back({event.wd, meaning(event.mask), name, (event.mask & IN_ISDIR) != 0});
                at += sizeof event + event.len;
            }
        }
    }
};

std::optional<int> FolderEvents::add(const std::filesystem::path& folder) {
    if (state_->events < 0) return {};
    const int number = inotify_add_watch(state_->events, folder.c_str(), told);
    return number < 0 ? std::nullopt : std::optional(number);
}

void FolderEvents::remove(int folder) { inotify_rm_watch(state_->events, folder); }

std::vector<FolderEvent> FolderEvents::wait(std::optional<Clock::time_point> until) {
    std::vector<FolderEvent> happened;
    if (state_->events < 0) {
        state_->bell.wait(until);
        return happened;
    }
    int limit = -1;
    if (until) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(*until - Clock::now()).count();
        limit = static_cast<int>(std::clamp<std::int64_t>(left, 0, 60'000));
    }
    std::array<pollfd, 2> waiting = {{{state_->events, POLLIN, 0}, {state_->waker, POLLIN, 0}}};
    if (poll(waiting.data(), waiting.size(), limit) <= 0) return happened;
    std::uint64_t rung = 0;
    [[maybe_unused]] const ssize_t taken = read(state_->waker, &rung, sizeof rung);
    state_->read_events(happened);
    return happened;
}

void FolderEvents::wake() {
    if (state_->events < 0) {
        state_->bell.ring();
    } else {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = write(state_->waker, &one, sizeof one);
    }
}

#else

struct FolderEvents::State {
    Bell bell;

    explicit State(bool) {}
};

std::optional<int> FolderEvents::add(const std::filesystem::path&) { return {}; }
void FolderEvents::remove(int) {}
std::vector<FolderEvent> FolderEvents::wait(std::optional<Clock::time_point> until) {
    state_->bell.wait(until);
    return {};
}
void FolderEvents::wake() { state_->bell.ring(); }

#endif

FolderEvents::FolderEvents(bool from_system) : state_(std::make_unique<State>(from_system)) {}
FolderEvents::~FolderEvents() = default;

}  // namespace sphereview

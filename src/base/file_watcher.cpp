#include "base/file_watcher.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "base/file_state.hpp"
#include "base/folder_events.hpp"
#include "base/watched_places.hpp"

namespace sphereview {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto looking_interval = std::chrono::milliseconds(500);
constexpr auto left_alone = std::chrono::milliseconds(300);  // since the last write of a file that stays open, or was linked

struct Watched {
    std::string path;
    FileStates last{};                           // as it was reported, or looked at
    bool looked_at = false;                      // the system does not tell of it
    bool unsettled = false;                      // it had changed when it was last looked at
    std::optional<Clock::time_point> pending{};  // when it counts as left alone
};

struct Interest {
    std::size_t watched;
    WatchedPlace place;
};

}  // namespace

class FileWatcher::Implementation {
public:
    Implementation(std::function<void()> on_change, Method method)
        : on_change_(std::move(on_change)), events_(method == Method::system), thread_([this] { run(); }) {}

    ~Implementation() {
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
        }
        events_.wake();
        thread_.join();
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    void watch(std::vector<std::string> paths) {
        {
            const std::lock_guard lock(mutex_);
            std::erase_if(changed_, [&](const std::string& path) { return std::ranges::find(paths, path) == paths.end(); });
            const std::vector<Watched> before = std::exchange(watched_, {});
            for (std::string& path : paths) {
                const auto old = std::ranges::find(before, path, &Watched::path);
                watched_.push_back(old != before.end() ? *old : Watched{.path = std::move(path)});
            }
            find_places();  // first: what happens from now on is either told or seen in the state
            for (Watched& watched : watched_) {
                if (std::ranges::find(before, watched.path, &Watched::path) == before.end())
                    watched.last = file_states(watched.path);
            }
        }
        events_.wake();
    }

    std::vector<std::string> take_changed() {
        const std::lock_guard lock(mutex_);
        const std::set<std::string> changed = std::exchange(changed_, {});
        return {changed.begin(), changed.end()};
    }

private:
    void run() {
        std::unique_lock lock(mutex_);
        while (!ending_) {
            const auto until = next_look();
            lock.unlock();
            const std::vector<FolderEvent> happened = events_.wait(until);
            lock.lock();
            const std::size_t before = reports_;
            handle(happened);
            report_settled();
            if (std::ranges::any_of(watched_, &Watched::looked_at) && Clock::now() >= next_looking_) look();
            if (reports_ == before || ending_) continue;
            lock.unlock();
            on_change_();
            lock.lock();
        }
    }

    // Nothing, so long as only the system has to tell.
    std::optional<Clock::time_point> next_look() const {
        std::optional<Clock::time_point> next;
        for (const Watched& watched : watched_) {
            if (watched.looked_at) next = std::min(next.value_or(next_looking_), next_looking_);
            if (watched.pending) next = std::min(next.value_or(*watched.pending), *watched.pending);
        }
        return next;
    }

    // Asks the system to tell of all places, and of no others.
    void find_places() {
        const auto before = std::exchange(interests_, {});
        for (std::size_t i = 0; i < watched_.size(); ++i) {
            watched_[i].looked_at = false;
            for (WatchedPlace& place : watched_places(watched_[i].path)) {
                if (const auto folder = events_.add(place.folder)) {
                    interests_[*folder].push_back({i, std::move(place)});
                } else {
                    watched_[i].looked_at = true;
                }
            }
        }
        for (const auto& [folder, interests] : before) {
            if (!interests_.contains(folder)) events_.remove(folder);
        }
    }

    void report(Watched& watched) {
        watched.pending.reset();
        watched.unsettled = false;
        watched.last = file_states(watched.path);
        if (watched.last.empty()) return;  // gone again, or a link to nowhere
        changed_.insert(watched.path);
        ++reports_;
    }

    void handle(const std::vector<FolderEvent>& happened) {
        bool places_changed = false;
        for (const FolderEvent& event : happened) {
            // Of a folder that is no longer watched there is nothing to learn; the number -1 is for all.
            if (event.what == FolderEvent::What::lost && (event.folder < 0 || interests_.contains(event.folder)))
                places_changed = true;
            const auto interests = interests_.find(event.folder);
            if (interests == interests_.end()) continue;
            for (const Interest& interest : interests->second) {
                if (interest.place.name.empty() || interest.place.name == event.name) places_changed |= handle(event, interest);
            }
        }
        if (places_changed) look_for_places();
    }

    // Returns whether the way to the file may be another now.
    bool handle(const FolderEvent& event, const Interest& interest) {
        using What = FolderEvent::What;
        Watched& watched = watched_[interest.watched];
        const bool is_file = !interest.place.leads_there && !event.is_folder;
        if (is_file && (event.what == What::closed || event.what == What::moved_in)) report(watched);
        if (is_file && (event.what == What::written || event.what == What::created)) watched.pending = Clock::now() + left_alone;
        return event.what != What::written && event.what != What::closed;
    }

    void look_for_places() {
        find_places();
        for (Watched& watched : watched_) {
            if (has_news(watched.last, file_states(watched.path))) watched.pending = Clock::now() + left_alone;
        }
    }

    void report_settled() {
        for (Watched& watched : watched_) {
            if (watched.pending && *watched.pending <= Clock::now()) report(watched);
        }
    }

    void look() {
        next_looking_ = Clock::now() + looking_interval;
        for (Watched& watched : watched_) {
            if (!watched.looked_at) continue;
            FileStates now = file_states(watched.path);
            if (now != watched.last) {
                watched.unsettled |= has_news(watched.last, now);
                watched.last = std::move(now);
            } else if (watched.unsettled) {
                report(watched);
            }
        }
    }

    std::function<void()> on_change_;
    FolderEvents events_;
    std::mutex mutex_;  // of all that follows
    bool ending_ = false;
    std::vector<Watched> watched_;
    std::map<int, std::vector<Interest>> interests_;  // by the folder's number
    std::set<std::string> changed_;
    std::size_t reports_ = 0;
    Clock::time_point next_looking_{};
    std::thread thread_;  // last: it uses the others
};

FileWatcher::FileWatcher(std::function<void()> on_change, Method method)
    : implementation_(std::make_unique<Implementation>(std::move(on_change), method)) {}
FileWatcher::~FileWatcher() = default;
void FileWatcher::watch(std::vector<std::string> paths) { implementation_->watch(std::move(paths)); }
std::vector<std::string> FileWatcher::take_changed() { return implementation_->take_changed(); }

}  // namespace sphereview

#include "base/ordered_work.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/background_job.hpp"
#include "base/parallel.hpp"

namespace sphereview {

// No promise: one that is broken where memory has run out ends the process.
void Errands::ask(const std::function<void()>& act) {
    Errand errand{act};
    std::unique_lock lock(mutex_);
    if (closed_) throw Cancelled();
    asked_for_.push_back(&errand);
    changed_.notify_all();
    changed_.wait(lock, [&] { return errand.state != Errand::State::waits; });
    if (errand.state == Errand::State::is_dropped) throw Cancelled();
    if (errand.error) std::rethrow_exception(errand.error);
}

void Errands::serve() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return closed_ || !asked_for_.empty(); });
        if (asked_for_.empty()) return;
        Errand& errand = *asked_for_.front();
        asked_for_.pop_front();
        lock.unlock();
        try {
            errand.act();
        } catch (...) {
            errand.error = std::current_exception();
        }
        lock.lock();
        errand.state = Errand::State::is_done;
        changed_.notify_all();
    }
}

void Errands::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    for (Errand* errand : asked_for_) errand->state = Errand::State::is_dropped;
    asked_for_.clear();
    changed_.notify_all();
}

namespace {

constexpr std::chrono::milliseconds signs_of_life{100};

class OrderedWorkers {
public:
    OrderedWorkers(const OrderedWork& work, Errands& errands) : work_(work), errands_(errands), made_(work.count) {}
    ~OrderedWorkers() {
        end();
        for (std::thread& thread : threads_) thread.join();
    }
    OrderedWorkers(const OrderedWorkers&) = delete;
    OrderedWorkers& operator=(const OrderedWorkers&) = delete;

    bool start(int makers) {
        try {
            for (int i = 0; i < makers; ++i) threads_.emplace_back([this] { run([this] { make_all(); }); });
            threads_.emplace_back([this] { run([this] { deliver_all(); }); });
        } catch (const std::system_error&) {
            return false;
        }
        const std::lock_guard lock(mutex_);
        started_ = true;
        changed_.notify_all();
        return true;
    }

    // Waits for all threads, and throws what one of them threw.
    void join() {
        for (std::thread& thread : threads_) thread.join();
        threads_.clear();
        if (error_) std::rethrow_exception(error_);
    }

private:
    // The first error ends all. Nobody hears of what is thrown behind the end, as Cancelled by a loop that this ends.
    template <typename Part>
    void run(const Part& part) {
        try {
            part();
        } catch (...) {
            {
                const std::lock_guard lock(mutex_);
                if (!ended_ && !error_) error_ = std::current_exception();
            }
            end();
        }
    }

    // Until nothing is left to begin.
    void make_all() {
        cancel_loops_by(&ended_);
        while (const auto place = begin_next()) {
            work_.make(*place);
            const std::lock_guard lock(mutex_);
            made_[*place] = true;
            changed_.notify_all();
        }
    }

    std::optional<std::size_t> begin_next() {
        const std::lock_guard turn(turn_);
        std::unique_lock lock(mutex_);
        changed_.wait(
            lock, [this] { return ended_ || (started_ && begun_ - delivered_ < std::max<std::size_t>(work_.most_at_once(), 1)); });
        if (ended_ || begun_ == work_.count) return std::nullopt;
        const std::size_t place = begun_++;
        lock.unlock();
        work_.begin(place);
        return place;
    }

    void deliver_all() {
        for (std::size_t place = 0; place < work_.count; ++place) {
            std::unique_lock lock(mutex_);
            while (!changed_.wait_for(lock, signs_of_life, [&] { return ended_ || made_[place]; })) {
                lock.unlock();
                work_.wait(place);
                lock.lock();
            }
            if (ended_) return;
            lock.unlock();
            if (!work_.deliver(place)) break;
            lock.lock();
            ++delivered_;
            changed_.notify_all();
        }
        end();
    }

    void end() {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        changed_.notify_all();
        errands_.close();
    }

    const OrderedWork& work_;
    Errands& errands_;
    std::mutex turn_;  // to begin; taken before the next
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<bool> made_;
    std::size_t begun_ = 0;
    std::size_t delivered_ = 0;
    bool started_ = false;
    std::atomic<bool> ended_ = false;
    std::exception_ptr error_{};
    std::vector<std::thread> threads_;
};

}  // namespace

bool do_in_order(const OrderedWork& work, int threads, Errands& errands) {
    OrderedWorkers workers(work, errands);
    if (!workers.start(threads)) return false;
    errands.serve();
    workers.join();
    return true;
}

}  // namespace sphereview

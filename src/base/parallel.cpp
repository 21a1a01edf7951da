// A pool of threads that sleep between jobs. (OpenMP's would do, but GNU's spin, which takes a core from the thread that goes
// on, and Apple's compiler has none.)
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/background_job.hpp"

#ifdef __linux__
#include <sched.h>
#endif

namespace sphereview {

namespace {

thread_local bool inside_work = false;
thread_local const std::atomic<bool>* cancelled_by = nullptr;

void check(const std::atomic<bool>* cancelled) {
    if (cancelled != nullptr && *cancelled) throw Cancelled();
}

int usable_cores() {
#ifdef __linux__
    // What `taskset` or a container leaves of them; the standard library looks at the machine.
    cpu_set_t cores;
    if (sched_getaffinity(0, sizeof cores, &cores) == 0) return CPU_COUNT(&cores);
#endif
    return static_cast<int>(std::thread::hardware_concurrency());
}

struct Job {
    std::size_t count;
    void (*call)(const void*, std::size_t);
    const void* work;
    const std::atomic<bool>* cancelled = cancelled_by;  // of the thread that begins
    std::atomic<std::size_t> next = 0;
    std::mutex error_mutex{};
    std::exception_ptr error{};

    // Takes part until nothing is left to begin.
    void run() {
        inside_work = true;
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                check(cancelled);
                call(work, i);
            } catch (...) {
                const std::lock_guard lock(error_mutex);
                if (!error) error = std::current_exception();
                next = count;
            }
        }
        inside_work = false;
    }
};

class Pool {
public:
    Pool() {
        try {
            for (int i = 1; i < worker_count(); ++i) {
                threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
            }
        } catch (const std::system_error&) {
            // The system allows no more threads: those there are do the work.
        }
    }

    // Whether the job was done; not if another thread's is under way.
    bool run(Job& job) {
        const std::unique_lock one_at_a_time(jobs_mutex_, std::try_to_lock);
        if (!one_at_a_time) return false;
        {
            const std::lock_guard lock(mutex_);
            job_ = &job;
            ++job_number_;
        }
        begin_.notify_all();
        job.run();
        std::unique_lock lock(mutex_);
        job_ = nullptr;  // who wakes up now is late
        end_.wait(lock, [this] { return busy_ == 0; });
        return true;
    }

private:
    void serve(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        std::size_t last_job = 0;
        while (begin_.wait(lock, stop, [&] { return job_ != nullptr && job_number_ != last_job; })) {
            last_job = job_number_;
            Job& job = *job_;
            ++busy_;
            lock.unlock();
            job.run();
            lock.lock();
            if (--busy_ == 0) end_.notify_one();
        }
    }

    std::mutex jobs_mutex_;  // held by whose job is under way
    std::mutex mutex_;       // guards what follows
    std::condition_variable_any begin_;
    std::condition_variable end_;
    Job* job_ = nullptr;
    std::size_t job_number_ = 0;
    int busy_ = 0;
    std::vector<std::jthread> threads_;  // last: they end before what they use
};

}  // namespace

int worker_count() {
    static const int count = std::max(1, usable_cores());
    return count;
}

void cancel_loops_by(const std::atomic<bool>* flag) { cancelled_by = flag; }

void detail::share_work(std::size_t count, void (*call)(const void*, std::size_t), const void* work) {
    if (count > 1 && !inside_work && worker_count() > 1) {
        static Pool pool;
        Job job{count, call, work};
        if (pool.run(job)) {
            if (job.error) std::rethrow_exception(job.error);
            return;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        check(cancelled_by);
        call(work, i);
    }
}

}  // namespace sphereview

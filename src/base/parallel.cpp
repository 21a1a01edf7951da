// A pool of threads that sleep between jobs. They are not OpenMP's: GNU's threads spin after each loop, which takes a core from the
// thread that goes on, and Apple's compiler has no OpenMP.
#include "base/parallel.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#ifdef _WIN32
#include <windows.h>
#else
#include <pthread.h>
#endif
#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace sphereview {

namespace {

thread_local bool inside_work = false;
thread_local bool gives_way = false;
thread_local bool keeps_loops = false;
thread_local const std::atomic<bool>* cancelled_by = nullptr;       // the loops that this thread begins
thread_local const std::atomic<bool>* work_cancelled_by = nullptr;  // that in whose work it is

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
    int helpers = 0;  // of the pool's threads; guarded by the pool's mutex
    std::mutex error_mutex{};
    std::exception_ptr error{};

    bool has_more() const { return next < count; }

    // Takes part until nothing is left to begin or `goes_on` says no.
    template <typename GoesOn>
    void run(const GoesOn& goes_on) {
        inside_work = true;
        work_cancelled_by = cancelled;
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                check(cancelled);
                call(work, i);
            } catch (...) {
                const std::lock_guard lock(error_mutex);
                if (!error) error = std::current_exception();
                next = count;
            }
            if (!goes_on()) break;
        }
        inside_work = false;
    }
};

// Each job is done by the thread that brings it, with the help of the pool's. Several jobs share those: whenever one comes, each
// helper looks anew for the job that has the fewest.
class Pool {
public:
    explicit Pool(bool background) {
        try {
            for (int i = 1; i < worker_count(); ++i) {
                threads_.emplace_back([this, background] {
                    if (background) give_way();
                    serve();
                });
            }
        } catch (const std::system_error&) {
            // The system allows no more threads: those there are do the work.
        }
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    void run(Job& job) {
        {
            const std::lock_guard lock(mutex_);
            jobs_.push_back(&job);
            ++jobs_begun_;
        }
        begin_.notify_all();
        job.run([] { return true; });
        std::unique_lock lock(mutex_);
        std::erase(jobs_, &job);
        end_.wait(lock, [&] { return job.helpers == 0; });
    }

private:
    void serve() {
        std::unique_lock lock(mutex_);
        while (true) {
            Job* job = nullptr;
            begin_.wait(lock, [&] { return (job = neediest()) != nullptr; });
            ++job->helpers;
            const std::size_t begun = jobs_begun_;
            lock.unlock();
            job->run([&] { return jobs_begun_ == begun; });
            lock.lock();
            if (--job->helpers == 0) end_.notify_all();
        }
    }

    // The latest of those with the fewest helpers; null when there is nothing to begin.
    Job* neediest() const {
        Job* found = nullptr;
        for (Job* job : jobs_) {
            if (job->has_more() && (found == nullptr || job->helpers <= found->helpers)) found = job;
        }
        return found;
    }

    std::mutex mutex_;
    std::condition_variable begin_;
    std::condition_variable end_;
    std::vector<Job*> jobs_;
    std::atomic<std::size_t> jobs_begun_ = 0;
    std::vector<std::thread> threads_;  // last: they use what is above
};

std::mutex pool_mutex;
// For threads that give way, and for others: a thread that gives way does so for good. Never destroyed: where the process ends
// while another thread still works, as in Python's, its loops must not lose the pool.
Pool* pool_that_gives_way = nullptr;  // guarded by pool_mutex, as the next
Pool* usual_pool = nullptr;

#ifndef _WIN32
// A child of fork() has none of its parent's threads, and what one of them had locked stays locked there: it gets pools of its
// own. From the program's start on, since the first use may be on another thread than the fork.
[[maybe_unused]] const int children_have_their_own_pool = pthread_atfork([] { pool_mutex.lock(); }, [] { pool_mutex.unlock(); },
                                                                         [] {
                                                                             pool_that_gives_way = usual_pool = nullptr;
                                                                             pool_mutex.unlock();
                                                                         });
#endif

Pool& pool() {
    const std::lock_guard lock(pool_mutex);
    Pool*& found = gives_way ? pool_that_gives_way : usual_pool;
    if (found == nullptr) found = new Pool(gives_way);
    return *found;
}

}  // namespace

int worker_count() {
    // Not initialised by the first call, which might be under way on another thread when the process is copied.
    static std::atomic<int> count = 0;
    if (count == 0) count = std::max(1, usable_cores());
    return count;
}

void give_way() {
    gives_way = true;
#ifdef __linux__
    constexpr int nicer = 10;  // a tenth of the time of a thread that competes
    // Than the process: a thread begins as nice as the one that made it.
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), getpriority(PRIO_PROCESS, static_cast<id_t>(getpid())) + nicer);
#elif defined(__APPLE__)
    pthread_set_qos_class_self_np(QOS_CLASS_UTILITY, 0);
#elif defined(_WIN32)
    SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL);
#endif
}

void check_cancelled() { check(inside_work ? work_cancelled_by : cancelled_by); }

void keep_loops_on_this_thread(bool alone) { keeps_loops = alone; }

void cancel_loops_by(const std::atomic<bool>* flag) { cancelled_by = flag; }

void detail::share_work(std::size_t count, void (*call)(const void*, std::size_t), const void* work) {
    if (count > 1 && !inside_work && !keeps_loops && worker_count() > 1) {
        Job job{count, call, work};
        pool().run(job);
        if (job.error) std::rethrow_exception(job.error);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        check_cancelled();
        call(work, i);
    }
}

}  // namespace sphereview

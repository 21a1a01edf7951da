#include "python/renderers.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/ordered_work.hpp"
#include "base/parallel.hpp"

namespace sphereview {

namespace {

struct Opened {
    Backend asked_for = Backend::automatic;
    std::optional<OpenBackend> backend{};
};

// A thread that holds a GL context: a context is for the thread on which it was made. It stays open because opening one takes
// longer than most pictures.
class GlThread {
public:
    ~GlThread() {
        errands_.close();
        thread_.join();
    }
    GlThread() = default;
    GlThread(const GlThread&) = delete;
    GlThread& operator=(const GlThread&) = delete;

    // Calls work() after all that came before, and throws what that throws.
    void run(const std::function<void(Opened&)>& work) {
        errands_.ask([&] { work(opened_); });
    }

private:
    Errands errands_;
    Opened opened_;
    std::thread thread_{[this] {  // last: it uses what is above
        errands_.serve();
        opened_.backend.reset();
    }};
};

// What there is in this process. Not destroyed with other statics, when drivers may be gone: close_renderers() does that.
struct Renderers {
    std::mutex mutex;
    std::shared_ptr<GlThread> gl;
    bool lost_by_fork = false;
};
Renderers* renderers = new Renderers;

std::shared_ptr<GlThread> gl_thread() {
    const std::lock_guard lock(renderers->mutex);
    if (!renderers->gl) renderers->gl = std::make_shared<GlThread>();
    return renderers->gl;
}

// For the GL thread. Returns whether a GL renderer did the work.
bool draw(Opened& opened, Backend backend, std::uint64_t picture_bytes, const std::function<void(OpenBackend&)>& work) {
    // One context at a time.
    if (opened.backend && opened.asked_for != backend) opened.backend.reset();
    Timings timings;
    if (!opened.backend) opened = {backend, open_backend(backend, std::nullopt, timings, picture_bytes)};
    if (!opened.backend->gpu) return false;
    try {
        work(*opened.backend);
    } catch (const RenderError&) {
        opened.backend.reset();  // perhaps the driver's state is what failed
        throw;
    }
    return true;
}

}  // namespace

void with_renderer(Backend backend, std::uint64_t picture_bytes, const WorkControl& control,
                   const std::function<void(OpenBackend&)>& work) {
    bool done = false;
    if (backend != Backend::cpu && !renderers->lost_by_fork) {
        gl_thread()->run([&](Opened& opened) {
            cancel_loops_by(&control.cancelled);
            done = draw(opened, backend, picture_bytes, work);
        });
    } else if (backend != Backend::cpu && backend != Backend::automatic) {
        throw RenderError("the backend " + std::string(name_of(backend)) +
                          " does not work here: this process was forked from one that had opened OpenGL; use the backend cpu, or "
                          "multiprocessing's start method spawn");
    }
    if (done) return;
    OpenBackend cpu;
    work(cpu);
}

void close_renderers() {
    std::shared_ptr<GlThread> gl;
    const std::lock_guard lock(renderers->mutex);
    gl.swap(renderers->gl);
}

void forget_renderers() {
    const bool lost = renderers->lost_by_fork || renderers->gl != nullptr;
    renderers = new Renderers;  // the parent's may be locked for ever
    renderers->lost_by_fork = lost;
}

}  // namespace sphereview

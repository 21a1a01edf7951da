#include "app/failure.hpp"

#include <cstdio>
#include <cstdlib>
#include <new>

#include "base/background_job.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// What is said of `concerned`, in one line; or in those of a driver's log.
Failure failure(ExitCode code, const std::string& concerned, const char* what, bool log = false) {
    const std::string beginning = concerned.empty() ? "" : on_one_line(concerned) + ": ";
    return {code, beginning + (log ? on_lines(what) : on_one_line(what))};
}

Failure described(const std::string& scene) {
    const std::string concerned = scene.empty() ? "sphereview" : scene;
    try {
        throw;
    } catch (const InputError& error) {
        return failure(ExitCode::bad_input, "", error.what());
    } catch (const OutputError& error) {
        return failure(ExitCode::no_output, "", error.what());
    } catch (const RenderError& error) {
        return failure(ExitCode::no_renderer, scene, error.what(), true);
    } catch (const MemoryError& error) {
        return failure(ExitCode::no_renderer, "", error.what());
    } catch (const std::bad_alloc&) {
        return failure(ExitCode::no_renderer, concerned, "memory ran out");
    } catch (const Cancelled&) {
        return failure(ExitCode::no_renderer, concerned, "cancelled");
    } catch (const std::exception& error) {
        return failure(ExitCode::no_renderer, concerned, ("an unexpected error: " + std::string(error.what())).c_str());
    }
}

}  // namespace

Failure describe_current_exception(const std::string& scene) {
    try {
        return described(scene);
    } catch (const std::bad_alloc&) {
        return {ExitCode::no_renderer, "memory ran out"};  // short enough to need none
    }
}

void end_without_memory() {
    std::fputs("sphereview: memory ran out\n", stderr);
    std::_Exit(static_cast<int>(ExitCode::no_renderer));
}

}  // namespace sphereview

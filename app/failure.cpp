#include "app/failure.hpp"

#include <new>

#include "base/error.hpp"

namespace sphereview {

Failure describe_current_exception(const std::string& scene) {
    const std::string concerned = scene.empty() ? "sphereview" : scene;
    try {
        throw;
    } catch (const InputError& error) {
        return {ExitCode::bad_input, error.what()};
    } catch (const OutputError& error) {
        return {ExitCode::no_output, error.what()};
    } catch (const RenderError& error) {
        return {ExitCode::no_renderer, (scene.empty() ? "" : scene + ": ") + error.what()};
    } catch (const MemoryError& error) {
        return {ExitCode::no_renderer, error.what()};
    } catch (const std::bad_alloc&) {
        return {ExitCode::no_renderer, concerned + ": memory ran out"};
    } catch (const std::exception& error) {
        return {ExitCode::no_renderer, concerned + ": an unexpected error: " + error.what()};
    }
}

}  // namespace sphereview

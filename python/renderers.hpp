// The renderers that stay open from one call to the next.
#pragma once

#include <cstdint>
#include <functional>

#include "app/backend.hpp"
#include "base/background_job.hpp"

namespace sphereview {

// Calls work() with an open renderer of that kind: the CPU's on the caller's thread, one with a GL context on the thread of that
// context, where one picture is made after the other. `control` cancels the loops of both. `picture_bytes`: of the picture that is
// made. Throws RenderError where there is no such renderer, and what work() throws.
void with_renderer(Backend backend, std::uint64_t picture_bytes, const WorkControl& control,
                   const std::function<void(OpenBackend&)>& work);

// Closes what is open, in good order: before the process ends, while drivers still work.
void close_renderers();

// To be called in a child of fork(), where the parent's threads are not, and so its GL is of no use.
void forget_renderers();

}  // namespace sphereview

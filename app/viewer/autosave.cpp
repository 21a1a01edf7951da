#include "viewer/autosave.hpp"

#include <algorithm>

#include "viewer/recovery.hpp"

namespace sphereview {

void Autosave::look(const Document& document, const std::string& original, Clock::time_point now) {
    if (!document.is_changed()) {
        if (kept_) remove_own_recovery();
        kept_ = false;
        tried_ = 0;
        due_.reset();
    } else if (document.revision() == tried_) {
        due_.reset();
    } else if (!due_) {
        due_ = now + pause_;
    } else if (now >= *due_) {
        keep(document, original);
    }
}

bool Autosave::keep(const Document& document, const std::string& original) {
    const auto begin = Clock::now();
    const bool done = write_recovery(document.scene(), original);
    pause_ = std::max(shortest_pause, pauses_per_write * (Clock::now() - begin));
    tried_ = document.revision();
    kept_ = kept_ || done;
    due_.reset();
    return done;
}

}  // namespace sphereview

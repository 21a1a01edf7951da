#include "viewer/autosave.hpp"

#include <algorithm>
#include <memory>

#include "viewer/recovery.hpp"

namespace sphereview {

void Autosave::look(const Document& document, const std::string& original, Clock::time_point now) {
    if (job_ && !job_->ended()) {
        due_ = now + look_again;
        return;
    }
    if (job_) {
        finish();
        due_.reset();
    }
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
        if (document.scene().spheres.size() <= spheres_at_once) {
            keep(document, original);
        } else {
            keep_in_background(document, original);
            due_ = now + look_again;
        }
    }
}

void Autosave::keep_in_background(const Document& document, const std::string& original) {
    job_begin_ = Clock::now();
    tried_ = document.revision();
    kept_ = true;
    job_.emplace(
        [scene = std::make_shared<const Scene>(document.scene()), original](WorkControl&) { write_recovery(*scene, original); });
}

void Autosave::finish() {
    if (!job_) return;
    job_->wait();
    pause_ = std::max(shortest_pause, pauses_per_write * (Clock::now() - job_begin_));
    job_.reset();
}

bool Autosave::keep(const Document& document, const std::string& original) {
    finish();  // or the copy being written would replace this newer one
    const auto begin = Clock::now();
    const bool done = write_recovery(document.scene(), original);
    pause_ = std::max(shortest_pause, pauses_per_write * (Clock::now() - begin));
    tried_ = document.revision();
    kept_ = kept_ || done;
    due_.reset();
    return done;
}

}  // namespace sphereview

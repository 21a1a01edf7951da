#include "app/interruptible.hpp"

#include <mutex>
#include <new>
#include <utility>

#include "base/interrupt.hpp"
#include "base/standard_streams.hpp"

namespace sphereview {

namespace {

// Never destroyed: an interruption may come while the process ends.
std::mutex& current_mutex = *new std::mutex;
Interruptible* current = nullptr;

}  // namespace

Interruptible::Interruptible(std::function<std::string()> last_words) : last_words_(std::move(last_words)) {
    const std::lock_guard lock(current_mutex);
    // Not by std::call_once: without memory, an exception cannot pass through it.
    static bool passed = false;
    if (!passed) pass_interrupts_to(&Interruptible::interrupt);
    passed = true;
    current = this;
}

Interruptible::~Interruptible() {
    const std::lock_guard lock(current_mutex);
    current = nullptr;
}

void Interruptible::interrupt(int signal_number) {
    const std::lock_guard lock(current_mutex);
    try {
        const std::string words = current != nullptr ? current->last_words_() : "";
        if (!words.empty() && stderr_is_terminal()) say("");  // behind the progress bar
        if (!words.empty()) say(words);
    } catch (const std::bad_alloc&) {
        // Without a word, then.
    }
    end_interrupted(signal_number);  // with the lock: what lives as long as `current` does waits
}

}  // namespace sphereview

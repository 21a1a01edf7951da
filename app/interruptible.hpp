// Last words of work that is interrupted.
#pragma once

#include <functional>
#include <string>

namespace sphereview {

// While this lives, an interruption calls `last_words` on a thread of its own, prints the result unless that is empty, and ends the
// process: at once, or after an output that is being written. One at a time.
class Interruptible {
public:
    explicit Interruptible(std::function<std::string()> last_words);
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

private:
    static void interrupt(int signal_number);

    std::function<std::string()> last_words_;
};

}  // namespace sphereview

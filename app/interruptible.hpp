// Work that says how far it came when it is interrupted.
#pragma once

#include <functional>
#include <string>

namespace sphereview {

// While this lives, an interruption says what `last_words` returns, unless that is empty, which is called on a thread of its own,
// and ends the process: at once, or where an output is written, behind that. One at a time.
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

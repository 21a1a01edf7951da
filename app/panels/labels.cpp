#include "panels/labels.hpp"

namespace sphereview {

std::string on_one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    }
    return line;
}

std::string as_label(std::string_view text) {
    std::string label;
    for (const char c : on_one_line(text)) {
        if (c == '#' && label.ends_with('#')) label += ' ';
        label += c;
    }
    return label;
}

}  // namespace sphereview

#include "support/text_match.hpp"

#include <regex>

namespace sphereview::test {

testing::AssertionResult contains(std::string_view text, std::string_view part) {
    if (text.find(part) != std::string_view::npos) return testing::AssertionSuccess() << "found: " << part << "\nin: " << text;
    return testing::AssertionFailure() << "not found: " << part << "\nin: " << text;
}

testing::AssertionResult matches(const std::string& text, const std::string& expression) {
    if (std::regex_match(text, std::regex(expression, std::regex::extended)))
        return testing::AssertionSuccess() << expression << " matches: " << text;
    return testing::AssertionFailure() << expression << "\ndoes not match: " << text;
}

std::string line_with(std::string_view text, std::string_view part) {
    for (const std::string& line : lines(text)) {
        if (line.find(part) != std::string::npos) return line;
    }
    return "";
}

std::vector<std::string> lines(std::string_view text) {
    std::vector<std::string> found;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        found.emplace_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return found;
}

}  // namespace sphereview::test

// What a program said, compared with what it should say.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace sphereview::test {

// EXPECT_TRUE(contains(text, part)) prints both when it fails.
testing::AssertionResult contains(std::string_view text, std::string_view part);

// Whether the whole text matches the regular expression (POSIX, extended).
testing::AssertionResult matches(const std::string& text, const std::string& expression);

// The first line that contains the part, without its end; "" if there is none.
std::string line_with(std::string_view text, std::string_view part);

// The lines of a text, without their ends; no empty last line.
std::vector<std::string> lines(std::string_view text);

}  // namespace sphereview::test

// What an error says.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"

namespace sphereview {

// The message of the Error that `action` throws; "" and a failed test when it throws none.
template <typename Error, typename Action>
std::string message_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return "";
}

struct WrongText {
    std::string text;
    std::string message;  // behind the file's name
};

// That `read` refuses each text with the whole message.
template <typename Read>
void expect_messages(const std::string& file, const Read& read, const std::vector<WrongText>& cases) {
    for (const WrongText& wrong : cases) {
        SCOPED_TRACE(testing::PrintToString(wrong.text));
        EXPECT_EQ(message_of<InputError>([&] { read(wrong.text); }), file + ":" + wrong.message);
    }
}

}  // namespace sphereview

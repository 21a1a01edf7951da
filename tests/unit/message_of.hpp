// What an error says.
#pragma once

#include <gtest/gtest.h>

#include <string>

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

}  // namespace sphereview

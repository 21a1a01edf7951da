// The form of every refusal.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "support/program.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {

// Whether the program ended with the status and one line on standard error that begins with `said` (with its end: is it).
inline testing::AssertionResult fails(const Outcome& outcome, int status, std::string_view said) {
    if (outcome.status == status && outcome.errors.starts_with(said) && lines(outcome.errors).size() == 1) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "expected status " << status << " and: " << said << "\n" << outcome;
}

}  // namespace sphereview::test

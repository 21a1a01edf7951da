// Tests that run the program in a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview::test {

class InFolder : public testing::Test {
protected:
    Outcome sphereview(const std::vector<std::string>& arguments, const std::string& input = "") const {
        return run({.arguments = arguments, .folder = folder_.path(), .input = input});
    }

    void expect_fault(const std::vector<std::string>& arguments, const std::string& line) const {
        const Outcome outcome = sphereview(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(outcome.errors, line + "\n");
    }

    TemporaryFolder folder_;
};

}  // namespace sphereview::test

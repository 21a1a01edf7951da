// JSON as the program reads it.
#include "app/json.hpp"

#include <gtest/gtest.h>

#include <ctime>

namespace sphereview {

namespace {

// What it takes of a processor to read an object with so many members.
double seconds_to_read(int members) {
    std::string text = "{";
    for (int i = 0; i < members; ++i) text += "\"k" + std::to_string(i) + "\":1,";
    text += "\"last\":2}";
    const std::clock_t begin = std::clock();
    const Json json = Json::parse(text, "many");
    const std::clock_t end = std::clock();
    EXPECT_EQ(json["last"].whole(), 2);
    return static_cast<double>(end - begin) / CLOCKS_PER_SEC;
}

}  // namespace

TEST(Json, MembersStayInOrderAndOfEqualKeysTheLastCounts) {
    const Json json =
        Json::parse(R"({"b": 1, "a": 2, "b": {"y": 1, "x": 2, "y": 3}, "c": 4, "a": [5], "b": {"y": 6, "x": 7}})", "a");
    EXPECT_EQ(json.dump(), R"({"b":{"y":6,"x":7},"a":[5],"c":4})");
    EXPECT_EQ(Json::parse(R"({"": {"y": 1, "x": 2, "y": 3}, "z": 1})", "b").dump(), R"({"":{"y":3,"x":2},"z":1})");
}

// The square of the number of keys would be 256 times as much.
TEST(Json, ManyMembersTakeTimeInProportion) {
    const double few = seconds_to_read(10'000);
    EXPECT_LT(seconds_to_read(160'000), 100.0 * few);
}

}  // namespace sphereview

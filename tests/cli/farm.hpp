// Six frames that are rendered in parts, and proved.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/in_folder.hpp"
#include "support/json.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {

class Farm : public InFolder {
protected:
    Farm() {
        std::string text;
        for (int i = 0; i < 6; ++i) text += "2\n\nO 0 0 0\nH " + std::to_string(i + 1) + " 0 0\n";
        folder_.write("a.xyz", text);
    }

    Outcome farm(const std::vector<std::string>& more) const {
        return render(folder_, all_words({"a.xyz", "--frames", "all", "-s", "20x16", "-o", "out/{frame}.png", "--no-sync"}, more));
    }

    void expect_done(const std::vector<std::string>& more) const {
        const Outcome outcome = farm(more);
        EXPECT_EQ(outcome.status, 0) << outcome;
    }

    Outcome verify(const std::vector<std::string>& more = {}) const {
        return sphereview(all_words({"verify", "made.jsonl", "--backend", "cpu"}, more));
    }

    std::vector<Json> lines() const {
        std::vector<Json> all;
        for (const std::string& line : test::lines(folder_.read("made.jsonl"))) all.push_back(Json::parse(line));
        return all;
    }
};

}  // namespace sphereview::test

// A text gives the same spheres, or the same message, however it is cut. SPHEREVIEW_SEED=N tries other texts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "base/error.hpp"
#include "base/text.hpp"
#include "formats/text_format.hpp"
#include "support/trials.hpp"

namespace sphereview {

namespace {

constexpr int trials = test::trials(4000);
constexpr std::size_t whole = std::numeric_limits<std::size_t>::max() / 2;

// What a reader made of a text.
struct Reading {
    std::vector<Sphere> spheres;
    std::string message;

    bool operator==(const Reading&) const = default;
};

// Hands `text` in as a stream does: blocks of `block` bytes, more when a reader can do nothing with that many.
Reading read(std::string_view text, TextPosition origin, bool says_size, std::size_t block, std::size_t piece) {
    Reading reading;
    try {
        SphereTextReader reader("s", origin, says_size ? std::optional(text.size()) : std::nullopt, piece);
        for (std::size_t window = block;;) {
            const bool last = window >= text.size();
            const std::size_t used = reader.read(text.substr(0, window), last);
            if (last) break;
            text.remove_prefix(used);
            window = std::max(block, 2 * (window - used));
        }
        reading.spheres = reader.take_spheres();
    } catch (const InputError& error) {
        reading.message = error.what();
    }
    return reading;
}

class RandomText {
public:
    explicit RandomText(std::uint64_t seed) : random_(seed) {}

    std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }
    bool once_in(std::size_t times) { return below(times) == 0; }

    // Mostly right; faults of every kind, one or several, anywhere.
    std::string text() {
        const std::size_t count = below(once_in(8) ? 400 : 12);
        std::vector<std::string> tokens = {std::to_string(count)};
        for (std::size_t i = 0; i < count; ++i) {
            for (int channel = 0; channel < 3; ++channel) tokens.push_back(std::to_string(below(256)));
            for (int coordinate = 0; coordinate < 3; ++coordinate) tokens.push_back(number());
            tokens.push_back(shortest(std::ldexp(1.0 + static_cast<double>(below(1000)), static_cast<int>(below(60)) - 30)));
        }
        if (once_in(2)) {
            for (std::size_t faults = 1 + below(3); faults > 0; --faults) spoil(tokens);
        }
        std::string text = once_in(8) ? "\xEF\xBB\xBF" : "";
        if (once_in(4)) text += space();
        for (std::size_t i = 0; i < tokens.size(); ++i) text += (i == 0 ? "" : space()) + tokens[i];
        if (!once_in(4)) text += space();
        return text;
    }

private:
    std::string number() {
        const double value = std::ldexp(static_cast<double>(random_()), static_cast<int>(below(40)) - 70);
        const std::string text =
            once_in(30) ? std::string(below(200), '0') + "1.5" : shortest(once_in(2) ? value : std::round(value));
        return (once_in(3) ? "-" : once_in(10) ? "+" : "") + text;
    }

    std::string space() {
        static const std::array<std::string, 8> spaces = {" ", "\n", "\r\n", "\r", "\t", "\n\n", " \v\f", "\r\r\n \n"};
        std::string space = spaces[once_in(3) ? below(spaces.size()) : below(3)];
        return once_in(40) ? space + std::string(below(100), ' ') : space;
    }

    void spoil(std::vector<std::string>& tokens) {
        static const std::array<std::string, 12> wrong = {
            "256", "-1", "0", "x", "1e400", "nan", "1.5.2", std::string("\0", 1), "h\xC3\xA9", "+-", "-", "99999999999999999999"};
        const std::size_t place = below(tokens.size());
        switch (below(4)) {
            case 0: tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(place)); break;
            case 1: tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(place), "7"); break;
            default: tokens[place] = wrong[below(wrong.size())];
        }
        if (tokens.empty()) tokens.emplace_back("");
    }

    std::mt19937_64 random_;
};

}  // namespace

TEST(SphereTextReader, ReadsTheSameHoweverTheTextIsCut) {
    const std::uint64_t seed = test::number_from_environment("SPHEREVIEW_SEED", 20240607);
    std::cout << "SPHEREVIEW_SEED=" << seed << "\n";
    int good = 0;
    int bad = 0;
    for (int trial = 0; trial < trials; ++trial) {
        RandomText random(seed + static_cast<std::uint64_t>(trial));
        const std::string text = random.text();
        const TextPosition origin = random.once_in(2) ? TextPosition{} : TextPosition{1 + random.below(9), 1 + random.below(9)};
        const Reading expected = read(text, origin, true, whole, whole);
        ++(expected.message.empty() ? good : bad);
        for (int cut = 0; cut < 6; ++cut) {
            const std::size_t block = cut < 3 ? whole : 1 + random.below(random.once_in(2) ? 8 : 600);
            const std::size_t piece = 1 + random.below(random.once_in(2) ? 8 : 300);
            const bool says_size = random.once_in(2);
            const Reading reading = read(text, origin, says_size, block, piece);
            ASSERT_EQ(reading.message, expected.message) << "trial " << trial << ", block " << block << ", piece " << piece << ":\n"
                                                         << testing::PrintToString(text);
            ASSERT_TRUE(reading == expected) << "trial " << trial << ", block " << block << ", piece " << piece << ":\n"
                                             << testing::PrintToString(text);
        }
    }
    EXPECT_GT(good, trials / 4);  // else one of the two was hardly tried
    EXPECT_GT(bad, trials / 4);
}

TEST(SphereTextReader, ReportsTheFirstOfManyFaults) {
    std::string text = "1000";
    for (int i = 0; i < 1000; ++i) text += i < 300 ? "\n1 2 3 4 5 6 7" : "\n1 2 3 4 5 6 x";
    for (int round = 0; round < 20; ++round) {
        EXPECT_EQ(read(text, {}, true, whole, 16).message,
                  "s:302:13: found 'x', expected the radius of sphere 301 of 1000, a number");
    }
}

TEST(SphereTextReader, SaysHowFarItIs) {
    const std::string text = "4 1 2 3 4 5 6 7 1 2 3 4 5 6 7 1 2 3 4 5 6 7 1 2 3 4 5 6 7";
    SphereTextReader reader("s", {}, std::nullopt);
    EXPECT_EQ(reader.fraction(), 0.0);
    const std::size_t used = reader.read(std::string_view(text).substr(0, 17), false);
    EXPECT_EQ(used, 15U);
    EXPECT_EQ(reader.fraction(), 0.25);
    reader.read(std::string_view(text).substr(used), true);
    EXPECT_EQ(reader.fraction(), 1.0);
    EXPECT_EQ(reader.take_spheres().size(), 4U);
}

}  // namespace sphereview

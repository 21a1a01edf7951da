// A packed text is unpacked from its middle.
#include "base/gzip_places.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>

#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "support/gzip.hpp"

namespace sphereview {

namespace {

// Lines of numbers, as in a trajectory.
std::string numbers(std::size_t size) {
    std::mt19937 random(7);
    std::string text;
    while (text.size() < size) text += "Si " + std::to_string(random() % 100000) + " " + std::to_string(random() % 1000) + "\n";
    return text;
}

Gunzip::Source source_of(const std::string& bytes, std::size_t begin) {
    return [&bytes, at = begin](char* to, std::size_t most) mutable {
        const std::size_t count = bytes.copy(to, std::min<std::size_t>(most, 1000), at);
        at += count;
        return count;
    };
}

std::string rest_of(Gunzip& gunzip) {
    std::string text;
    std::string piece(5000, '\0');
    while (const std::size_t count = gunzip.read(piece.data(), piece.size())) text += piece.substr(0, count);
    return text;
}

}  // namespace

TEST(GzipPlaces, LeadIntoTheMiddleOfAMemberAndToTheNext) {
    const std::string first = numbers(1'500'000);
    const std::string second = numbers(300'000);
    std::string bytes = test::gzipped(first) + test::gzipped(second);
    for (std::size_t at = 0; at < 100'000; at += 1000) bytes += test::gzipped(first.substr(at, 1000));  // as bgzip makes them
    const std::string text = first + second + first.substr(0, 100'000);
    const auto places = std::make_shared<GzipPlaces>(60'000);
    Gunzip whole("a.gz", "", source_of(bytes, 0));
    whole.remember_places(places);
    ASSERT_TRUE(rest_of(whole) == text);
    ASSERT_GT(places->all().size(), 15U);

    std::size_t in_the_middle = 0;
    for (const GzipPlace& place : places->all()) {
        in_the_middle += place.begins_member ? 0 : 1;
        Gunzip rest("a.gz", place, source_of(bytes, place.packed - (place.bits > 0 ? 1 : 0)));
        ASSERT_TRUE(rest_of(rest) == text.substr(place.unpacked)) << place.unpacked;
        EXPECT_EQ(places->nearest(place.unpacked), place);
        EXPECT_LT(places->nearest(place.unpacked - 1).unpacked, place.unpacked);
    }
    EXPECT_GT(in_the_middle, 8U);
    EXPECT_LT(in_the_middle, places->all().size());
    EXPECT_EQ(places->nearest(0), GzipPlace{});

    // What is cut off is still told.
    const GzipPlace& place = places->all()[2];
    const std::string cut = bytes.substr(0, static_cast<std::size_t>(place.packed) + 2000);
    Gunzip rest("a.gz", place, source_of(cut, place.packed - (place.bits > 0 ? 1 : 0)));
    EXPECT_THROW(rest_of(rest), InputError);
}

TEST(GzipPlaces, AreFewHoweverLongTheText) {
    GzipPlaces places(10);
    for (std::uint64_t at = 10; at < 1'000'000; at += 10) {
        if (places.is_due(at)) places.add({at, at, 0, true, {}});
    }
    EXPECT_LE(places.all().size(), GzipPlaces::most);
    EXPECT_GT(places.all().size(), GzipPlaces::most / 4);
    EXPECT_GT(places.nearest(500'000).unpacked, 480'000U);
    EXPECT_LE(places.nearest(500'000).unpacked, 500'000U);
}

}  // namespace sphereview

#include "mistakes/diagnosis.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <unordered_map>

#include "exact/visible.hpp"
#include "mistakes/picture_style.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::int32_t>;

// What is supposed of the program that made a picture.
struct Suspicion {
    WrongTracer tracer{};
    Palette palette{};
};

// The colour that the background has instead of its own, if there is one: that of more than half of the pixels that should show
// it, where spheres' colours are left out, which wrong hits may have; of a sphere's own colour it must be nearly all.
std::optional<Color> other_background(const Comparer& comparer, const Numbers& numbers) {
    std::unordered_map<std::uint32_t, std::int64_t> counts;
    std::int64_t all = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != visible_background) continue;
        ++counts[packed_color(comparer.found(i))];
        ++all;
    }
    std::int64_t of_spheres = 0;
    for (const auto& [value, count] : counts) of_spheres += comparer.is_of_sphere(value) ? count : 0;
    std::erase_if(counts, [&](const auto& entry) {
        constexpr double nearly_all = 0.95;
        return comparer.is_of_sphere(entry.first) ? static_cast<double>(entry.second) < nearly_all * static_cast<double>(all)
                                                  : 2 * entry.second <= all - of_spheres;
    });
    if (counts.empty()) return std::nullopt;
    const auto most = std::ranges::max_element(
        counts, [](const auto& a, const auto& b) { return a.second < b.second || (a.second == b.second && a.first > b.first); });
    const std::uint32_t value = most->first;
    const Color color{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
                      static_cast<std::uint8_t>(value)};
    return color == comparer.right(visible_background) ? std::nullopt : std::optional(color);
}

struct Named {
    std::string name;
    std::string words;
};

// The mistakes, one each.
std::vector<Named> named(const Suspicion& suspicion) {
    std::vector<Named> all;
    for (const MistakeWords& words : mistakes_of(suspicion.tracer))
        all.push_back({std::string(words.name), std::string(words.words)});
    const Palette& palette = suspicion.palette;
    if (palette.red_and_blue_swapped) all.push_back({"red-blue-swapped", "red and blue are exchanged"});
    if (palette.background) {
        all.push_back({"background", "the background is " + in_words(*palette.background)});
    }
    if (palette.scale == ColorScale::clamped) {
        all.push_back(
            {"clamped-colors", "each channel that is not 0 is 255: colours from 0 to 255 are clamped as if they were from 0 to 1"});
    }
    if (palette.scale == ColorScale::divided) {
        all.push_back({"divided-colors", "channels are 0 or 1 of 255: colours from 0 to 1 are written without multiplying by 255"});
    }
    if (palette.inexact) {
        all.push_back({"inexact-colors", "colours are off by up to " + std::to_string(Palette::most_off) + " of 255"});
    }
    return all;
}

// The suspicions with one mistake more.
std::vector<Suspicion> more_suspicious(const Suspicion& base, const Comparer& comparer, WrongPictures& wrong) {
    std::vector<Suspicion> more;
    for (const WrongTracer& tracer : with_one_more_mistake(base.tracer, wrong.size())) {
        if (!wrong.takes_too_long(tracer)) more.push_back({tracer, base.palette});
    }
    const auto add = [&](auto change) {
        Suspicion changed = base;
        change(changed.palette);
        if (changed.palette != base.palette) more.push_back(changed);
    };
    add([](Palette& palette) { palette.red_and_blue_swapped = true; });
    add([](Palette& palette) { palette.inexact = true; });
    if (base.palette.scale == ColorScale::right) {
        add([](Palette& palette) { palette.scale = ColorScale::clamped; });
        add([](Palette& palette) { palette.scale = ColorScale::divided; });
    }
    const std::optional<Color> background = other_background(comparer, wrong.numbers(base.tracer));
    if (background && !base.palette.background) add([&](Palette& palette) { palette.background = background; });
    return more;
}

// The mistakes that are left one by one to be tried, and what was found with them.
struct Search {
    Suspicion likeliest{};
    std::vector<Suspicion> as_likely{};  // when it is a single mistake
    std::vector<Suspicion> singles{};    // that explain much more than they contradict, but for the likeliest; the best first
    bool float_as_likely = false;        // as a single mistake
};

constexpr std::size_t most_mistakes = 4;
// A further mistake must explain so many of the pixels that are left.
constexpr double least_part = 0.05;

// How many of the differing pixels show what float arithmetic without care may show; 0 where more than `most` of them do not.
std::int64_t shown_in_float(const Comparer& comparer, WrongPictures& wrong, std::int64_t most) {
    const Numbers& right = wrong.numbers({});
    wrong.numbers_in_float({});  // made once, before all cores ask
    std::atomic<std::int64_t> others = 0;
    const std::int64_t shown = comparer.count([&](std::size_t i) {
        if (others > most || comparer.shows(i, right[i], {})) return false;
        const Numbers perhaps = wrong.numbers_in_float(comparer.pixel(i));
        const bool is = std::ranges::any_of(perhaps, [&](std::int32_t number) { return comparer.shows(i, number, {}); });
        if (!is) ++others;
        return is;
    });
    return others > most ? 0 : shown;
}

Search search(const Comparer& comparer, WrongPictures& wrong) {
    Search out;
    const auto all = static_cast<std::int64_t>(comparer.pixels());
    std::int64_t shown = comparer.showing(wrong.numbers({}), {});
    std::vector<std::pair<std::int64_t, Suspicion>> better;
    for (std::size_t mistakes = 0; mistakes < most_mistakes && shown < all; ++mistakes) {
        std::vector<std::pair<std::int64_t, Suspicion>> tried;
        for (const Suspicion& next : more_suspicious(out.likeliest, comparer, wrong)) {
            tried.emplace_back(comparer.showing(wrong.numbers(next.tracer), next.palette), next);
        }
        std::ranges::stable_sort(tried, std::ranges::greater(), [](const auto& entry) { return entry.first; });
        std::erase_if(tried, [&](const auto& entry) { return entry.first <= shown; });
        std::erase_if(tried, [&](const auto& entry) {
            return static_cast<double>(entry.first - shown) < least_part * static_cast<double>(all - shown);
        });
        if (mistakes == 0) better = tried;
        if (tried.empty()) break;
        out.as_likely.clear();
        for (std::size_t i = 1; mistakes == 0 && i < tried.size() && tried[i].first == tried[0].first; ++i) {
            out.as_likely.push_back(tried[i].second);
        }
        std::tie(shown, out.likeliest) = tried[0];
    }
    // What explains little, or speaks against itself, only resembles the mistake that was made.
    const Numbers& right = wrong.numbers({});
    const Numbers& likeliest = wrong.numbers(out.likeliest.tracer);
    const auto is_right = [&](std::size_t i) { return comparer.shows(i, right[i], {}); };
    const auto is_explained = [&](std::size_t i) { return comparer.shows(i, likeliest[i], out.likeliest.palette); };
    const std::int64_t explained = comparer.count([&](std::size_t i) { return !is_right(i) && is_explained(i); });
    const std::int64_t contradicting = comparer.count([&](std::size_t i) { return is_right(i) && !is_explained(i); });
    const std::int64_t different = comparer.count([&](std::size_t i) { return !is_right(i); });
    if (2 * explained < different || 4 * contradicting > explained) return {};
    // Float arithmetic is no mistake that a picture is made with: what it may show is asked pixel by pixel.
    const std::int64_t in_float = shown_in_float(comparer, wrong, different - (explained - contradicting));
    if (in_float > explained - contradicting) return {};
    out.float_as_likely = in_float == explained - contradicting && named(out.likeliest).size() == 1;
    const std::vector<Named> used = named(out.likeliest);
    for (const auto& [count, single] : better) {
        const std::string name = named(single).front().name;
        if (std::ranges::find(used, name, &Named::name) == used.end()) out.singles.push_back(single);
    }
    return out;
}

// For each differing pixel the number of its share; `none` for the others.
constexpr std::uint8_t none = std::numeric_limits<std::uint8_t>::max();

constexpr std::string_view float_words = "too close for float arithmetic to tell which sphere is seen";

// By their place in the list of shares: the likeliest, then others, the last three for what comes from float, from nothing known,
// and what no sphere's colour is.
constexpr Color likeliest_mark{255, 255, 255};
constexpr std::array<Color, 3> other_marks = {{{255, 220, 0}, {255, 140, 0}, {160, 220, 0}}};
constexpr Color float_mark{0, 220, 255};
constexpr Color unknown_mark{255, 0, 255};
constexpr Color no_color_mark{150, 150, 150};

void add_examples(Diagnosis& out, const Comparer& comparer, const Numbers& right, const std::vector<std::uint8_t>& share_of) {
    const auto largest = std::ranges::max_element(out.shares, {}, &MistakeShare::pixels);
    const auto share = static_cast<std::uint8_t>(largest - out.shares.begin());
    constexpr std::int64_t most = 3;
    // At a quarter, the middle and three quarters of them in reading order: seldom all at one sphere's edge.
    std::int64_t passed = 0;
    for (std::size_t i = 0; i < share_of.size(); ++i) {
        if (share_of[i] != share) continue;
        const auto wanted = static_cast<std::int64_t>(out.examples.size()) + 1;
        const bool few = largest->pixels <= most;
        if (wanted <= most && (few || passed == largest->pixels * wanted / (most + 1))) {
            DifferingPixel example = comparer.difference(i, right[i], out.background);
            example.share = share;
            out.examples.push_back(example);
        }
        ++passed;
    }
}

// What a picture of one colour may mean.
std::string words_of_blank(const Color& color, const Scene& scene, const Background& background) {
    if (color == background.color) return "the whole picture is the background: no ray hits anything, or nothing is drawn";
    const auto has_color = [&](const Sphere& sphere) { return !sphere.hidden && sphere.color == color; };
    const auto sphere = std::ranges::find_if(scene.spheres, has_color);
    const std::string one = "the whole picture has one colour, " + in_words(color) + ", ";
    return sphere == scene.spheres.end()
               ? one + "which nothing in the scene has: nothing is drawn"
               : one + "that of sphere " + std::to_string(sphere - scene.spheres.begin()) + ": every ray counts as a hit";
}

}  // namespace

Diagnosis diagnose(const Image& picture, const Scene& scene, const Background& background, WrongPictures& wrong, Image* marked) {
    const Comparer comparer(picture, scene, background);
    const Numbers& right = wrong.numbers({});
    Diagnosis out;
    out.pixels = static_cast<std::int64_t>(comparer.pixels());
    out.different = out.pixels - comparer.showing(right, {});
    if (out.different == 0) return out;

    // A scene that fills the picture with one thing, or shows nothing of itself, has one colour to begin with.
    const Color first = comparer.found(0);
    const bool has_several = std::ranges::any_of(right, [&](std::int32_t number) { return number != right.front(); });
    const bool blank = has_several && comparer.count([&](std::size_t i) { return comparer.found(i) == first; }) == out.pixels;
    const Search found = blank ? Search{} : search(comparer, wrong);
    const Numbers& likeliest = wrong.numbers(found.likeliest.tracer);
    out.background = found.likeliest.palette.background;
    for (const Named& mistake : named(found.likeliest)) {
        out.likeliest.push_back(mistake.name);
        out.likeliest_words += (out.likeliest_words.empty() ? "" : "; and ") + mistake.words;
    }
    for (const Suspicion& other : found.as_likely) {
        out.as_likely.push_back(named(other).front().name);
        out.as_likely_words += (out.as_likely_words.empty() ? "" : "; or ") + named(other).front().words;
    }

    if (found.float_as_likely) {
        out.as_likely.emplace_back("float");
        out.as_likely_words += std::string(out.as_likely_words.empty() ? "" : "; or ") +
                               "float arithmetic: the spheres are too close for float to tell which is seen";
    }

    if (blank) {
        out.likeliest = {"blank"};
        out.likeliest_words = words_of_blank(first, scene, background);
    }

    const auto is_right = [&](std::size_t i) { return comparer.shows(i, right[i], {}); };
    std::vector<std::uint8_t> share_of(comparer.pixels(), none);
    const auto add_share = [&](const Named& mistake, const Color& mark, const auto& is) {
        MistakeShare share{mistake.name, mistake.words, 0, mark};
        share.pixels = comparer.count([&](std::size_t i) {
            if (share_of[i] != none || is_right(i) || !is(i)) return false;
            share_of[i] = static_cast<std::uint8_t>(out.shares.size());
            return true;
        });
        if (share.pixels > 0) out.shares.push_back(share);
    };

    // Say for each pixel why it differs: the first reason of these that holds.
    if (!out.likeliest.empty()) {
        const auto is_explained = [&](std::size_t i) { return blank || comparer.shows(i, likeliest[i], found.likeliest.palette); };
        std::string names = out.likeliest.front();
        for (std::size_t i = 1; i < out.likeliest.size(); ++i) names += "+" + out.likeliest[i];
        add_share({names, out.likeliest_words}, likeliest_mark, is_explained);
        out.explained = out.shares.empty() ? 0 : out.shares.front().pixels;
        out.contradicting = comparer.count([&](std::size_t i) { return is_right(i) && !is_explained(i); });
    }
    for (std::size_t k = 0; k < std::min(found.singles.size(), other_marks.size()); ++k) {
        const Suspicion& single = found.singles[k];
        const Numbers& numbers = wrong.numbers(single.tracer);
        add_share(named(single).front(), other_marks[k],
                  [&](std::size_t i) { return comparer.shows(i, numbers[i], single.palette); });
    }
    const auto has_color = [&](std::size_t i) { return comparer.number_of(comparer.found(i), out.background).has_value(); };
    wrong.numbers_in_float({});  // what it looks in is made once, before all cores ask
    add_share({"float", std::string(float_words)}, float_mark, [&](std::size_t i) {
        if (!has_color(i)) return false;
        const Numbers perhaps = wrong.numbers_in_float(comparer.pixel(i));
        return std::ranges::any_of(perhaps,
                                   [&](std::int32_t number) { return comparer.shows(i, number, found.likeliest.palette); });
    });
    if (out.likeliest.empty() && !out.shares.empty() && out.shares.back().name == "float" &&
        2 * out.shares.back().pixels > out.different) {
        out.likeliest = {"float"};
        out.likeliest_words = out.shares.back().words;
        out.explained = out.shares.back().pixels;
    }
    add_share({"unknown", "another sphere's colour or the background's, for no usual reason"}, unknown_mark, has_color);
    add_share({"no-color", "a colour that nothing in the scene has, such as a mixed or a shaded one"}, no_color_mark,
              [](std::size_t) { return true; });

    if (out.likeliest.empty()) {
        const PictureStyleWords style = words_of(style_of(comparer, right, wrong.size()));
        out.style = style.name;
        out.style_words = style.words;
    }

    add_examples(out, comparer, right, share_of);
    if (marked != nullptr) {
        *marked = Image(picture.width(), picture.height(), 3);
        for (std::size_t i = 0; i < share_of.size(); ++i) {
            const Color is = comparer.found(i);
            const auto dimmed = [](std::uint8_t value) { return static_cast<std::uint8_t>(value / 4); };
            const Color color =
                share_of[i] == none ? Color{dimmed(is.r), dimmed(is.g), dimmed(is.b)} : out.shares[share_of[i]].mark;
            std::uint8_t* at = marked->bytes().data() + 3 * i;
            at[0] = color.r;
            at[1] = color.g;
            at[2] = color.b;
        }
    }
    return out;
}

}  // namespace sphereview

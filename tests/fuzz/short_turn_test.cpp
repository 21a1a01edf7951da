// A short turn of each target, without libFuzzer: every input that once mattered to a fuzzer, and then a fixed number of inputs
// made of these by chance. SPHEREVIEW_SEED=N tries others, SPHEREVIEW_FUZZ_RUNS=N another number.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "base/input_file.hpp"
#include "fuzz/targets.hpp"
#include "support/folders.hpp"
#include "support/trials.hpp"

namespace sphereview {

namespace {

namespace fs = std::filesystem;

// In the order of their names, so that a seed gives the same inputs on every machine.
std::vector<std::string> corpus_of(const std::string& target) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(test::source_file("tests/fuzz/corpus/" + target)))
        files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::string> inputs;
    for (const fs::path& file : files) inputs.emplace_back(InputFile(file.string(), Content::binary).bytes());
    return inputs;
}

// Inputs made of a corpus.
class Mutator {
public:
    Mutator(const std::vector<std::string>& corpus, std::uint64_t seed) : corpus_(corpus), random_(seed) {}

    std::string next() {
        std::string bytes = any_of(corpus_);
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(bytes);
        return bytes;
    }

private:
    static constexpr std::size_t longest = 65536;

    std::size_t below(std::size_t end) { return static_cast<std::size_t>(random_() % end); }

    template <typename List>
    const typename List::value_type& any_of(const List& list) {
        return list[below(list.size())];
    }

    // A piece of the text: where it begins and how long it is.
    std::pair<std::size_t, std::size_t> piece_of(std::string_view text) {
        const std::size_t begin = below(text.size() + 1);
        return {begin, std::min(below(text.size() - begin + 1), below(2) == 0 ? std::size_t{4} : longest)};
    }

    void change(std::string& bytes) {
        static const std::vector<std::string> words = {"0",
                                                       "-1",
                                                       "1e308",
                                                       "1e-320",
                                                       "4294967296",
                                                       "18446744073709551616",
                                                       "nan",
                                                       "\"",
                                                       "'",
                                                       "[[",
                                                       "{",
                                                       "#",
                                                       "\\",
                                                       "\r",
                                                       "\n",
                                                       ",",
                                                       "\t",
                                                       "=",
                                                       "\xEF\xBB\xBF",
                                                       "\xFF",
                                                       std::string(1, '\0')};
        const auto [begin, length] = piece_of(bytes);
        switch (below(6)) {
            case 0:
                if (begin < bytes.size()) bytes[begin] = static_cast<char>(bytes[begin] ^ (1 << below(8)));
                break;
            case 1:
                if (begin < bytes.size()) bytes[begin] = static_cast<char>(below(256));
                break;
            case 2: bytes.erase(begin, length); break;
            case 3: bytes.replace(begin, below(2) == 0 ? length : 0, any_of(words)); break;
            case 4: {
                const std::string piece = bytes.substr(begin, length);
                for (std::size_t copies = 1 + below(8); copies > 0 && bytes.size() < longest; --copies) bytes.insert(begin, piece);
                break;
            }
            default: {
                const std::string& other = any_of(corpus_);
                const auto [from, count] = piece_of(other);
                bytes.insert(begin, other, from, count);
            }
        }
    }

    const std::vector<std::string>& corpus_;
    std::mt19937_64 random_;
};

struct ShortTurn : testing::TestWithParam<FuzzTarget> {
    // The targets' own files are in memory, where that is possible: a disk takes milliseconds for each file that replaces another.
    static void SetUpTestSuite() {
        if (fs::is_directory("/dev/shm")) setenv("TMPDIR", "/dev/shm", 1);
    }
};

}  // namespace

TEST_P(ShortTurn, FindsNothing) {
    const FuzzTarget& target = GetParam();
    // The input being tried, for the case that a sanitizer ends the process.
    const std::string last = test::build_file("fuzz-last-" + std::string(target.name));
    std::ofstream stream(last, std::ios::binary);
    const auto find_nothing_in = [&](const std::string& bytes) {
        stream.seekp(0);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
        fs::resize_file(last, bytes.size());
        ASSERT_EQ(target.wrong_with(bytes), "") << "by the input in " << last;
    };
    const std::vector<std::string> corpus = corpus_of(target.name);
    ASSERT_FALSE(corpus.empty());
    for (const std::string& bytes : corpus) ASSERT_NO_FATAL_FAILURE(find_nothing_in(bytes));
    const std::uint64_t runs = test::number_from_environment("SPHEREVIEW_FUZZ_RUNS", 2000);
    Mutator mutator(corpus, test::number_from_environment("SPHEREVIEW_SEED", 20261129));
    for (std::uint64_t run = 0; run < runs; ++run) ASSERT_NO_FATAL_FAILURE(find_nothing_in(mutator.next()));
    fs::remove(last);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, ShortTurn, testing::ValuesIn(fuzz_targets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace sphereview

// What is kept of where frames stand saves time and gives no other frame.
#include "formats/frame_index.hpp"

#include <gtest/gtest.h>
#ifdef __linux__
#include <sys/stat.h>
#endif

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "formats/frame_reader.hpp"
#include "support/environment.hpp"
#include "support/gzip.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace {

namespace fs = std::filesystem;

class KeptIndex : public testing::Test {
protected:
    // Changed long enough ago that a further change shows.
    std::string write(const std::string& name, const std::string& text) const {
        std::string path = folder_.write(name, text);
        set_age(path, std::chrono::hours(1));
        return path;
    }

    static void set_age(const std::string& path, std::chrono::seconds age) {
        fs::last_write_time(path, fs::file_time_type::clock::now() - age);
    }

    std::vector<fs::path> kept() const {
        std::vector<fs::path> files;
        const fs::path folder = fs::path(folder_.path("state")) / "sphereview" / "frames";
        if (!fs::is_directory(folder)) return files;
        for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
        return files;
    }

    // Reads the frame, and how many there are, in any text.
    static double x_of(const std::string& path, std::int64_t frame, std::int64_t expected_count = 20) {
        FrameReader reader(path, any_text());
        EXPECT_EQ(reader.count(), expected_count);
        return reader.read(frame).scene.spheres.at(0).center.x;
    }

    static DataOptions any_text() {
        DataOptions options;
        options.index_from = 0;
        return options;
    }

    test::TemporaryFolder folder_;
    test::Variable state_{"XDG_STATE_HOME", folder_.path("state")};
};

std::string frames(int count, int first = 0, const std::string& comment = "frame") {
    std::string text;
    for (int i = first; i < first + count; ++i) text += "1\n" + comment + "\nO " + std::to_string(i) + " 0 0\n";
    return text;
}

}  // namespace

#ifdef __linux__  // where the variable names the folder

TEST_F(KeptIndex, IsUsedAndGivesTheSameFrames) {
    for (const bool packed : {false, true}) {
        const std::string path =
            write(packed ? "a.xyz.gz" : "a.xyz", packed ? test::gzipped(frames(20) + "\n") : frames(20) + "\n");
        for (int run = 0; run < 2; ++run) {
            EXPECT_EQ(x_of(path, 19), 19.0);
            EXPECT_EQ(x_of(path, 3), 3.0);
        }
    }
    EXPECT_EQ(kept().size(), 2U);

    // Places are not looked for again: with the same bytes at both ends, size and time, it is not seen that a search would end.
    std::string text = frames(20, 0, std::string(1000, 'c'));
    const std::string path = write("b.xyz", text);
    const auto time = fs::last_write_time(path);
    EXPECT_EQ(x_of(path, 19), 19.0);
    text[text.find("O 9 0 0") + 8] = 'x';  // the number of atoms of frame 10
    folder_.write("b.xyz", text);
    fs::last_write_time(path, time);
    EXPECT_EQ(x_of(path, 11), 11.0);
    FrameReader reader(path, {});
    EXPECT_EQ(reader.count(), 10);
}

TEST_F(KeptIndex, OfAnotherFileCountsForNothing) {
    const std::string path = write("a.xyz", frames(20));
    EXPECT_EQ(x_of(path, 19), 19.0);
    ASSERT_EQ(kept().size(), 1U);

    // Of another size; of another time; with other bytes at an end.
    write("a.xyz", frames(15, 100));
    EXPECT_EQ(x_of(path, 14, 15), 114.0);
    const std::string other = "1\nframe of the same length\nO 5 0 0\n1\nshort\nO 6 0 0\n";
    write("a.xyz", other + frames(2));
    EXPECT_EQ(x_of(path, 1, 4), 6.0);
    const auto time = fs::last_write_time(path);
    folder_.write("a.xyz", "1\nshort\nO 6 0 0\n1\nframe of the same length\nO 5 0 0\n" + frames(2));
    fs::last_write_time(path, time);
    EXPECT_EQ(x_of(path, 1, 4), 5.0);

    // Changed where nothing shows it: the place begins no frame, and all are looked for again.
    const std::string filler(10'000, ' ');
    const std::string begin = "1\n" + filler + "\nO 0 0 0\n";
    const std::string end = "1\n" + filler + "\nO 9 0 0\n";
    write("a.xyz", begin + "1\nshort\nO 1 0 0\n1\nlong one\nO 2 0 0\n" + end);
    const auto old = fs::last_write_time(path);
    EXPECT_EQ(x_of(path, 2, 4), 2.0);
    folder_.write("a.xyz", begin + "1\nlong one\nO 2 0 0\n1\nshort\nO 1 0 0\n" + end);
    fs::last_write_time(path, old);
    EXPECT_EQ(x_of(path, 2, 4), 1.0);
}

// A frame without a head is read by that of an earlier one, which the index knows.
TEST_F(KeptIndex, OfXdatcarKnowsWhichFrameHasTheHead) {
    std::string text;
    for (int i = 0; i < 20; ++i) {
        if (i % 8 == 0) text += "a\n1\n" + std::to_string(10 + i) + " 0 0\n0 1 0\n0 0 1\nO\n1\n";
        text += "Direct configuration= " + std::to_string(i + 1) + "\n1 0 0\n";
    }
    const std::string path = write("XDATCAR", text);
    for (int run = 0; run < 2; ++run) {
        EXPECT_EQ(x_of(path, 19), 26.0);
        EXPECT_EQ(x_of(path, 7), 10.0);
        EXPECT_EQ(x_of(path, 8), 18.0);
    }
    ASSERT_EQ(kept().size(), 1U);
}

TEST_F(KeptIndex, DamagedIsMadeAnew) {
    const std::string path = write("a.xyz", frames(20));
    EXPECT_EQ(x_of(path, 19), 19.0);
    ASSERT_EQ(kept().size(), 1U);
    const fs::path file = kept()[0];
    const auto size = static_cast<std::size_t>(fs::file_size(file));
    std::string good(size, '\0');
    std::ifstream(file, std::ios::binary).read(good.data(), static_cast<std::streamsize>(size));
    for (std::size_t at = 0; at < size; at += 11) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x41);
        std::ofstream(file, std::ios::binary) << bad;
        ASSERT_EQ(x_of(path, 19), 19.0) << at;
        std::ofstream(file, std::ios::binary) << good.substr(0, at);
        ASSERT_EQ(x_of(path, 5), 5.0) << at;
    }
    std::string again(size, '\0');
    std::ifstream(file, std::ios::binary).read(again.data(), static_cast<std::streamsize>(size));
    EXPECT_EQ(again, good);
}

TEST_F(KeptIndex, WaitsForNoFifoInItsPlace) {
    const std::string path = write("a.xyz", frames(20));
    EXPECT_EQ(x_of(path, 19), 19.0);
    ASSERT_EQ(kept().size(), 1U);
    const fs::path file = kept()[0];
    fs::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(x_of(path, 19), 19.0);
    EXPECT_TRUE(fs::is_fifo(file));
}

TEST_F(KeptIndex, IsOnlyOfLongTextsAndWhereItMay) {
    const std::string path = write("a.xyz", frames(20));
    const auto read_with = [&](std::optional<std::uint64_t> index_from) {
        DataOptions options;
        options.index_from = index_from;
        FrameReader(path, options).read(19);
        return kept().size();
    };
    EXPECT_EQ(read_with(usual_index_from), 0U);
    EXPECT_EQ(read_with(std::nullopt), 0U);
    {
        const test::Variable nowhere("XDG_STATE_HOME", folder_.write("file", ""));
        EXPECT_EQ(x_of(path, 19), 19.0);
    }
    EXPECT_EQ(kept().size(), 0U);
    // Changed just now: a change within the same moment would not show.
    set_age(path, std::chrono::seconds(0));
    EXPECT_EQ(read_with(0), 0U);
    set_age(path, std::chrono::hours(1));
    EXPECT_EQ(read_with(0), 1U);

    // The oldest go.
    for (int i = 0; i < 70; ++i) x_of(write("more" + std::to_string(i) + ".xyz", frames(20)), 0);
    EXPECT_EQ(kept().size(), 64U);
}

#endif

}  // namespace sphereview

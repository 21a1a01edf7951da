// Films: uncompressed on standard output, and by ffmpeg, for which a script stands here.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>

#include "cli/fails.hpp"
#include "support/eventually.hpp"
#include "support/folders.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// Three frames that differ in one pixel of a 3 x 3 picture at most.
constexpr const char* film_frames = "1\n\nO 0 0 0\n1\n\nN 0 0 0\n1\n\nC 0 0 0\n";

class FilmCommand : public testing::Test {
protected:
    FilmCommand() { folder_.write("a.xyz", film_frames); }

    // A program `ffmpeg` that does what the script says; $film: the last argument.
    void write_encoder(const std::string& script) const {
        folder_.write("bin/ffmpeg", "#!/bin/sh\nfor film; do :; done\n" + script + "\n");
        chmod(folder_.path("bin/ffmpeg").c_str(), 0755);
    }

    Command film(const std::vector<std::string>& arguments, const std::string& path = "") const {
        std::vector<std::string> all = {"a.xyz", "--frames", "all", "-s", "3x3"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        Command command = cpu_render(folder_, all);
        command.environment.emplace_back("PATH", path.empty() ? folder_.path("bin") + ":/usr/bin:/bin" : path);
        return command;
    }

    // With something injected into system calls, by strace.
    static Command with_injected(Command command, const std::string& calls, const std::string& what) {
        const std::vector<std::string> by = {"strace",
                                             "-D",
                                             "-f",
                                             "-qq",
                                             "-o",
                                             "/dev/null",
                                             "-e",
                                             "trace=" + calls,
                                             "-e",
                                             "inject=" + calls + ":" + what,
                                             build_file("sphereview")};
        command.program = "/usr/bin/env";
        command.arguments.insert(command.arguments.begin(), by.begin(), by.end());
        command.environment.emplace_back("LSAN_OPTIONS", "detect_leaks=0");  // it, too, would want to trace the program
        return command;
    }
    // As a disk that takes long.
    static Command with_slow_disk(const Command& command, const std::string& delay) {
        return with_injected(command, "fsync", delay);
    }
    static bool can_slow_disk_down() { return run(with_slow_disk({.arguments = {"--version"}}, "delay_enter=1")).status == 0; }

    // The pixels of the pictures, one behind the other.
    std::string pixels() const {
        std::string all;
        for (const char* name : {"a-00000.png", "a-00001.png", "a-00002.png"}) all += decode_png(folder_.read(name)).bytes;
        return all;
    }

    TemporaryFolder folder_;
};

TEST_F(FilmCommand, IsUncompressedOnStandardOutput) {
    ASSERT_EQ(run(film({})).status, 0);
    const Outcome outcome = run(film({"-o", "-", "--fps", "24000/1001", "--background", "white"}));
    EXPECT_EQ(outcome.status, 0) << outcome;
    std::string expected = "YUV4MPEG2 W3 H3 F24000:1001 Ip A1:1 C444 XCOLORRANGE=LIMITED\n";
    ASSERT_EQ(run(film({"--background", "white"})).status, 0);
    const std::string shown = pixels();
    for (std::size_t frame = 0; frame < 3; ++frame) {
        expected += "FRAME\n";
        for (int plane = 0; plane < 3; ++plane) {
            for (std::size_t pixel = 0; pixel < 9; ++pixel) {
                const auto at = [&](std::size_t channel) {
                    return static_cast<double>(static_cast<unsigned char>(shown[(frame * 9 + pixel) * 3 + channel]));
                };
                const double luma = 0.2126 * at(0) + 0.7152 * at(1) + 0.0722 * at(2);
                const double value = plane == 0   ? 16.0 + luma * 219.0 / 255.0
                                     : plane == 1 ? 128.0 + (at(2) - luma) / 1.8556 * 224.0 / 255.0
                                                  : 128.0 + (at(0) - luma) / 1.5748 * 224.0 / 255.0;
                expected += static_cast<char>(static_cast<unsigned char>(value + 0.5));
            }
        }
    }
    EXPECT_EQ(outcome.output, expected);
    EXPECT_EQ(run(film({"-o", "-", "--json"})).status, 2);
}

TEST_F(FilmCommand, IsMadeByFfmpeg) {
    write_encoder("echo \"$@\" >words\ncat >\"$film\"");
    const Outcome outcome = run(film({"--movie", "out.mkv", "--fps", "25"}));
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output + outcome.errors, "");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.xyz", "bin", "out.mkv", "words"}));
    const std::string words = folder_.read("words");
    EXPECT_TRUE(contains(words, "-f rawvideo -pix_fmt rgb24 -video_size 3x3 -framerate 25/1 -i pipe:0 ")) << words;
    EXPECT_TRUE(contains(words, " -c:v ffv1 ")) << words;
    // Pictures beside it, which have the same pixels.
    ASSERT_EQ(run(film({"--movie", "out.mp4", "--quality", "75", "-o", "{name}-{frame:05}"})).status, 0);
    EXPECT_EQ(folder_.read("out.mp4"), pixels());
    EXPECT_EQ(folder_.read("out.mkv"), pixels());
    EXPECT_TRUE(contains(folder_.read("words"), " -c:v libx264 -crf 18 "));
    ASSERT_EQ(run(film({"--movie", "{name}.mkv"})).status, 0);
    EXPECT_EQ(folder_.read("a.mkv"), pixels());
}

// A player shows a faster one slowly.
TEST_F(FilmCommand, HasARateThatItsFormatCanSay) {
    write_encoder("exec cat >\"$film\"");
    for (const auto& [name, rate, instead] : std::vector<std::array<std::string, 3>>{{"out.gif", "60", "50"},
                                                                                     {"out.gif", "101/2", "50"},
                                                                                     {"out.webm", "2000", "1000"},
                                                                                     {"out.mkv", "1/601", "1000"},
                                                                                     {"out.png", "100000", "65535"}}) {
        const std::string words =
            "sphereview: --fps: found " + rate + ", expected 1/600 to " + instead + " pictures a second of " + name.substr(3);
        EXPECT_TRUE(fails(run(film({"--movie", name, "--fps", rate})), 2, words));
    }
    EXPECT_EQ(run(film({"--movie", "out.gif", "--fps", "50"})).status, 0);
}

TEST_F(FilmCommand, DoctorSaysWhatTheEncoderMakes) {
    const auto doctor = [&](const std::string& path) {
        Command command{.arguments = {"doctor"}, .folder = folder_.path()};
        command.environment.emplace_back("PATH", path);
        const std::string text = run(command).output;
        return text.substr(std::min(text.find("Films"), text.size()));
    };
    const std::string path = folder_.path("bin") + ":/usr/bin:/bin";
    write_encoder("echo ' V....D gif   GIF (Graphics Interchange Format)\n V....D libx264   H.264'");
    const std::string some = doctor(path);
    EXPECT_TRUE(some.starts_with("Films: work in part\n")) << some;
    EXPECT_TRUE(contains(some, ".mp4, .gif\n") && contains(some, ".webm (libvpx-vp9), .png (apng), .mkv (ffv1)\n")) << some;
    write_encoder("exit 1");
    const std::string none = doctor(path);
    EXPECT_TRUE(none.starts_with("Films: do not work\n")) << none;
    EXPECT_TRUE(contains(none, "bin/ffmpeg does not say which encoders it has\n")) << none;
    EXPECT_TRUE(contains(doctor("/nowhere"), "no program ffmpeg in the folders of PATH\n"));
}

TEST_F(FilmCommand, IsWholeOrNotAtAll) {
    folder_.write("out.mp4", "old");
    write_encoder("head -c 20 >\"$film\"\nprintf 'no such codec\\n  bad\\n' >&2\nexit 3");
    const Outcome failed = run(film({"--movie", "out.mp4"}));
    EXPECT_EQ(failed.status, 4) << failed;
    EXPECT_TRUE(contains(failed.errors, "out.mp4: cannot be written: ffmpeg has failed: no such codec; bad\n")) << failed;
    EXPECT_EQ(folder_.read("out.mp4"), "old");
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.xyz", "bin", "out.mp4"}));

    write_encoder("head -c 20 >\"$film\"\nkill -SEGV $$");
    const Outcome crashed = run(film({"--movie", "out.mp4"}));
    EXPECT_EQ(crashed.status, 4) << crashed;
    EXPECT_TRUE(contains(crashed.errors, "out.mp4: cannot be written: ffmpeg was ended by signal 11\n")) << crashed;

    // An encoder that says that all is well, and has written nothing.
    write_encoder("cat >/dev/null");
    const Outcome empty = run(film({"--movie", "out.mp4"}));
    EXPECT_EQ(empty.status, 4) << empty;
    EXPECT_EQ(folder_.read("out.mp4"), "old");

    const Outcome missing = run(film({"--movie", "out.mp4"}, "/nowhere"));
    EXPECT_EQ(missing.status, 3) << missing;
    EXPECT_TRUE(contains(missing.errors, "found no program ffmpeg")) << missing;

    // One that cannot be begun has no pictures to count.
    const Outcome nowhere = run(film({"--movie", "none/out.mp4"}));
    EXPECT_EQ(nowhere.status, 4) << nowhere;
    EXPECT_TRUE(nowhere.errors.starts_with("none/out.mp4: cannot be written: ")) << nowhere;
    EXPECT_FALSE(contains(nowhere.errors, "pictures were done")) << nowhere;

    // A frame that is bad ends the film.
    write_encoder("exec cat >\"$film\"");
    folder_.write("a.xyz", "1\n\nO 0 0 0\n1\n\nN 0 x 0\n1\n\nC 0 0 0\n");
    const Outcome bad = run(film({"--movie", "out.mp4", "--no-fit"}));
    EXPECT_EQ(bad.status, 2) << bad;
    EXPECT_TRUE(contains(bad.errors, "out.mp4: not written; 1 of 3 pictures were done\n")) << bad;
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.xyz", "bin", "out.mp4"}));
}

// The encoder takes nothing until it is ended, so the program waits in the middle of the film.
TEST_F(FilmCommand, InterruptedSaysHowFarItCame) {
    write_encoder("echo >started\nhead -c 27 >\"$film\"\nexec sleep 60");
    // A picture is more than a pipe holds.
    Command command = cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "300x300", "--movie", "out.mp4"});
    command.environment.emplace_back("PATH", folder_.path("bin") + ":/usr/bin:/bin");
    Running program(command);
    ASSERT_TRUE(eventually([&] { return folder_.has("started"); }));
    // As `timeout` and a terminal that is closed do: these are one interruption.
    program.send(SIGTERM);
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 143) << outcome;
    EXPECT_EQ(outcome.errors, "out.mp4: not written; 0 of 3 pictures were done\n");
    EXPECT_FALSE(folder_.has("out.mp4"));
    for (const std::string& name : folder_.names()) EXPECT_FALSE(contains(name, ".tmp")) << name;
}

// As the program begins to listen to interruptions.
TEST_F(FilmCommand, InterruptedAtItsBeginningLeavesNothingHidden) {
    write_encoder("exec cat >\"$film\"");
    if (!can_slow_disk_down()) GTEST_SKIP() << "no program can be traced here";
    const Outcome outcome = run(with_injected(film({"--movie", "out.mp4"}), "?pipe,pipe2", "signal=SIGINT:when=1"));
    EXPECT_EQ(outcome.status, 130) << outcome;
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.xyz", "bin"}));
}

// Nobody reads on, so the program waits within the first picture.
TEST_F(FilmCommand, InterruptedOnStandardOutputSaysHowFarItCame) {
    ASSERT_EQ(mkfifo(folder_.path("film").c_str(), 0600), 0);
    Command command = cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "300x300", "-o", "-"});
    command.program = "/bin/sh";
    command.arguments.insert(command.arguments.begin(), {"-c", "exec \"$0\" \"$@\" >film", build_file("sphereview")});
    Running program(command);
    std::ifstream film(folder_.path("film"));
    std::string head(40, ' ');
    ASSERT_TRUE(film.read(head.data(), static_cast<std::streamsize>(head.size())));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome;
    EXPECT_EQ(outcome.errors, "sphereview: interrupted; 0 of 3 pictures were done\n");
}

// The disk of the pictures beside the film is slow, so that the interruption comes while one of them is written.
TEST_F(FilmCommand, InterruptedWhileAPictureIsWrittenLeavesNothingHidden) {
    write_encoder("exec cat >\"$film\"");
    const Command command = film({"--movie", "out.mp4", "-o", "{name}-{frame:05}"});
    if (!can_slow_disk_down()) GTEST_SKIP() << "no program can be traced here";
    Running program(with_slow_disk(command, "delay_enter=500000"));
    const auto is_hidden = [](const std::string& name) { return name.ends_with(".tmp"); };
    ASSERT_TRUE(eventually([&] {
        return std::ranges::any_of(folder_.names(),
                                   [&](const std::string& name) { return is_hidden(name) && contains(name, ".png."); });
    }));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "out.mp4: not written; ")) << outcome;
    EXPECT_TRUE(std::ranges::none_of(folder_.names(), is_hidden)) << testing::PrintToString(folder_.names());
}

// The film has its name, and its folder takes long to be on the disk.
TEST_F(FilmCommand, InterruptedOnceItHasItsNameIsNotCalledUnwritten) {
    write_encoder("exec cat >\"$film\"");
    if (!can_slow_disk_down()) GTEST_SKIP() << "no program can be traced here";
    Running program(with_slow_disk(film({"--movie", "out.mkv"}), "delay_enter=2000000:when=2"));
    ASSERT_TRUE(eventually([&] { return folder_.has("out.mkv"); }));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_TRUE(outcome.status == 130 || outcome.status == 0) << outcome;
    EXPECT_FALSE(contains(outcome.errors, "not written")) << outcome;
    EXPECT_EQ(folder_.read("out.mkv").size(), 3U * 27U);
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.xyz", "bin", "out.mkv"}));
}

TEST_F(FilmCommand, IsNamedByWhatItBecomes) {
    write_encoder("exec cat >\"$film\"");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--movie", "out.avi"},
                                               {"--movie", "out.mp4", "-o", "-"},
                                               {"--movie", "out.gif", "--quality", "50"},
                                               {"--movie", "out.mp4", "--part", "1/2"},
                                               {"--fps", "30"},
                                               {"--movie", "out.mp4", "--fps", "0"},
                                               {"--quality", "50"},
                                               {"--movie", "a.xyz"}}) {
        EXPECT_EQ(run(film(arguments)).status, 2) << testing::PrintToString(arguments);
    }
    Command alone = cpu_render(folder_, {"a.xyz", "--movie", "out.mp4"});
    EXPECT_EQ(run(alone).status, 2);
    // A film of a format that has none cannot be seen through.
    EXPECT_EQ(run(film({"--movie", "out.mp4", "--background", "transparent"})).status, 2);
    EXPECT_EQ(run(film({"--movie", "out.png", "--background", "transparent"})).status, 0);
}

}  // namespace
}  // namespace sphereview::test

// Every input that once mattered to a fuzzer, replayed.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/input_file.hpp"
#include "fuzz/targets.hpp"
#include "support/folders.hpp"

namespace sphereview {

namespace {

void replay(const std::string& kind, std::string (*target)(std::string_view)) {
    int replayed = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_file("tests/fuzz/corpus/" + kind))) {
        SCOPED_TRACE(entry.path().filename());
        EXPECT_EQ(target(InputFile(entry.path().string(), Content::binary).bytes()), "");
        ++replayed;
    }
    EXPECT_GT(replayed, 0);
}

}  // namespace

TEST(Corpus, OfScenesIsReadAndWrittenWell) { replay("scene", fuzz_scene); }

TEST(Corpus, OfXyzFilesIsReadWell) { replay("xyz", fuzz_xyz); }

TEST(Corpus, OfCsvFilesIsReadWell) { replay("csv", fuzz_csv); }

TEST(Corpus, OfGzipIsUnpackedWell) { replay("gunzip", fuzz_gunzip); }

TEST(Corpus, OfPdbFilesIsReadWell) { replay("pdb", fuzz_pdb); }

TEST(Corpus, OfMmcifFilesIsReadWell) { replay("mmcif", fuzz_mmcif); }

TEST(Corpus, OfPngsIsReadAndWrittenWell) { replay("png", fuzz_png); }

}  // namespace sphereview

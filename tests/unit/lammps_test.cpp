// Dumps of LAMMPS.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/scene_format.hpp"
#include "support/spheres.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

SphereData dump(const std::string& text, const DataOptions& options = {}) { return read_lammps(text, "a.lammpstrj", options); }

// A frame of two atoms in a box of 10.
std::string dump_frame(const std::string& columns, const std::string& rows, const std::string& box = "0 10\n0 10\n0 10\n",
                       const std::string& box_head = "pp pp pp") {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + box_head + "\n" + box + "ITEM: ATOMS " + columns +
           "\n" + rows;
}

Centers dump_centers(const std::string& text) { return centers_of(dump(text).scene); }

}  // namespace

TEST(Lammps, ReadsPlacesTypesAndRadii) {
    const std::string text = dump_frame("id type x y z radius", "1 1 0 0 0 0.5\n2 2 3 0 0 0.5\n");
    const SphereData data = dump(text);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(3, 0, 0));
    EXPECT_EQ(data.scene.spheres[0].radius, 0.5);
    EXPECT_EQ(data.scene.names.at(0), "type 1");
    EXPECT_EQ(data.scene.names.at(1), "type 2");
    EXPECT_NE(data.scene.spheres[0].color, data.scene.spheres[1].color);
    EXPECT_EQ(data.frames, 1);
    EXPECT_TRUE(data.warnings.empty());
    for (const char* name : {"a", "dump.1000", "a.txt", "stdin"}) EXPECT_EQ(detect_format(text, name).name, "LAMMPS");
    EXPECT_EQ(detect_format("ITEM: UNITS\nlj\n" + text, "").name, "LAMMPS");
    EXPECT_EQ(format_of_name("A.LAMMPSTRJ").name, "LAMMPS");
}

TEST(Lammps, PutsTheAtomsInTheOrderOfTheirIds) {
    std::string rows;
    constexpr int count = 5000;
    for (int i = 0; i < count; ++i) {
        const int id = (i * 17) % count + 1;
        rows += std::to_string(id) + (id % 7 == 0 ? " X " : " C ") + std::to_string(id) + " 0 0\n";
    }
    const std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5000\nITEM: ATOMS id element x y z\n" + rows;
    const Scene scene = dump(text).scene;
    for (int i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(i);
        ASSERT_EQ(scene.spheres[place].center.x, i + 1);
        ASSERT_EQ(scene.names.at(static_cast<std::uint32_t>(i)), (i + 1) % 7 == 0 ? "X" : "C");
        ASSERT_EQ(scene.spheres[place].radius, (i + 1) % 7 == 0 ? virtual_site().radius : find_element("C")->radius);
    }
    const Scene without = dump(text, {.virtual_sites = false}).scene;
    ASSERT_EQ(without.spheres.size(), 4286U);
    for (const Sphere& sphere : without.spheres) ASSERT_NE(static_cast<int>(sphere.center.x) % 7, 0);
    // Ids that occur twice, or none.
    EXPECT_EQ(dump_centers(dump_frame("id x y z", "2 1 0 0\n2 2 0 0\n")), (Centers{{1, 0, 0}, {2, 0, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("x y z", "2 0 0\n1 0 0\n")), (Centers{{2, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("z y x id", "1 2 3 9\n4 5 6 -9\n")), (Centers{{6, 5, 4}, {3, 2, 1}}));
}

TEST(Lammps, PlacesMayBePartsOfTheBox) {
    EXPECT_EQ(dump_centers(dump_frame("id xs ys zs", "1 0 0.5 1\n2 0.25 0 0\n", "-5 5\n0 4\n2 10\n")),
              (Centers{{-5, 2, 10}, {-2.5, 0, 2}}));
    EXPECT_EQ(dump_centers(dump_frame("xsu ysu zsu", "2 0 0\n-1 0 0\n")), (Centers{{20, 0, 0}, {-10, 0, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("xu yu zu", "20 0 0\n-10 0 0\n")), (Centers{{20, 0, 0}, {-10, 0, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("xu yu zu x y z", "9 9 9 1 2 3\n9 9 9 4 5 6\n")), (Centers{{1, 2, 3}, {4, 5, 6}}));
    // Tilted: the bounds are those of the box around it, from 0 - 1 to 8 + 2 and from 0 to 8 + 3.
    EXPECT_EQ(dump_centers(dump_frame("xs ys zs", "0 0 0\n1 1 1\n", "-1 10 2\n0 11 -1\n0 8 3\n", "xy xz yz pp pp pp")),
              (Centers{{0, 0, 0}, {9, 11, 8}}));
    EXPECT_EQ(dump_centers(dump_frame("xs ys zs", "0 0 0\n0 0 1\n", "-3 10 -2\n-4 8 -1\n0 8 -4\n", "xy xz yz pp pp pp")),
              (Centers{{0, 0, 0}, {-1, -4, 8}}));
    // Any edges: a, b and c in the rows, and the corner behind them.
    EXPECT_EQ(dump_centers(dump_frame("xs ys zs", "0 0 0\n1 0.5 0.25\n", "4 0 0 1\n0 0 6 2\n0 8 0 3\n", "abc origin pp pp pp")),
              (Centers{{1, 2, 3}, {5, 4, 6}}));
}

TEST(Lammps, ElementsAndLabelsHaveTheirColours) {
    const Scene scene = dump(dump_frame("id type element x y z", "1 1 O 0 0 0\n2 2 Hw 3 0 0\n")).scene;
    EXPECT_EQ(scene.spheres.at(0).color, find_element("O")->color);
    EXPECT_EQ(scene.spheres.at(0).radius, find_element("O")->radius);
    EXPECT_EQ(scene.names.at(1), "Hw");
    const SphereData labels = dump(dump_frame("id type x y z", "1 Na 0 0 0\n2 Cl 3 0 0\n"));
    EXPECT_EQ(labels.scene.spheres.at(0).color, find_element("Na")->color);
    EXPECT_TRUE(labels.warnings.empty());
}

TEST(Lammps, WithoutRadiiTheyComeFromTheDistances) {
    const SphereData data = dump(dump_frame("id type x y z", "1 1 0 0 0\n2 1 4 0 0\n"));
    EXPECT_EQ(data.scene.spheres.at(0).radius, 1.0);
    ASSERT_EQ(data.warnings.size(), 1U);
    EXPECT_TRUE(data.warnings[0].starts_with("a.lammpstrj: no radius in the file: all get 1,")) << data.warnings[0];
    EXPECT_EQ(dump(dump_frame("x y z", "0 0 0\n4 0 0\n"), {.radius = 3.0}).scene.spheres.at(0).radius, 3.0);
    EXPECT_EQ(dump(dump_frame("x y z diameter", "0 0 0 3\n4 0 0 5\n")).scene.spheres.at(1).radius, 2.5);
    EXPECT_EQ(dump(dump_frame("element x y z radius", "O 0 0 0 0\nH 4 0 0 nan\n")).scene.spheres.at(1).radius,
              find_element("H")->radius);
}

TEST(Lammps, LabelsThatAreNoElementsAreTypes) {
    for (const char* columns : {"id type x y z", "id element x y z"}) {
        const SphereData data = dump(dump_frame(columns, "1 bead 0 0 0\n2 A 0.01 0 0\n"));
        EXPECT_EQ(data.scene.spheres.at(0).radius, 0.25 * 0.01) << columns;
        EXPECT_NE(data.scene.spheres.at(0).color, data.scene.spheres.at(1).color) << columns;
        EXPECT_EQ(data.scene.names.at(0), "bead");
        // The colours are those of the labels, and not of the order.
        const Scene turned = dump(dump_frame(columns, "1 A 0 0 0\n2 bead 0.01 0 0\n")).scene;
        EXPECT_EQ(turned.spheres.at(1).color, data.scene.spheres.at(0).color) << columns;
    }
    EXPECT_EQ(dump(dump_frame("id type x y z", "1 A 0 0 0\n2 X 0.01 0 0\n"), {.virtual_sites = false}).scene.spheres.size(), 2U);
    // B is boron where it is called an element, and a type beside types that are none.
    const Scene types = dump(dump_frame("id type x y z", "1 A 0 0 0\n2 B 0.01 0 0\n")).scene;
    EXPECT_EQ(types.spheres.at(1).radius, 0.25 * 0.01);
    EXPECT_NE(types.spheres.at(1).color, find_element("B")->color);
    const Scene known = dump(dump_frame("id element x y z", "1 bead 0 0 0\n2 C 0.01 0 0\n")).scene;
    EXPECT_EQ(known.spheres.at(0).radius, unknown_element().radius);
    EXPECT_EQ(known.spheres.at(1).color, find_element("C")->color);
}

TEST(Lammps, RowsWithoutPlacesAreLeftOutAndCounted) {
    const std::string columns = "id type x y z radius";
    for (const char* place : {"nan nan nan", "-nan 0 0", "0 inf 0", "0 0 nan(0x7)", "NA 0 0"}) {
        const SphereData data = dump(dump_frame(columns, std::string("2 1 ") + place + " 1\n1 2 3 4 5 1\n"));
        ASSERT_EQ(data.scene.spheres.size(), 1U) << place;
        EXPECT_EQ(data.scene.spheres[0].center, glm::dvec3(3, 4, 5));
        EXPECT_EQ(data.scene.names.at(0), "type 2");
        EXPECT_EQ(data.warnings, (std::vector<std::string>{"a.lammpstrj: 1 atom has no coordinates and is left out"}));
    }
    // Beside sites that are no atoms.
    const SphereData sites = dump(dump_frame("id element x y z", "2 X 1 2 3\n1 C nan 0 0\n"), {.virtual_sites = false});
    EXPECT_EQ(sites.scene.spheres.size(), 0U);
    EXPECT_EQ(sites.warnings.size(), 2U);
}

TEST(Lammps, PlacesMayBeOfSeveralKindsOrOfAPlane) {
    const std::string box = "2 12\n0 10\n0 10\n";
    EXPECT_EQ(dump_centers(dump_frame("id type x y", "1 1 1 2\n2 1 4 5\n")), (Centers{{1, 2, 0}, {4, 5, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("id xs ys", "1 .5 .5\n2 0 0\n", "2 12\n0 10\n-1 1\n")), (Centers{{7, 5, 0}, {2, 0, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("id xs ys zu", "1 .5 .25 3\n2 0 0 4\n", box)), (Centers{{7, 2.5, 3}, {2, 0, 4}}));
    // Old dumps name no columns.
    EXPECT_EQ(dump_centers(dump_frame("", "1 1 .5 .5 .5\n2 1 0 0 0\n", box)), (Centers{{7, 5, 5}, {2, 0, 0}}));
    EXPECT_EQ(dump_centers(dump_frame("", "1 1 5 5 5\n2 1 0 0 0\n", box)), (Centers{{5, 5, 5}, {0, 0, 0}}));
}

TEST(Lammps, ALastLineMayBeCutShort) {
    const std::string first = dump_frame("id type x y z radius", "1 1 0 0 0 0.5\n2 2 3 0 0 0.5\n");
    for (const std::string cut : {"2 ", "2 1 0", "2 1 0 0 0"}) {
        const std::string text = first + dump_frame("id type x y z radius", "1 1 0 0 0 0.5\n" + cut);
        const SphereData data = dump(text);
        EXPECT_EQ(data.frames, 1) << cut;
        EXPECT_EQ(data.warnings, (std::vector<std::string>{"a.lammpstrj:22:" + std::to_string(cut.size() + 1) +
                                                           ": the text ends, expected the whole line of the last atom of frame 1; "
                                                           "what follows frame 0 is passed over"}));
        EXPECT_NE(message_of<InputError>([&] { dump(text, {.frame = 1}); }), "") << cut;
        PartOfFile part{.frames = 1};
        EXPECT_NE(message_of<TextEnds>([&] { step_over_lammps(text.substr(first.size()), true, "a", part); }), "");
    }
    // A whole line needs no end.
    std::string whole = first + first;
    whole.pop_back();
    EXPECT_EQ(dump(whole).frames, 2);
    EXPECT_TRUE(dump(whole).warnings.empty());
    EXPECT_TRUE(dump(whole, {.frame = 1}).warnings.empty());
}

TEST(Lammps, HasFrames) {
    const std::string first = "ITEM: UNITS\nlj\n" + dump_frame("id x y z", "1 0 0 0\n2 3 0 0\n");
    const std::string second = "\nITEM: TIME\n0.5\n" + dump_frame("id x y z vx", "1 7 0 0 0\n2 8 0 0 0\n");
    const SphereData data = dump(first + second, {.frame = 1});
    EXPECT_EQ(data.frames, 2);
    EXPECT_EQ(data.scene.spheres.at(0).center.x, 7.0);
    std::string crlf;
    for (const char c : first + second) crlf += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(dump(crlf, {.frame = 1}).scene, data.scene);
    const SphereData cut = dump(first + second.substr(0, second.size() - 10));
    EXPECT_EQ(cut.frames, 1);
    ASSERT_FALSE(cut.warnings.empty());
    EXPECT_EQ(cut.warnings.back(),
              "a.lammpstrj:27:1: the text ends, expected atom 2 of 2 of frame 1; what follows frame 0 is passed over");
    EXPECT_EQ(message_of<InputError>([&] { dump(first, {.frame = 1}); }), "a.lammpstrj: found 1 frame, number 0, expected frame 1");
}

// Else the next frame's atoms would be this one's.
TEST(Lammps, AFrameWithoutTheHeadOfItsAtomsEndsTheFrames) {
    const std::string frame = dump_frame("id x y z", "1 0 0 0\n2 3 0 0\n");
    std::string headless = frame;
    headless.erase(headless.find("ITEM: ATOMS"), std::string_view("ITEM: ATOMS id x y z\n").size());
    const std::string begun = frame.substr(0, frame.find("ITEM: BOX"));
    const std::string of_frame = ", expected ITEM: ATOMS of frame 1";
    const std::vector<std::pair<std::string, std::string>> faults = {
        {headless, "20:1: found '1'"},
        {begun, "16:1: found 'ITEM: TIMESTEP'"},
        {begun.substr(begun.find("ITEM: NUMBER")) + begun.substr(begun.find("ITEM: NUMBER")),
         "14:1: found 'ITEM: NUMBER OF ATOMS'"},
    };
    for (const auto& [middle, found] : faults) {
        const std::string fault = "a.lammpstrj:" + found + of_frame;
        const SphereData data = dump(frame + middle + frame);
        EXPECT_EQ(data.frames, 1);
        ASSERT_FALSE(data.warnings.empty());
        EXPECT_EQ(data.warnings.back(), fault + "; what follows frame 0 is passed over");
        EXPECT_EQ(message_of<InputError>([&] { dump(frame + middle + frame, {.frame = 1}); }), fault);
    }
}

TEST(LammpsErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { dump(text); };
    const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n";
    expect_messages(
        "a.lammpstrj", read,
        {
            {"", "1:1: the text is empty, expected ITEM: TIMESTEP of frame 0"},
            {"hello\n", "1:1: found 'hello', expected ITEM: TIMESTEP of frame 0"},
            {"ITEM: TIMESTEP\n0\n", "3:1: the text ends, expected ITEM: ATOMS of frame 0"},
            {head + "many\n", "4:1: found 'many', expected the number of atoms of frame 0, a whole number"},
            {head + "-1\n", "4:1: found '-1', expected the number of atoms of frame 0 from 0 to 2000000000"},
            {head + "1e18\n", "4:1: found '1e18', expected the number of atoms of frame 0, a whole number"},
            {head + "2000000000\nITEM: ATOMS x y z\n1 2 3\n", "7:1: the text ends, expected atom 2 of 2000000000 of frame 0"},
            {"ITEM: TIMESTEP\n0\nITEM: ATOMS x y z\n",
             "3:1: found 'ITEM: ATOMS x y z', expected ITEM: NUMBER OF ATOMS of frame 0 above it"},
            {dump_frame("id type", "1 1\n2 1\n"),
             "9:1: found no places among the columns, expected x y z, xs ys zs, xu yu zu or xsu ysu zsu"},
            {head + "1\nITEM: ATOMS xs ys zs\n0 0 0\n",
             "5:1: found places in parts of a box, expected ITEM: BOX BOUNDS above them"},
            {dump_frame("xs ys zs", "0 0 0\n0 0 0\n", "0 10\n0\n0 10\n"),
             "7:2: the line ends, expected the y of the box, 2 numbers"},
            {dump_frame("xs ys zs", "0 0 0\n0 0 0\n", "0 nan\n0 1\n0 10\n"),
             "6:3: found 'nan', expected the x of the box, 2 numbers, a finite number"},
            {dump_frame("id x y z", "1 0 0 0\n2 0 zero 0\n"), "11:5: found 'zero', expected the y of atom 2 of 2, a number"},
            {dump_frame("xs ys zu", "0 0 0\n0 0 0\n", "0 1 1\n0 1 0\n0 1 0\n", "xy xz yz pp pp pp"),
             "9:1: found places in parts of a tilted box beside others, expected all of one kind"},
            {dump_frame("id x y z", "1 0 1e999 0\n2 0 0 0\n"),
             "10:5: found '1e999', expected the y of atom 1 of 2, a number that a double can hold (at most 1.8e308)"},
            {dump_frame("id x y z", "1 0 0\n2 0 0 0\n"), "10:6: the line ends, expected the z of atom 1 of 2"},
            {dump_frame("id x y z", "1.5 0 0 0\n2 0 0 0\n"), "10:1: found '1.5', expected the id of atom 1 of 2, a whole number"},
            {dump_frame("xs ys zs", "1e300 0 0\n0 0 0\n", "0 1e300\n0 1\n0 1\n"),
             "10:1: found a place beyond what a double can hold (at most 1.8e308), expected the place of atom 1 of 2"},
        });
}

}  // namespace sphereview

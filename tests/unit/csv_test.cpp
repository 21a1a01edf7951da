// Tables in text as programs write them, and what is said of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "unit/csv_tables.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

// The whole text as UTF-16; `text` is ASCII.
std::string as_utf16(const std::string& text, bool low_first, bool with_mark = true) {
    std::string bytes = !with_mark ? "" : low_first ? "\xFF\xFE" : "\xFE\xFF";
    for (const char c : text) bytes += low_first ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
}

}  // namespace

// The square of the number of quotes would be 64 times as much.
TEST(CsvQuotes, TakeTimeInProportion) {
    const auto seconds = [](std::size_t quotes) {
        const std::clock_t begin = std::clock();
        EXPECT_EQ(spheres("x,y,z,\"" + std::string(2 * quotes, '"') + "\"\n1,2,3,4\n").size(), 1U);
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    const double few = seconds(200'000);
    EXPECT_LT(seconds(1'600'000), 30.0 * few);
    EXPECT_EQ(table("x,y,z,name\n1,2,3,\"\"\"a\"\"\"\"b\"\n").scene.names.at(0), "\"a\"\"b");
}

TEST(CsvRadius, IsFoundUnderItsNames) {
    for (const char* name : {"radius", "Radius", "RADIUS", "r", "R [nm]", "radius (um)", "rad"}) {
        EXPECT_EQ(spheres("x,y,z," + std::string(name) + "\n1,2,3,0.5\n")[0].radius, 0.5) << name;
    }
    for (const char* name : {"diameter", "Diameter [um]", "ESTIMATED_DIAMETER", "EquivDiameter", "Durchmesser"}) {
        EXPECT_EQ(spheres("x,y,z," + std::string(name) + "\n1,2,3,0.5\n")[0].radius, 0.25) << name;
    }
    EXPECT_EQ(spheres("x,y,z,radius,diameter\n1,2,3,0.5,7\n")[0].radius, 0.5);
    // No radius at all, or one that says none.
    const std::vector<Sphere> some = spheres("x,y,z,radius\n1,2,3,0\n1,2,4,\n1,2,5,nan\n1,2,6,0.5\n");
    ASSERT_EQ(some.size(), 4U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(some[i].radius, 1.0) << i;
    EXPECT_EQ(some[3].radius, 0.5);
    EXPECT_EQ(spheres("x,y,z,radius\n0,0,0,0\n0,0,8,0\n")[0].radius, 2.0);
}

TEST(CsvRows, WithARadiusOrColourThatIsNoneAreShownAndCounted) {
    for (const char* radius : {"-1", "abc", "1e999", "1.2.3"}) {
        const SphereData data = table("x,y,z,radius\n1,2,3," + std::string(radius) + "\n4,5,6,2\n");
        ASSERT_EQ(data.scene.spheres.size(), 2U) << radius;
        EXPECT_EQ(data.scene.spheres[0].radius, 1.0) << radius;
        EXPECT_EQ(data.scene.spheres[1].radius, 2.0) << radius;
        EXPECT_EQ(data.warnings, Lines{"a.csv: 1 row has a radius or colour that is none, and gets the usual one"}) << radius;
    }
    for (const char* red : {"-1", "red", "0xfff", "300%", "999"}) {
        const SphereData data = table("x,y,z,radius,r,g,b\n1,2,3,-4," + std::string(red) + ",0,0\n4,5,6,2,1,2,3\n7,8,9,2,x,2,3\n");
        ASSERT_EQ(data.scene.spheres.size(), 3U) << red;
        EXPECT_EQ(data.scene.spheres[0].color, (Color{255, 255, 255})) << red;
        EXPECT_EQ(data.scene.spheres[1].color, (Color{1, 2, 3})) << red;
        EXPECT_EQ(data.warnings, Lines{"a.csv: 2 rows have a radius or colour that is none, and get the usual one"}) << red;
    }
    EXPECT_EQ(table("x,y,z,radius,color\n1,2,3,,#ff8000\n4,5,6,1,none\n4,5,6,1,\n").warnings, Lines{});
}

TEST(CsvColors, AreWhatTheColumnHolds) {
    const Color orange{255, 128, 0};
    for (const char* rows :
         {"r,g,b\n1,2,3,1.0,0.5,0.0\n", "r,g,b\n1,2,3,255.0,128.0,0.0\n", "red,green,blue\n1,2,3,255,128,0\n",
          "Color.R,Color.G,Color.B\n1,2,3,1,0.5,0\n", "RGB:0,RGB:1,RGB:2\n1,2,3,255,128,0\n", "Rf,Gf,Bf\n1,2,3,1.000,0.502,0.000\n",
          "color\n1,2,3,#ff8000\n", "hex\n1,2,3,FF8000\n", "colour\n1,2,3,0xff8000ff\n"}) {
        const SphereData data = table("x,y,z," + std::string(rows));
        ASSERT_EQ(data.scene.spheres.size(), 1U) << rows;
        EXPECT_EQ(data.scene.spheres[0].color, orange) << rows;
        EXPECT_EQ(data.notes, Lines{}) << rows;
    }
    EXPECT_EQ(spheres("color,x,y,z\n#ff8000,1,2,3\n#0f0,4,5,6\n")[1].color, (Color{0, 255, 0}));
    // Pure colours are parts of 1, also where they are written as whole numbers.
    EXPECT_EQ(spheres("x,y,z,Color.R,Color.G,Color.B\n1,2,3,1,0,0\n4,5,6,0,0,1\n")[1].color, (Color{0, 0, 255}));
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,1,1,1\n1,2,3,2,0,0\n")[0].color, (Color{1, 1, 1}));
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,0,0,0\n")[0].color, (Color{0, 0, 0}));
    // 16 bits, percent and hexadecimal.
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,65535,32896,0\n")[0].color, orange);
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,100%,50 %,0%\n")[0].color, orange);
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,0xff,0x80,0\n1,2,3,9,0,0\n")[0].color, orange);
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,256,128,0\n")[0].color, orange);
    // Only a late row shows that the first are bytes.
    std::string many = "x,y,z,r,g,b\n";
    for (int i = 0; i < 3000; ++i) many += "1,2,3,1.0,0.0,1.0\n";
    EXPECT_EQ(spheres(many)[0].color, (Color{255, 0, 255}));
    EXPECT_EQ(spheres(many + "1,2,3,200.0,0.0,0.0\n")[0].color, (Color{1, 0, 1}));
    // What says no colour is no reason to refuse a place.
    EXPECT_EQ(spheres("x,y,z,r,g,b\n1,2,3,0,nan,0\n")[0].color, (Color{255, 255, 255}));
    EXPECT_EQ(spheres("x,y,z,color\n1,2,3,#ff8000\n1,2,3,none\n")[1].color, (Color{255, 255, 255}));
}

TEST(CsvColors, AreNoOtherNumbers) {
    for (const char* values : {"100\n1,2,3,200", "123456\n1,2,3,654321", "1\n1,2,3,2", "fad\n1,2,3,bed", "ff8000\n1,2,3,west12"}) {
        const SphereData data = table("x,y,z,color\n1,2,3," + std::string(values) + "\n");
        EXPECT_EQ(data.scene.spheres.at(0).color, (Color{255, 255, 255})) << values;
        EXPECT_EQ(data.property_names, Lines{"color"}) << values;
    }
    EXPECT_EQ(spheres("x,y,z,color\n1,2,3,001122\n1,2,3,334455\n")[1].color, (Color{0x33, 0x44, 0x55}));
    EXPECT_EQ(spheres("x,y,z,c\n1,2,3,112233\n", with_columns("color=c"))[0].color, (Color{0x11, 0x22, 0x33}));
    // One number for all three, as PCL and Java write it.
    EXPECT_EQ(spheres("x,y,z,rgb\n0,0,0,16744448\n1,0,0,255\n")[0].color, (Color{255, 128, 0}));
    EXPECT_EQ(spheres("x,y,z,rgb\n0,0,0,-32768\n1,0,0,255\n")[0].color, (Color{255, 128, 0}));
    EXPECT_EQ(spheres("x,y,z,c\n1,2,3,16744448\n4,5,6,255\n", with_columns("color=c"))[0].color, (Color{255, 128, 0}));
}

TEST(CsvElements, MayBeNamesOfAtoms) {
    for (const char* text : {"atom,resname,x,y,z\nN,ALA,0,0,0\nCA,ALA,1,0,0\nC,ALA,2,0,0\nO,ALA,3,0,0\n",
                             "atom,x,y,z\nN,0,0,0\nCA,1,0,0\nC,2,0,0\nO,3,0,0\n",
                             "Atom Name;Residue;x;y;z\nN;GLY;0;0;0\nCA;GLY;1;0;0\nHB1;GLY;2;0;0\n"}) {
        const SphereData data = table(text, {.all_properties = true});
        EXPECT_EQ(data.scene.spheres.at(1).color, find_element("C")->color) << text;
        EXPECT_EQ(data.scene.spheres.at(1).radius, find_element("C")->radius) << text;
        const auto element = std::ranges::find(data.scene.properties, "element", &Property::name);
        ASSERT_NE(element, data.scene.properties.end()) << text;
        EXPECT_EQ(std::get<Labels>(element->values).words.at(1), "C") << text;
    }
    EXPECT_EQ(spheres("atom,resname,x,y,z\nCA,CA,1,0,0\n")[0].color, find_element("Ca")->color);
    EXPECT_EQ(spheres("atom,x,y,z\nCA,1,0,0\nO,0,0,0\n")[0].color, find_element("Ca")->color);
    EXPECT_EQ(spheres("atom,residue,x,y,z\n1,ALA,1,0,0\n2,ALA,0,0,0\n")[0].color, (Color{255, 255, 255}));  // numbers of atoms
}

TEST(CsvElements, MayBeAtomicNumbers) {
    EXPECT_EQ(spheres("Z,x,y,z\n6,1,2,3\n8,4,5,6\n")[1].radius, find_element("O")->radius);
    EXPECT_EQ(spheres("x,y,z,Atomic Number\n1,2,3,6\n")[0].radius, find_element("C")->radius);
    EXPECT_EQ(spheres("Z,x,y,z\n6,1,2,3\n200,1,2,11\n")[0].radius, 2.0);
    EXPECT_EQ(spheres("X,Y,Z\n1,2,6\n1,2,14\n")[0].radius, 2.0);
}

TEST(CsvElements, MayBeNoAtoms) {
    const SphereData data = table("element,x,y,z,radius\nMW,1,2,3,5\nO,4,5,6,1\nLP1,4,5,6,0.01\n");
    EXPECT_EQ(data.warnings,
              Lines{"a.csv: found 2 virtual sites or dummies, which are no atoms; shown small, or not with --no-virtual"});
    ASSERT_EQ(data.scene.spheres.size(), 3U);
    EXPECT_EQ(data.scene.spheres[0].radius, virtual_site().radius);
    EXPECT_EQ(data.scene.spheres[1].radius, 1.0);
    EXPECT_EQ(data.scene.spheres[2].radius, 0.01);
    // Where the unit is another one, 0.2 is large.
    EXPECT_EQ(spheres("element,x,y,z,radius\nMW,1,2,3,0.1\nO,4,5,6,0.05\n")[0].radius, 0.05);
    const SphereData without = table("element,x,y,z\nMW,1,2,3\nO,4,5,6\n", {.virtual_sites = false});
    EXPECT_EQ(without.warnings, Lines{"a.csv: found 1 virtual site or dummy, which is no atom; left out"});
    ASSERT_EQ(without.scene.spheres.size(), 1U);
    EXPECT_EQ(without.scene.names.at(0), "O");
    // Counted over all pieces of a long table.
    std::string many = "element,x,y,z\n";
    for (int i = 0; i < 40000; ++i) many += i % 2 == 0 ? "X,0.00,0.00,0.00\n" : "O,1.00,0.00,0.00\n";
    for (const Sphere& sphere : spheres(many, {.virtual_sites = false})) ASSERT_EQ(sphere.center.x, 1.0);
    EXPECT_EQ(spheres(many, {.virtual_sites = false}).size(), 20000U);
}

TEST(CsvElements, GiveColoursAndRadii) {
    for (const char* name : {"element", "type", "Particle Type", "species"}) {
        const SphereData data = table(std::string(name) + ",x,y,z\nO,0,0,0\nH,0,0,1\n");
        ASSERT_EQ(data.scene.spheres.size(), 2U) << name;
        EXPECT_EQ(data.scene.spheres[0].radius, 0.66) << name;
        EXPECT_EQ(data.scene.spheres[1].radius, 0.31) << name;
        EXPECT_EQ(data.scene.spheres[0].color, find_element("O")->color) << name;
        EXPECT_EQ(data.scene.names, (std::map<std::uint32_t, std::string>{{0, "O"}, {1, "H"}})) << name;
        EXPECT_EQ(data.warnings, Lines{}) << name;
    }
    EXPECT_EQ(spheres("element,x,y,z\n8,0,0,0\n")[0].radius, 0.66);
    // Types that are none of elements.
    const SphereData data = table("Position.X,Position.Y,Position.Z,Radius,Particle Type\n1,2,3,0.5,1\n");
    EXPECT_EQ(data.scene.spheres, (std::vector<Sphere>{{{1, 2, 3}, 0.5, {255, 255, 255}, false}}));
    EXPECT_EQ(data.notes, passed_over("'Particle Type'"));
    EXPECT_EQ(table("type,x,y,z\nC,0,0,0\nbond,0,0,1\n").scene.names.size(), 0U);
}

TEST(CsvDialects, OfProgramsAreRead) {
    for (const std::string text : {
             "# made by own program\nx,y,z\n1,2,3\n4,5,6\n",
             "x,y,z\n# between\n1,2,3\n\n// and here\n4,5,6\n#",
             "x y z\n1 2 3\n4 5 6\n",
             "  x   y   z  \n 1  2\t 3 \n 4 5 6\n",
             "x\ty\tz\n1\t2\t3\n4\t5\t6\n",
             "sep=;\nx;y;z\n1;2;3\n4;5;6\n",
             "\"sep=|\"\r\nx|y|z\r\n1|2|3\r\n4|5|6\r\n",
             "x [nm] y [nm] z [nm]\n1 2 3\n4 5 6\n",
             "\"x\" \"y\" \"z\"\n\"1\" 1 2 3\n\"2\" 4 5 6\n",                // R's write.table
             "\"\",\"x\",\"y\",\"z\"\n\"1\",1,2,3\n\"2\",4,5,6\n",           // R's write.csv
             "# x y z\n1.0e+00 2.0e+00 3.0e+00\n4.0e+00 5.0e+00 6.0e+00\n",  // numpy.savetxt
             "# x,y,z\n1 2 3\n4 5 6\n",
             "# columns: x y z\nx,y,z\n1,2,3\n4,5,6\n",
             "//X Y Z\n2\n1.0 2.0 3.0\n4.0 5.0 6.0\n",  // CloudCompare
             "x,y,z\nnm,nm,nm\n1,2,3\n4,5,6\n",         // a row of units
             "LABEL,POSITION_X,POSITION_Y,POSITION_Z\nLabel,X,Y,Z\nLabel,X,Y,Z\n,(micron),(micron),(micron)\nID1,1,2,3\nID2,4,5,"
             "6\n",
             "\nPosition\n====================\n\nPosition X,Position Y,Position Z,Unit,Category\n1,2,3,um,Spot\n4,5,6,um,Spot\n",
             "x,y,z\n1,2,3\n4,5,6\n,,\n,,\n",  // a spreadsheet's empty rows
             "Image,Nuclei,Nuclei,Nuclei\nImageNumber,Location_Center_X,Location_Center_Y,Location_Center_Z\n1,1,2,3\n1,4,5,6\n",
             " \tArea\tX\tY\tZ\n1\t9\t1\t2\t3\n2\t9\t4\t5\t6\n",  // ImageJ
             "x|y|z\n1|2|3\n4|5|6\n",
             "x,y,z\n1.0D+00,2d0,3\n4,5.0,6.0+00\n",
             "x,y,z,id\n(um),(um),(um),1\n1,2,3,9\n4,5,6,8\n",
             "x,y,z\n1,2,3\n4,5,6\n\x1A",
             "C,1,2,3\nO,4,5,6\n",
             "C 1 2 3\nO 4 5 6\n",
         }) {
        EXPECT_EQ(centers(text), two_centers) << text;
        EXPECT_EQ(centers(as_utf16(text, true)), two_centers) << text;
        EXPECT_EQ(centers(as_utf16(text, false)), two_centers) << text;
        EXPECT_EQ(centers(as_utf16(text, true, false)), two_centers) << text;
        EXPECT_EQ(centers(as_utf16(text, false, false)), two_centers) << text;
        std::string crlf;
        for (const char c : text) crlf += c == '\n' ? "\r\n" : std::string(1, c);
        if (text.find('\r') == std::string::npos) {
            EXPECT_EQ(centers(crlf), two_centers) << text;
        }
    }
}

TEST(CsvDialects, HaveDecimalCommas) {
    const std::vector<Sphere> both = {{{1.5, 2.5, 3.5}, 0.5, {255, 255, 255}, false},
                                      {{2.5, 2.5, 3.5}, 0.5, {255, 255, 255}, false}};
    for (const char* text :
         {"x;y;z;radius\n1,5;2,5;3,5;0,5\n2,5;2,5;3,5;0,5\n", "x\ty\tz\tradius\n1,5\t2,5\t3,5\t0,5\n2,5\t2,5\t3,5\t0,5\n",
          "x,y,z,radius\n\"1,5\",\"2,5\",\"3,5\",\"0,5\"\n\"2,5\",\"2,5\",\"3,5\",\"0,5\"\n",
          "x y z radius\n1,5 2,5 3,5 0,5\n2,5 2,5 3,5 0,5\n"}) {
        EXPECT_EQ(spheres(text), both) << text;
    }
    EXPECT_EQ(centers("1,5;2;3\n2,5;2;3\n"), (Centers{{1.5, 2, 3}, {2.5, 2, 3}}));
    // Between commas 1,234 is a thousand, unless other numbers show that it is not.
    EXPECT_EQ(centers("x,y,z\n\"1,234\",2,\"-12,345,678\"\n"), (Centers{{1234, 2, -12345678}}));
    EXPECT_EQ(centers("x,y,z\n\"1,234.5\",2.5,\"3\"\n"), (Centers{{1234.5, 2.5, 3}}));
    EXPECT_EQ(centers("x,y,z\n\"1,234\",\"0,500\",3\n"), (Centers{{1.234, 0.5, 3}}));
    const Scene thousands = table("x,y,z,v\n1,2,3,\"1,234\"\n4,5,6,\"2,345\"\n", {.all_properties = true}).scene;
    EXPECT_EQ(std::get<std::vector<double>>(thousands.properties.at(0).values), (std::vector<double>{1234, 2345}));
    // Neither commas behind the point nor ranges are numbers.
    for (const std::string value : {"\"1.234,56\"", "\"1.5,3\"", "10.5-12", "1.5-3"}) {
        const Scene scene = table("x,y,z,v\n1,2,3," + value + "\n4,5,6,7\n", {.all_properties = true}).scene;
        EXPECT_FALSE(std::holds_alternative<std::vector<double>>(scene.properties.at(0).values)) << value;
    }
    // 1,234 is a thousand where other numbers have points.
    EXPECT_EQ(message_of<InputError>([] { spheres("x;y;z\n1,234;2.5;3\n"); }), "a.csv:2:1: found '1,234', expected x, a number");
}

TEST(CsvWithoutHeader, TakesTheFirstColumns) {
    for (const char* text :
         {"1,2,3\n4,5,6\n", "1 2 3\n4 5 6\n", "1;2;3;\n4;5;6;\n", "# a cloud\n1.0 2.0 3.0 0.7\n4.0 5.0 6.0 0.7\n"}) {
        EXPECT_EQ(centers(text), two_centers) << text;
    }
    const SphereData data = table("1,2,3\n4,5,6\n");
    ASSERT_EQ(data.warnings.size(), 2U);
    EXPECT_EQ(data.warnings[0], "a.csv: no header: the first columns are taken for x, y and z");
    const SphereData colored = table("1.5 2 3 255 128 0 0.7\n4 5 6 255 128 0 0.7\n");
    EXPECT_EQ(colored.scene.spheres[1].color, (Color{255, 128, 0}));
    EXPECT_EQ(colored.notes, passed_over("'column7'"));
    // Names that nobody knows are no reason to guess.
    EXPECT_EQ(message_of<InputError>([] { spheres("mass,time,depth\n1,2,3\n"); }),
              "a.csv:1:1: found the columns 'mass', 'time', 'depth', expected a header with x, y, z, and perhaps radius, r, g, b, "
              "name; --columns x=NAME,y=NAME,z=NAME names others");
    // An element may stand first.
    EXPECT_EQ(spheres("C,1,2,3\nO,4,5,6\n")[1].radius, find_element("O")->radius);
    EXPECT_EQ(table("C,1,2,3\nQ,4,5,6\n").scene.spheres[0].color, (Color{255, 255, 255}));
}

TEST(CsvRows, WithoutCoordinatesAreLeftOutAndCounted) {
    const SphereData one = table("x,y,z\n1,2,3\nnan,nan,nan\n");
    EXPECT_EQ(one.scene.spheres.size(), 1U);
    EXPECT_EQ(one.warnings, Lines{"a.csv: 1 row has no coordinates and is left out"});
    const SphereData some = table("x,y,z,name\n1,2,3,a\n,,,b\nNA,NA,NA,c\n4,,6,d\n4,5,6,e\n#N/A,1,2,f\ninf,1,2,g\n,,,\n");
    EXPECT_EQ(some.scene.spheres.size(), 2U);
    EXPECT_EQ(some.scene.names, (std::map<std::uint32_t, std::string>{{0, "a"}, {1, "e"}}));
    EXPECT_EQ(some.warnings[0], "a.csv: 5 rows have no coordinates and are left out");
    EXPECT_EQ(table("x,y\n1,2\n4,5\n").warnings[0], "a.csv: no column for z: all lie in the plane z = 0");
    EXPECT_EQ(centers("x,y\n1,2\n4,5\n"), (Centers{{1, 2, 0}, {4, 5, 0}}));
}

TEST(CsvRows, MayHoldWhatLibrariesWriteForNone) {
    for (const char* none : {"<NA>", "NaT", "1.#QNAN", "-1.#IND", "1.#INF00", "-1.#IND00", "NULL", "nan(0x7)"}) {
        EXPECT_EQ(centers("x,y,z\n1,2,3\n" + std::string(none) + ",1,1\n4,5,6\n"), two_centers) << none;
    }
    EXPECT_EQ(centers("x,y,z\n\xE2\x88\x92"
                      "1,2\xC2\xA0,3\n"),
              (Centers{{-1, 2, 3}}));
}

TEST(DetectFormat, KnowsTablesUnderATextsName) {
    for (const std::string text : {"x y z\n1 2 3\n", "x\ty\tz\n1\t2\t3\n", "0.1 0.2 0.3\n0.4 0.5 0.6\n", "1,2,3\n", "1;2;3\n",
                                   "sep=;\nx;y;z\n", "//X Y Z R G B\n1 2 3 4 5 6\n"}) {
        for (const char* name : {"a.txt", "a.dat", "stdin"}) {
            EXPECT_EQ(detect_format(text, name).name, "CSV") << text;
            EXPECT_EQ(detect_format(as_utf16(text, true), name).name, "CSV") << text;
        }
        EXPECT_NE(detect_format(text, "a.toml").name, "CSV") << text;
    }
    for (const char* name : {"a.csv", "a.tsv", "a.asc", "a.CSV.gz"}) EXPECT_EQ(detect_format("", name).name, "CSV");
    for (const std::string text : {"1 2 3\n4 5 6\n", "1\n255 0 0 1.5 2 3 4\n", "x y\n1 2\n", "the x y z of it\n1 2\n"}) {
        EXPECT_EQ(detect_format(text, "a.txt").name, "text") << text;
    }
}

}  // namespace sphereview

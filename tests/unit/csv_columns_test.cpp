// The columns of tables in text: what they are called, and their units.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/scene_format.hpp"
#include "unit/csv_tables.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

TEST(CsvColumns, AreKnownByTheNamesThatProgramsGive) {
    for (const char* header : {
             "x,y,z",
             "X,Y,Z",
             "x [nm],y [nm],z [nm]",
             "x (um),y (um),z (um)",
             "X(\xC2\xB5m),Y(\xC2\xB5m),Z(\xC2\xB5m)",
             "x(\xB5m),y(\xB5m),z(\xB5m)",
             "x_nm,y_nm,z_nm",
             "x/nm,y/nm,z/nm",
             "\"Points:0\",\"Points:1\",\"Points:2\"",
             "Points_0,Points_1,Points_2",
             "Position.X,Position.Y,Position.Z",
             "Position X,Position Y,Position Z",
             "POSITION_X,POSITION_Y,POSITION_Z",
             "pos_x,pos_y,pos_z",
             "x_pos,y_pos,z_pos",
             "Location_Center_X,Location_Center_Y,Location_Center_Z",
             "Centroid_1,Centroid_2,Centroid_3",
             "center_x,center_y,center_z",
             "XM,YM,ZM",
             "CX (pix),CY (pix),CZ (pix)",
             "Var1,Var2,Var3",
             "V1,V2,V3",
             "# X,Y,Z",
             "//X,Y,Z",
             "% x,y,z",
             "x{nm},y{nm},z{nm}",
             "x in mm,y in mm,z in mm",
             "x\xC2\xA0,y,\xC2\xA0z",
             "centroid-0,centroid-1,centroid-2",
         }) {
        EXPECT_EQ(centers(std::string(header) + "\n1,2,3\n4,5,6\n"), two_centers) << header;
    }
    // Several that may be meant: what is plainest, and what is in space.
    EXPECT_EQ(centers("Area,X,Y,Z,XM,YM,ZM\n9,1,2,3,7,7,7\n9,4,5,6,7,7,7\n"), two_centers);
    EXPECT_EQ(centers("AreaShape_Center_X,AreaShape_Center_Y,AreaShape_Center_Z,Location_Center_X,Location_Center_Y,"
                      "Location_Center_Z\n7,7,7,1,2,3\n7,7,7,4,5,6\n"),
              two_centers);
    EXPECT_EQ(centers("x,y,Position X,Position Y,Position Z\n7,7,1,2,3\n7,7,4,5,6\n"), two_centers);
    EXPECT_EQ(centers("x [px],y [px],z [px],x [nm],y [nm],z [nm]\n1,2,3,7,7,7\n4,5,6,7,7,7\n"), two_centers);
    EXPECT_EQ(centers(",0,1,2\n0,1,2,3\n1,4,5,6\n"), two_centers);               // pandas.DataFrame(array)
    EXPECT_EQ(centers("X,Y,Z,x,y,z\n7,7,7,1,2,3\n7,7,7,4,5,6\n"), two_centers);  // to the letter
    EXPECT_EQ(centers("x,y,z,X\n1,2,3,7\n4,5,6,7\n"), two_centers);
    EXPECT_EQ(centers("centroid-1,centroid-2,centroid-3\n1,2,3\n4,5,6\n"), two_centers);
    EXPECT_THROW(centers("X,Y,Z,x\n1,2,3,7\n"), InputError);
    EXPECT_THROW(centers("x,y,z,x\n1,2,3,7\n"), InputError);
}

TEST(CsvColumns, ThatArePassedOverAreNamed) {
    const SphereData data = table("x [nm],y [nm],z [nm],intensity [photon]\n1,2,3,99\n4,5,6,98\n");
    EXPECT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.notes, passed_over("'intensity [photon]'"));
    EXPECT_EQ(table("x,y,z\n1,2,3\n").notes, Lines{});
    EXPECT_EQ(table("x,y,z,b,r\n1,2,3,4,5\n").notes, passed_over("'b', 'r'"));
    EXPECT_EQ(table("x,y,z,b,r\n1,2,3,4,5\n", {.properties = {"B"}}).notes, passed_over("'r'"));
    EXPECT_EQ(table("x,y,z,b\n1,2,3,4\n", {.properties = {"b"}}).notes, Lines{});
    EXPECT_EQ(table("x,y,z,a\x1B[31m\n1,2,3,4\n").notes, passed_over("'a\\x1b[31m'"));
}

TEST(CsvColumns, ThatAreEmptyAreNotOffered) {
    const std::string head = "x,y,z,a,empty\n1,2,3,4,\n4,5,6,5,nan\n";
    const SphereData data = table(head, {.all_properties = true});
    EXPECT_EQ(data.notes, Lines{});
    EXPECT_EQ(table(head).notes, passed_over("'a'"));
    EXPECT_EQ(table(head).property_names, Lines{"a"});
    EXPECT_EQ(data.property_names, Lines{"a"});
    // A value may come late.
    std::string many = "x,y,z,late,empty\n";
    for (int i = 0; i < 30000; ++i) many += std::to_string(i) + ",0,0,,\n";
    EXPECT_EQ(table(many).property_names, Lines{});
    many += "0,1,0,7,\n";
    EXPECT_EQ(table(many).property_names, Lines{"late"});
    EXPECT_EQ(table(many + "0,1,0,\"7\",\n").property_names, Lines{"late"});
}

TEST(CsvColumns, MayBeChosen) {
    const std::string text = "a,b,c,d [nm],x,y,z\n1,2,3,0.5,7,7,7\n4,5,6,0.25,7,7,7\n";
    for (const char* choices : {"x=a,y=b,z=c,radius=d", "x=1,y=2,z=3,radius=4", "X=A, Y = b,z=3,radius=d [nm]"}) {
        const std::vector<Sphere> read = spheres(text, with_columns(choices));
        ASSERT_EQ(read.size(), 2U) << choices;
        EXPECT_EQ(read[1].center, two_centers[1]) << choices;
        EXPECT_EQ(read[1].radius, 0.25) << choices;
    }
    EXPECT_EQ(spheres("x,y,z,size\n1,2,3,4\n", with_columns("diameter=size"))[0].radius, 2.0);
    EXPECT_EQ(spheres("1 2 3 4\n5 6 7 8\n", with_columns("x=1,y=2,z=3,radius=4"))[1].radius, 8.0);
    EXPECT_EQ(centers("lon,lat,depth\n1,2,3\n4,5,6\n", with_columns("x=lon,y=lat,z=depth")), two_centers);
    EXPECT_EQ(centers("lon,lat,depth\n1,2,3\n4,5,6\n", with_columns("x=1,y=2,z=3")), two_centers);
    EXPECT_EQ(message_of<InputError>([&] { spheres(text, with_columns("x=q")); }),
              "a.csv:1:1: found no column 'q', expected a header with the columns of --columns");
    for (const char* table : {"Xpos,Ypos,Zpos\n1,2,3\n", "Xpos;Ypos;Zpos\n1;2;3\n"}) {
        EXPECT_EQ(message_of<InputError>([&] { spheres(table, with_columns("x=Xpos,y=Ypos,z=Zpo")); }),
                  "a.csv:1:1: found no column 'Zpo', expected a header with the columns of --columns; did you mean 'Zpos'?");
    }
    EXPECT_EQ(message_of<InputError>([&] { spheres("a,b,c\n1,2,3\n", with_columns("x=a")); }),
              "a.csv:1:1: found no columns for both x and y, expected --columns x=NAME,y=NAME,z=NAME to name them");

    EXPECT_EQ(parse_column_choices("x=a, b,y=c=d"), (std::vector<ColumnChoice>{{"x", "a, b"}, {"y", "c=d"}}));
    for (const char* wrong : {"", "x", "x=", "=a", "w=a", "x=a,x=b", "a,x=b", ","})
        EXPECT_FALSE(parse_column_choices(wrong)) << wrong;
}

TEST(CsvUnits, OfRadiiBecomeThoseOfPlaces) {
    struct Case {
        const char* text;
        double radius;
        const char* said;
    };
    for (const Case& is : std::vector<Case>{
             {"x,y,z,diameter,v\nmm,mm,mm,um,m/s\n1,2,3,200,1\n", 0.1,
              "diameter is in um and the places in mm: the radii are converted to mm"},
             {"X (mm);Y (mm);Z (mm);Durchmesser (\xC2\xB5m)\n1,5;2;3;100\n", 0.05,
              "diameter is in \xC2\xB5m and the places in mm: the radii are converted to mm"},
             {"x_nm,y_nm,z_nm,radius_pm\n1,2,3,70\n", 0.07, "radius is in pm and the places in nm: the radii are converted to nm"},
             {"x [\xC3\x85],y [\xC3\x85],z [\xC3\x85],radius [nm]\n1,2,3,0.7\n", 7.0,
              "radius is in nm and the places in \xC3\x85: the radii are converted to \xC3\x85"},
             {"x,y,z,radius\nAngstrom,Angstrom,Angstrom,km\n1,2,3,2\n", 2e13,
              "radius is in km and the places in Angstrom: the radii are converted to Angstrom"},
             {"# x [m] y [m] z [m] radius [cm]\n1 2 3 5\n", 0.05,
              "radius is in cm and the places in m: the radii are converted to m"},
             // Units that differ, and of which one is no known length.
             {"x (um),y (um),z (um),radius (px)\n1,2,3,4\n", 4.0,
              "radius is in px and the places in um: all numbers are taken as they are"},
             {"x,y,z,radius\nmm,mm,mm,furlong\n1,2,3,4\n", 4.0,
              "radius is in furlong and the places in mm: all numbers are taken as they are"},
             {"x [Mm],y [Mm],z [Mm],radius [mm]\n1,2,3,4\n", 4.0,
              "radius is in mm and the places in Mm: all numbers are taken as they are"},
             {"x (mm),y (mm),z (um),radius (mm)\n1,2,3,4\n", 4.0, "x is in mm and z in um: all numbers are taken as they are"},
             // Nothing to convert.
             {"x (um),y (um),z (um),radius (\xCE\xBCm)\n1,2,3,4\n", 4.0, nullptr},
             {"x (px),y (px),z (px),radius (PX)\n1,2,3,4\n", 4.0, nullptr},
             {"x (mm),y (mm),z (mm),radius (mean)\n1,2,3,4\n", 4.0, nullptr},
             {"x,y,z,radius [um]\n1,2,3,4\n", 4.0, nullptr},
             {"x,y,z,radius\nmm,mm,mm,-\n1,2,3,4\n", 4.0, nullptr},
         }) {
        const SphereData data = table(is.text);
        ASSERT_EQ(data.scene.spheres.size(), 1U) << is.text;
        EXPECT_EQ(data.scene.spheres[0].radius, is.radius) << is.text;
        EXPECT_EQ(data.warnings, is.said == nullptr ? Lines{} : Lines{std::string("a.csv: ") + is.said}) << is.text;
    }
    // A radius beyond a double's range is none.
    const SphereData large = table("x [pm],y [pm],z [pm],radius [km]\n1,2,3,1e300\n1,2,3,1\n");
    EXPECT_EQ(large.scene.spheres[0].radius, 1.0);
    EXPECT_EQ(large.scene.spheres[1].radius, 1e15);
    EXPECT_EQ(large.warnings.size(), 2U);
}

TEST(CsvColumns, WithoutAHeaderAreCalledAsTheirProperties) {
    const std::string bare = "1,2,3,0.5\n4,5,6,0.25\n";
    EXPECT_EQ(table(bare).notes, passed_over("'column4'"));
    EXPECT_EQ(table(bare).property_names, Lines{"column4"});
    const SphereData chosen = table(bare, with_columns("x=1,y=2,z=3"));
    EXPECT_EQ(chosen.notes, passed_over("'column4'"));
    EXPECT_EQ(chosen.property_names, Lines{"column4"});
    EXPECT_EQ(table("x,y,z,a,a\n1,2,3,4,5\n").notes, passed_over("'a', 'a 2'"));
}

TEST(CsvColumns, ChosenByNumbersLeaveTheRestToTheRows) {
    const std::string bare = "1,2,3,0.5\n4,5,6,0.25\n";
    const SphereData data = table(bare, with_columns("radius=4"));
    EXPECT_EQ(centers_of(data.scene), two_centers);
    EXPECT_EQ(data.scene.spheres[1].radius, 0.25);
    EXPECT_EQ(data.warnings, Lines{"a.csv: no header: the first columns are taken for x, y and z"});
    EXPECT_EQ(centers("1,2,9,3\n4,5,9,6\n", with_columns("z=4")), two_centers);
    EXPECT_EQ(spheres("1,2,3,40,50,60\n", with_columns("diameter=4"))[0].color, (Color{255, 255, 255}));
    EXPECT_EQ(spheres("1,2,3,8,40,50,60\n", with_columns("radius=4,r=5,g=6,b=7"))[0].color, (Color{40, 50, 60}));
    EXPECT_EQ(spheres("C,1,2,3,8\n", with_columns("radius=5"))[0].radius, 8.0);
    for (const char* choices : {"radius=5", "radius=size", "x=2,radius=4"}) {
        EXPECT_THROW(table(bare, with_columns(choices)), InputError) << choices;
    }
    // Names that nobody knows are no reason to guess.
    EXPECT_THROW(table("a,b,c,d\n" + bare, with_columns("radius=4")), InputError);
}

}  // namespace sphereview

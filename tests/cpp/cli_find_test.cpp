// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of points, and files as spreadsheets and databases write them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

class CliFind : public test::Cli {
 protected:
  const std::string circles_ = write("circles.csv", "id,x,y,r\nA,0,0,1\nB,10,0,2\nC,0,10,0\n");
  const std::string points_ = write("points.csv", "name,x,y\nleft,-3,0\n\"right, far\",20,0\nup,0,8\n");
};

TEST_F(CliFind, NamesTheNearestCircleOfEachPoint) {
  const std::string expected =
      "x,y,circle,circle_id,distance,name\n-3,0,0,A,2,left\n20,0,1,B,8,\"right, far\"\n0,8,2,C,2,up\n";
  EXPECT_EQ(textOf("find " + circles_ + " --at " + points_), expected);
  const std::string diagram = path("diagram.json");
  textOf("compute " + circles_ + " -o " + diagram);
  EXPECT_EQ(textOf("find " + diagram + " --at -", readFile(points_)), expected);
  EXPECT_EQ(textOf("find " + write("plain.csv", "0,0,1\n10,0,2\n") + " --at " + write("p.json", "[[4.75,0]]")),
            "x,y,circle,distance\n4.75,0,1,3.25\n");
  EXPECT_EQ(textOf("find " + write("plain.csv", "0,0,1\n10,0,2\n") + " --metric centers --at " +
                   write("p.json", "[[4.75,0]]")),
            "x,y,circle,distance\n4.75,0,0,4.75\n");
  EXPECT_EQ(textOf("find " + write("none.csv", "x,y,r\n") + " --at " + write("p.json", "[[4,0]]")),
            "x,y,circle,distance\n4,0,,\n");
}

TEST_F(CliFind, TakesPlacesOnTheEarth) {
  const std::string cities = write("cities.csv", "name,lon,lat\nBern,7.45,46.95\nBasel,7.6,47.55\n");
  const std::string place = write("place.geojson", R"({"type":"Point","coordinates":[7.6,47]})");
  const std::string local = textOf("find " + cities + " --points --project local --at " + place);
  EXPECT_TRUE(local.starts_with("x,y,circle,distance\n7.6,47,0,126")) << "meters: " << local;
  const std::string sphere = textOf("find " + cities + " --points --sphere --at " + place);
  EXPECT_TRUE(sphere.starts_with("x,y,circle,distance\n7.6,47,0,12.6")) << "kilometers: " << sphere;
}

TEST_F(CliFind, RefusesWhatItCannotUse) {
  expectFailure(run("find - --at -"), 2, "The circles and the points cannot both be standard input.");
  expectFailure(run("find " + circles_ + " --at " + points_ + " --unit m"), 2, "--unit needs --sphere.");
  const std::string periodic = path("periodic.json");
  textOf("compute " + circles_ + " --lattice 20,0,0,20 -o " + periodic);
  expectFailure(run("find " + periodic + " --at " + points_), 2, "find takes no diagram of compute --lattice.");
  const std::string diagram = path("diagram.json");
  textOf("compute " + circles_ + " -o " + diagram);
  expectFailure(run("find " + diagram + " --metric power --at " + points_), 2,
                diagram + ": --metric is for circles alone; the file holds a diagram.");
  expectFailure(run("find " + circles_ + " --at " + points_ + " -o " + points_), 2,
                points_ + " would be overwritten: it is the output as well.");
}

class CliTables : public test::Cli {};

TEST_F(CliTables, OfCellsHaveInfiniteAreasUnlessSomethingClipsThem) {
  const std::string circles =
      write("circles.csv", "name,x,y,r\na,0,0,0\nb,4,0,0\nc,-4,0,0\nd,0,4,0\ne,0,-4,0\nf,0,0,0\n");
  EXPECT_EQ(textOf("compute " + circles + " --format cells"),
            "circle,x,y,r,area,perimeter,neighbors,hiddenBy,name\n"
            "0,0,0,0,16,16,1 3 2 4,,a\n1,4,0,0,inf,inf,4 3 0,,b\n2,-4,0,0,inf,inf,3 4 0,,c\n"
            "3,0,4,0,inf,inf,2 0 1,,d\n4,0,-4,0,inf,inf,1 0 2,,e\n5,0,0,0,0,0,,0,f\n");
  EXPECT_EQ(textOf("compute " + circles + " --format cells --bounds=-2,-1,6,1"),
            "circle,x,y,r,area,perimeter,neighbors,hiddenBy,name\n"
            "0,0,0,0,8,12,1,,a\n1,4,0,0,8,12,0,,b\n2,-4,0,0,0,0,,,c\n3,0,4,0,0,0,,,d\n4,0,-4,0,0,0,,,e\n"
            "5,0,0,0,0,0,,0,f\n");
  expectFailure(run("compute " + circles + " --format cells --tolerance 1"), 2,
                "--tolerance is not for --format cells: areas are exact.");
}

TEST_F(CliTables, OfExcelAndDatabasesAreRead) {
  EXPECT_EQ(textOf("convert - --format csv", "sep=;\r\nname;x;y;r\r\n\"a\";1,5;2;3\r\n"), "x,y,r,name\n1.5,2,3,a\n");
  expectFailure(run("convert -", std::string("\xFF\xFEx\0,\0", 6)), 2,
                "standard input:1: the text is UTF-16; save it as UTF-8.");
  expectFailure(run("convert -", "x,y,r,name\n1,2,3,Z\xFCrich\n"), 2,
                "standard input:2: the text is not UTF-8, perhaps Windows-1252; save it as UTF-8.");
  expectFailure(run("convert -", "[{\"x\":1,\"y\":2,\"r\":3,\"name\":\"Z\xFCrich\"}]"), 2,
                "standard input:1: bad JSON: a string is not UTF-8, perhaps Windows-1252; save it as UTF-8.");
  EXPECT_EQ(textOf("convert - --points --format csv", "name,wkt\nA,POINT (3 4)\nB,\"MULTIPOINT Z (6 9 1, 7 8 2)\"\n"),
            "x,y,r,z,name\n3,4,0,,A\n6,9,0,1,B\n7,8,0,2,B\n");
  EXPECT_EQ(textOf("convert - --points --format csv", "POINT (3 4)\nPOINT (6 9)\n"), "x,y,r\n3,4,0\n6,9,0\n");
  expectFailure(
      run("convert -", "name,wkt\nA,POINT (3 4)\n"), 2,
      "standard input:1: no column is called r, rad or radius, only name, wkt; make all radii 0 by --points.");
  EXPECT_EQ(textOf("convert - --points --skip-invalid --format csv", "wkt,n\nPOINT (3 4),1\nPOINT EMPTY,2\n",
                   "circle-voronoi: 1 of 2 was skipped; the first: standard input:3: wkt is no POINT or MULTIPOINT: "
                   "\"POINT EMPTY\".\n"),
            "x,y,r,n\n3,4,0,1\n");
}

TEST_F(CliTables, OfGeoJsonAreReadAlsoALineEach) {
  const std::string feature = R"({"type":"Feature","properties":{"name":"A"},"geometry":)";
  EXPECT_EQ(textOf("convert - --points --format csv",
                   feature + R"({"type":"MultiPoint","coordinates":[[3,4,5],[6,9]]},"id":7})" + "\n" + feature +
                       R"({"type":"Point","coordinates":[1,2]}})" + "\n"),
            "x,y,r,id,z,name\n3,4,0,7,5,A\n6,9,0,7,,A\n1,2,0,,,A\n");
  EXPECT_EQ(textOf("convert - --points --format csv", R"({"type":"MultiPoint","coordinates":[[3,4],[6,9]]})"),
            "x,y,r\n3,4,0\n6,9,0\n");
  expectFailure(run("convert -", feature + R"({"type":"Point","coordinates":[1,2]}})"), 2,
                "standard input:1: feature 0 has no number as its property r, rad or radius; make all radii 0 by "
                "--points.");
  const std::string region = write("region.geojsonl", R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]})"
                                                      "\n"
                                                      R"({"type":"Polygon","coordinates":[[[2,0],[4,0],[4,2]]]})");
  const std::string parts = write("region.wkt", "MULTIPOLYGON (EMPTY, ((0 0, 1 0, 1 1), EMPTY), ((2 0, 4 0, 4 2)))");
  const std::string collection = write("collection.wkt",
                                       "SRID=4326;GEOMETRYCOLLECTION (POLYGON EMPTY, POLYGON ((0 0, 1 0, 1 1)), "
                                       "MULTIPOLYGON (((2 0, 4 0, 4 2))))");
  for (const std::string& file : {region, parts, collection}) {
    EXPECT_EQ(textOf("compute - --format cells --region " + file, "0,0,0\n"),
              "circle,x,y,r,area,perimeter,neighbors,hiddenBy\n0,0,0,0,2.5,10.242640687119286,,\n");
  }
}

class CliCrs : public test::Cli {
 protected:
  const std::string circles_ = write("circles.csv", "0,0,1\n6,0,1\n0,8,1\n");

  static std::string nameIn(const std::string& text) {
    const Json json = Json::parse(text);
    return json.contains("crs") ? json["crs"]["properties"]["name"].get<std::string>() : "";
  }
};

TEST_F(CliCrs, IsNamedByGeoJsonUnlessItIsTheDefault) {
  const std::string utm = "urn:ogc:def:crs:EPSG::25832";
  for (const std::string command : {"compute", "convert"}) {
    const std::string run = command + " " + circles_ + " --format geojson --crs ";
    EXPECT_EQ(nameIn(textOf(run + "epsg:25832")), utm);
    EXPECT_EQ(nameIn(textOf(run + utm)), utm);
  }
  EXPECT_EQ(nameIn(textOf("convert " + circles_ + " --format geojson --crs OGC:CRS84")), "");
  const std::string diagram = path("diagram.json");
  textOf("compute " + circles_ + " --crs EPSG:25832 -o " + diagram);
  EXPECT_EQ(nameIn(textOf("convert " + diagram + " --format geojson")), utm);
}

TEST_F(CliCrs, IsTakenFromTheInput) {
  const std::string rows = write("ewkt.csv", "r;geom\n1;\"SRID=25832;POINT (0 0)\"\n1;\"SRID=25832;POINT (6 0)\"\n");
  EXPECT_EQ(nameIn(textOf("compute " + rows + " --format geojson")), "urn:ogc:def:crs:EPSG::25832");
  const std::string geojson = path("utm.geojson");
  textOf("convert " + rows + " -o " + geojson);
  EXPECT_EQ(nameIn(textOf("compute " + geojson + " --format geojson")), "urn:ogc:def:crs:EPSG::25832");
  EXPECT_EQ(nameIn(textOf("compute " + geojson + " --crs EPSG:3035 --format geojson")), "urn:ogc:def:crs:EPSG::3035");
  EXPECT_EQ(nameIn(textOf("convert " + geojson + " --crs EPSG:4326 --format geojson")), "");
}

TEST_F(CliCrs, IsRefusedWhereItHasNoMeaning) {
  expectFailure(run("compute " + circles_ + " --crs UTM --format geojson"), 2,
                "--crs must be like EPSG:25832, or a URN (got \"UTM\").");
  expectFailure(run("compute " + circles_ + " --crs EPSG:25832 --format svg"), 2,
                "--crs needs --format geojson or json.");
  expectFailure(run("compute " + circles_ + " --crs EPSG:25832 --project local"), 2,
                "--project takes no --crs: centers are longitude and latitude.");
  // The cells are in degrees again: the line has no member to lose.
  const std::string degrees = write("degrees.csv", "lon,lat,radius\n149.149,-35.315,500\n149.3,-35.5,800\n");
  textOf("compute " + degrees + " --project local --format geojsonl");
}

}  // namespace
}  // namespace circle_voronoi

#include "sylph_core/grid/map_file.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "sylph_core/grid/generators.hpp"
#include "test/support/temporary_folder.hpp"

namespace sylph {
namespace {

const char kMap[] = "type octile\nheight 2\nwidth 3\nmap\n.G@\nSTW\n";
const char kMapServer[] =
    "image: map.pgm\nresolution: 0.25\norigin: [1.0, -2.0, 0.0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(std::string::npos, position) << from;
  return text.replace(position, from.size(), to);
}

TEST(MapFileTest, ReadsTheTerrainsOfMovingAiMaps) {
  const TemporaryFolder folder;
  EXPECT_EQ(Grid::fromText("..#\n.##\n"), loadMap(folder.write("a.map", kMap)));
  EXPECT_FALSE(loadMapFile(folder.path("a.map")).cell_size_m.has_value());
}

TEST(MapFileTest, ReadsLinesThatEndAsInWindows) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("a.map", "type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.@\r\n");
  EXPECT_EQ(Grid::fromText(".#\n"), loadMap(path));
}

TEST(MapFileProperty, ThereAndBackIsTheIdentity) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const int rows = 1 + static_cast<int>(drawIndex(rng, 30));
    const int cols = 1 + static_cast<int>(drawIndex(rng, 30));
    const Grid grid = randomMap({rows, cols, 0.3}, rng);
    saveMap(grid, folder.path("a.map"));
    EXPECT_EQ(grid, loadMap(folder.path("a.map")));
  }
}

TEST(MapFileTest, NamesTheLineOfWhatIsWrong) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& error, const std::string& content) {
    expectError("/a.map" + error, [&] { loadMap(folder.write("a.map", content)); });
  };
  const std::string map = kMap;
  expect(": is empty, must start with 'type octile'", "");
  expect(":1: 'type tile': must be 'type octile'", replaced(map, "octile", "tile"));
  expect(":1: '?PNG': must be 'type octile'", "\x89PNG\r\n");
  expect(":2: ends within its header: type, height, width, map", "type octile\nheight 2\n");
  expect(":2: 'hight 2': must be 'height N'", replaced(map, "height", "hight"));
  expect(":2: height 'two': must be a whole number 1 ... 8192", replaced(map, "2", "two"));
  expect(":2: height '0': must be a whole number 1 ... 8192", replaced(map, "2", "0"));
  expect(":3: width '9999': must be a whole number 1 ... 8192", replaced(map, "3", "9999"));
  expect(":3: width '99999999999': must be a whole number 1 ... 8192",
         replaced(map, "3", "99999999999"));
  expect(":4: 'mop': must be 'map'", replaced(map, "map", "mop"));
  expect(":5: 1 rows: height says 2", replaced(map, "STW\n", ""));
  expect(":7: 3 rows: height says 2", map + "...\n");
  expect(":6: 2 characters: width says 3", replaced(map, "STW", "ST"));
  expect(":5: 4 characters: width says 3", replaced(map, ".G@", ".G@@"));
  expect(":6: '#': must be one of . G S (free) and @ O T W (obstacle)",
         replaced(map, "STW", "ST#"));
}

TEST(MapFileTest, RefusesFilesThatAreNotMaps) {
  const TemporaryFolder folder;
  expectError("/none.map: there is no such file", [&] { loadMap(folder.path("none.map")); });
  expectError("/: a map's name must end in .map (MovingAI), .yaml or .yml (map_server)",
              [&] { loadMap(folder.path("")); });
  folder.write("folder", "");
  std::filesystem::create_directory(folder.path("folder.map"));
  expectError("/folder.map: is not a regular file", [&] { loadMap(folder.path("folder.map")); });
  const std::string huge = folder.write("huge.map", "");
  std::filesystem::resize_file(huge, std::uintmax_t{1} << 30);  // sparse: takes no disk space
  expectError("/huge.map: is larger than 67126272 bytes", [&] { loadMap(huge); });
}

TEST(MapServerFileTest, TheFirstImageRowIsRowZero) {
  const TemporaryFolder folder;
  folder.write("map.pgm", std::string("P5\n# a comment\n3 2\n255\n") +
                              std::string("\xFE\x00\xFE\xFE\xFE\xCD", 6));  // CD: unknown
  const MapFile map = loadMapFile(folder.write("map.yaml", kMapServer));
  EXPECT_EQ(Grid::fromText(".#.\n..#\n"), map.grid);
  EXPECT_DOUBLE_EQ(0.25, map.cell_size_m.value_or(0.0));
  EXPECT_DOUBLE_EQ(1.0, map.origin_x_m);
  EXPECT_DOUBLE_EQ(-2.0, map.origin_y_m);
}

TEST(MapServerFileTest, NegatedImagesAreBrightWhereOccupied) {
  const TemporaryFolder folder;
  folder.write("map.pgm", std::string("P5 2 1 255\n\xFF\x00", 13));
  const std::string yaml = replaced(kMapServer, "negate: 0", "negate: 1");
  EXPECT_EQ(Grid::fromText("#.\n"), loadMap(folder.write("map.yaml", yaml)));
}

TEST(MapServerFileTest, ReadsAllOfTheNetpbmFamily) {
  const TemporaryFolder folder;
  const std::string yaml = folder.write("map.yaml", kMapServer);
  const auto expect = [&](const std::string& grid, const std::string& image) {
    folder.write("map.pgm", image);
    EXPECT_EQ(Grid::fromText(grid), loadMap(yaml)) << image.substr(0, 20);
  };
  const auto bytes = [](std::initializer_list<int> values) {
    return std::string(values.begin(), values.end());
  };
  expect(".#.\n##.\n", "P1\n# one is black\n3 2\n0 1 0\n1 1 0\n");
  expect(".#.\n##.\n", "P1 3 2 010110");
  expect(".#.\n##.\n", "P4 3 2\n" + bytes({0x40, 0xC0}));
  expect(".#\n#.\n", "P2\n2 2\n255\n254 0\n205 255\n");
  expect(".##\n", "P2 3 1 100 100 0 50");  // nothing behind the last digit
  expect(".##\n", "P5 3 1 100\n" + bytes({100, 0, 50}));
  expect(".##\n", "P5 3 1 65535\n" + bytes({0xFF, 0xFF, 0, 0, 0x80, 0}));
  expect(".##\n", "P2 3 1 65535 65535 0 32768");
  expect(".#\n", "P3 2 1 255 255 255 240 0 0 0");
  expect(".#\n", "P6 2 1 255\n" + bytes({255, 255, 240, 0, 0, 0}));
}

TEST(MapServerFileTest, TakesNegateAsANumberOrAWord) {
  const TemporaryFolder folder;
  folder.write("map.pgm", std::string("P5 2 1 255\n\xFF\x00", 13));
  for (const auto& [word, grid] : {std::pair<std::string, std::string>{"0", ".#\n"},
                                   {"false", ".#\n"},
                                   {"1", "#.\n"},
                                   {"true", "#.\n"}}) {
    const std::string yaml = replaced(kMapServer, "negate: 0", "negate: " + word);
    EXPECT_EQ(Grid::fromText(grid), loadMap(folder.write("map.yaml", yaml))) << word;
  }
}

TEST(MapServerFileTest, ReadsOccupancyFromAScaleOrRaw) {
  const TemporaryFolder folder;
  folder.write("map.pgm", "P2 5 1 255  0 19 20 100 255");
  const auto gridOf = [&](const std::string& mode, const std::string& negate) {
    return loadMap(folder.write(
        "map.yaml", replaced(kMapServer, "negate: 0", "negate: " + negate) + "mode: " + mode));
  };
  EXPECT_EQ(Grid::fromText("####.\n"), gridOf("scale", "0"));
  EXPECT_EQ(Grid::fromText("...##\n"), gridOf("scale", "1"));
  // In percent; 255 is unknown.
  EXPECT_EQ(Grid::fromText("..###\n"), gridOf("raw", "0"));
  EXPECT_EQ(Grid::fromText("####.\n"), gridOf("raw", "1"));
}

TEST(MapServerFileTest, ReadsPng) {
  const TemporaryFolder folder;
  const std::string yaml = folder.write("map.yaml", replaced(kMapServer, "map.pgm", "map.png"));
  const auto gridOf = [&](const cv::Mat& image) {
    EXPECT_TRUE(cv::imwrite(folder.path("map.png"), image));
    return loadMap(yaml);
  };
  EXPECT_EQ(Grid::fromText(".#\n..\n"),
            gridOf((cv::Mat_<unsigned char>(2, 2) << 255, 0, 255, 255)));
  EXPECT_EQ(Grid::fromText(".##\n"),
            gridOf((cv::Mat_<unsigned short>(1, 3) << 65535, 0, 52685)));  // the last is unknown
  // Colour, and what is not opaque.
  using Pixel = cv::Vec4b;
  EXPECT_EQ(Grid::fromText(".#.#\n"),
            gridOf((cv::Mat_<Pixel>(1, 4) << Pixel(255, 255, 255, 255), Pixel(0, 0, 0, 255),
                    Pixel(240, 250, 255, 255), Pixel(255, 255, 255, 254))));
}

TEST(MapServerFileTest, NamesTheFieldThatIsWrong) {
  const TemporaryFolder folder;
  folder.write("map.pgm", std::string("P5 2 1 255\n\xFF\x00", 13));
  const auto expect = [&](const std::string& error, const std::string& from,
                          const std::string& to) {
    const std::string yaml = replaced(kMapServer, from, to);
    expectError("/map.yaml" + error, [&] { loadMap(folder.write("map.yaml", yaml)); });
  };
  expect(":1: image: is missing", "image: map.pgm\n", "");
  expect(
      ":4: negative: unknown key, must be one of mode, negate, occupied_thresh, free_thresh, "
      "origin, resolution, image",
      "negate", "negative");
  expect(":2: image: given twice, must be given once", "resolution", "image: b.pgm\nresolution");
  expect(":1: image: is a list, must be a text", "map.pgm", "[map.pgm]");
  expect(":2: resolution: is '0', must be a number > 0", "0.25", "0");
  expect(":2: resolution: is '.nan', must be a number > 0", "0.25", ".nan");
  expect(":2: resolution: is 'fine', must be a number > 0", "0.25", "fine");
  expect(":3: origin: has 2 values, must be a list of 3 numbers", ", 0.0]", "]");
  expect(":3: origin: is '.inf', must be a number finite", "1.0", ".inf");
  expect(":4: negate: is '2', must be one of 0, 1, false, true", "negate: 0", "negate: 2");
  expect(":7: mode: is 'costmap', must be one of trinary, scale, raw", "free_thresh: 0.196\n",
         "free_thresh: 0.196\nmode: costmap\n");
  expect(":5: occupied_thresh: is '65', must be a number 0 ... 1", "0.65", "65");
  expect(":6: free_thresh: is above occupied_thresh, must be at most that", "0.196", "0.7");
  expect(":3: origin: is '1.0', must be a list", "[1.0, -2.0, 0.0]", "1.0");
}

TEST(MapServerFileTest, RefusesWhatIsNotAMapping) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& error, const std::string& content) {
    expectError("/map.yaml" + error, [&] { loadMap(folder.write("map.yaml", content)); });
  };
  expect(": is empty, must be a YAML mapping", "");
  expect(": is empty, must be a YAML mapping", "# nothing but a comment\n");
  expect(": must be one YAML mapping of 'key: value' lines", "- a\n- b\n");
  expect(":1: is not YAML: end of sequence flow not found", "origin: [1, 2");
  expect(": is larger than 1048576 bytes", std::string(2'000'000, '#'));
}

TEST(MapServerFileTest, RefusesImagesThatAreTruncatedOversizedOrOfAnotherKind) {
  const TemporaryFolder folder;
  const std::string yaml = folder.write("map.yaml", kMapServer);
  const auto expect = [&](const std::string& error, const std::string& content) {
    folder.write("map.pgm", content);
    expectError("/map.pgm: " + error, [&] { loadMap(yaml); });
  };
  expectError("/map.pgm: there is no such file", [&] { loadMap(yaml); });
  for (const std::string content : {"", "GIF89a", "P7 1 1 255\n1", "P0"}) {
    expect("is not an image of a known kind, must be PNG, PGM, PBM or PPM (P1 ... P6)", content);
  }
  for (const std::string content :
       {"P5 3 2 255\n12345", "P5 3 2 65535\n12345678901", "P6 3 2 255\n12345678901234567",
        "P4 9 2\n123", "P1 3 2\n01011", "P2 3 2 255\n1 1 1 1 1"}) {
    expect("image is truncated", content);
  }
  expect("image is truncated or damaged", "P2 3 2 255\n255 255 255 ");
  expect("image is truncated or damaged", "P2 2 1 255\nwhite black");
  for (const std::string header :
       {"P5 ", "P5 3 2", "P5 3 x 255\n", "P5 3 -2 255\n", "P5 3 2 65536\n", "P5 3 2 0\n"}) {
    expect("header of the image must be 'P5 WIDTH HEIGHT WHITE', WHITE 1 ... 65535",
           header + "123456");
  }
  expect("header of the image must be 'P4 WIDTH HEIGHT'", "P4 3 x\n123456");
  expect("image of 0 x 2 pixels: each side must be 1 ... 8192", "P5 2 0 255\n");
  expect("image of 100000 x 100000 pixels: each side must be 1 ... 8192", "P5 100000 100000 255\n");
  std::vector<unsigned char> png;
  ASSERT_TRUE(cv::imencode(".png", cv::Mat::ones(40, 40, CV_8U), png));
  const std::string whole(png.begin(), png.end());
  for (const std::size_t length : {std::size_t{40}, whole.size() / 2, whole.size() - 1}) {
    expect("image is truncated", whole.substr(0, length));
  }
  expect("image of 0 x 0 pixels: each side must be 1 ... 8192", whole.substr(0, 10));
}

}  // namespace
}  // namespace sylph

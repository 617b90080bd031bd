#include "grid/map_server_file.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "files/text_file.hpp"
#include "sylph_core/files/yaml_map.hpp"

namespace sylph {
namespace {

constexpr std::size_t kMaxImageBytes = std::size_t{Grid::kMaxSide} * Grid::kMaxSide + 4096;

/// What an image's header claims. Looked at before the image is decoded, so that a wrong header
/// cannot claim all memory and a truncated file is told apart from a damaged one.
struct ImageHeader {
  long cols = 0;
  long rows = 0;
  bool is_complete = false;  ///< whether the file is as long as its header says
};

/// The next number of a PGM header, behind white space and comments ('#' to the end of the line);
/// -1 if something else stands there.
long pgmNumber(const std::string& bytes, std::size_t& position) {
  constexpr long kTooLarge = 1'000'000;
  const auto is_at = [&](const char* characters) {
    return position < bytes.size() && bytes[position] != '\0' &&
           std::strchr(characters, bytes[position]) != nullptr;
  };
  while (is_at(" \t\r\n#")) {
    position =
        is_at("#") ? std::min(bytes.find_first_of("\r\n", position), bytes.size()) : position + 1;
  }
  long number = is_at("0123456789") ? 0 : -1;
  for (; is_at("0123456789"); ++position) {
    number = std::min(kTooLarge, number * 10 + (bytes[position] - '0'));
  }
  return number;
}

ImageHeader readPgmHeader(const std::string& path, const std::string& bytes) {
  std::size_t position = 2;  // behind "P5"
  ImageHeader header;
  header.cols = pgmNumber(bytes, position);
  header.rows = pgmNumber(bytes, position);
  const long brightest = pgmNumber(bytes, position);
  if (header.cols < 0 || header.rows < 0 || brightest != 255) {
    throw fileError(path, 0, "header of the PGM image must be 'P5 WIDTH HEIGHT 255'");
  }
  const std::size_t pixels = position + 1;  // one white space ends the header
  const std::size_t size =
      static_cast<std::size_t>(header.cols) * static_cast<std::size_t>(header.rows);
  header.is_complete = bytes.size() >= pixels && bytes.size() - pixels >= size;
  return header;
}

/// Chunks of a PNG: length, name, content, checksum. The last one is named IEND.
ImageHeader readPngHeader(const std::string& bytes) {
  const auto big_endian = [&](std::size_t position) {
    std::size_t number = 0;
    for (std::size_t index = position; index < position + 4; ++index) {
      number = number * 256 + static_cast<unsigned char>(bytes[index]);
    }
    return number;
  };
  constexpr std::size_t kSignatureBytes = 8;
  constexpr std::size_t kChunkFrameBytes = 12;
  ImageHeader header;
  if (bytes.size() >= kSignatureBytes + 16) {
    header.cols = static_cast<long>(big_endian(kSignatureBytes + 8));
    header.rows = static_cast<long>(big_endian(kSignatureBytes + 12));
  }
  for (std::size_t chunk = kSignatureBytes; chunk + kChunkFrameBytes <= bytes.size();
       chunk += kChunkFrameBytes + big_endian(chunk)) {
    header.is_complete = bytes.compare(chunk + 4, 4, "IEND") == 0;
  }
  return header;
}

cv::Mat loadImage(const std::string& path) {
  const std::string bytes = readTextFile(path, kMaxImageBytes);
  const bool is_pgm = bytes.rfind("P5", 0) == 0;
  if (!is_pgm && bytes.rfind("\x89PNG\r\n\x1a\n", 0) != 0) {
    throw fileError(path, 0, "is not an image of a known kind, must be PGM (binary, P5) or PNG");
  }
  const ImageHeader header = is_pgm ? readPgmHeader(path, bytes) : readPngHeader(bytes);
  if (header.cols < 1 || header.cols > Grid::kMaxSide || header.rows < 1 ||
      header.rows > Grid::kMaxSide) {
    throw fileError(path, 0,
                    "image of " + std::to_string(header.rows) + " x " +
                        std::to_string(header.cols) + " pixels: each side must be 1 ... " +
                        std::to_string(Grid::kMaxSide));
  }
  if (!header.is_complete) {
    throw fileError(path, 0, "image is truncated");
  }
  cv::Mat image;
  try {
    image = cv::imdecode(std::vector<char>(bytes.begin(), bytes.end()), cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) {
    throw fileError(path, 0, "image is damaged");
  }
  return image;
}

}  // namespace

MapFile loadMapServerFile(const std::string& path) {
  const YamlMap yaml = YamlMap::load(path);
  yaml.word("mode", {"trinary"}, "trinary");
  const bool is_negated = yaml.integer("negate", 0, 0, 1) == 1;
  const double occupied_threshold = yaml.number("occupied_thresh", {0.0, 1.0});
  const double free_threshold = yaml.number("free_thresh", {0.0, 1.0});
  if (free_threshold > occupied_threshold) {
    throw yaml.error("free_thresh", "is above occupied_thresh, must be at most that");
  }
  const std::vector<double> origin = yaml.numbers("origin", 3, Range{});
  MapFile map;
  map.cell_size_m = yaml.number("resolution", Range::positive());
  map.origin_x_m = origin[0];
  map.origin_y_m = origin[1];
  map.origin_yaw_rad = origin[2];

  const std::string image_path = resolvePath(path, yaml.text("image"));
  yaml.refuseUnread();
  const cv::Mat image = loadImage(image_path);
  map.grid = Grid(image.rows, image.cols);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const int brightness = image.at<std::uint8_t>(row, col);
      const double occupancy = (is_negated ? brightness : 255 - brightness) / 255.0;
      map.grid.setObstacle({row, col}, occupancy >= free_threshold);
    }
  }
  return map;
}

}  // namespace sylph

#include "grid/map_server_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <vector>

#include "files/text_file.hpp"
#include "sylph_core/files/yaml_map.hpp"

namespace sylph {
namespace {

/// Of 16-bit colour, or of decimal digits.
constexpr std::size_t kMaxPixelBytes = 6;
constexpr std::size_t kMaxImageBytes =
    kMaxPixelBytes * std::size_t{Grid::kMaxSide} * Grid::kMaxSide + 4096;

/// What an image's header claims. Looked at before the image is decoded, so that a wrong header
/// cannot claim all memory and a truncated file is told apart from a damaged one.
struct ImageHeader {
  long cols = 0;
  long rows = 0;
  long brightest = 0;        ///< value of white if the header tells it
  std::size_t pixels = 0;    ///< where they begin, of the Netpbm family
  bool is_complete = false;  ///< whether the file is as long as its header says
};

/// The next number of a Netpbm header, behind white space and comments ('#' to the end of the
/// line); -1 if something else stands there.
long headerNumber(const std::string& bytes, std::size_t& position) {
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

/// 1 to 6 of an image of the Netpbm family: PBM, PGM, PPM in digits, then the same in bytes;
/// 0 of others. Format: netpbm.sourceforge.net/doc
int netpbmKind(const std::string& bytes) {
  const bool is_netpbm = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6';
  return is_netpbm ? bytes[1] - '0' : 0;
}

bool hasDigits(int kind) {
  return kind <= 3;
}

/// The fewest bytes that pixels can take.
std::size_t netpbmBytes(int kind, const ImageHeader& header) {
  const auto cols = static_cast<std::size_t>(header.cols);
  const auto rows = static_cast<std::size_t>(header.rows);
  const std::size_t values = cols * rows * (kind % 3 == 0 ? 3 : 1);
  if (kind == 4) {
    return rows * ((cols + 7) / 8);
  }
  if (hasDigits(kind)) {
    return kind == 1 || values == 0 ? values : 2 * values - 1;  // bits need no space in between
  }
  return values * (header.brightest > 255 ? 2 : 1);
}

ImageHeader readNetpbmHeader(const std::string& path, const std::string& bytes) {
  constexpr long kLargestWhite = 65535;
  const int kind = netpbmKind(bytes);
  const bool is_bitmap = kind % 3 == 1;
  std::size_t position = 2;
  ImageHeader header;
  header.cols = headerNumber(bytes, position);
  header.rows = headerNumber(bytes, position);
  header.brightest = is_bitmap ? 1 : headerNumber(bytes, position);
  if (header.cols < 0 || header.rows < 0 || header.brightest < 1 ||
      header.brightest > kLargestWhite) {
    throw fileError(
        path, 0,
        "header of the image must be 'P" + std::to_string(kind) + " WIDTH HEIGHT" +
            (is_bitmap ? "'" : " WHITE', WHITE 1 ... " + std::to_string(kLargestWhite)));
  }
  header.pixels = position + 1;  // one white space ends the header
  header.is_complete =
      bytes.size() >= header.pixels && bytes.size() - header.pixels >= netpbmBytes(kind, header);
  return header;
}

/// A value in digits; of a bitmap, each digit is one.
/// @throws std::runtime_error if something else stands there
long readDigits(const std::string& path, const std::string& bytes, int kind,
                std::size_t& position) {
  long value = 0;
  if (kind == 1) {
    position = std::min(bytes.find_first_of("01", position), bytes.size());
    value = position < bytes.size() ? bytes[position++] - '0' : -1;
  } else {
    value = headerNumber(bytes, position);
  }
  if (value < 0) {
    throw fileError(path, 0, "image is truncated or damaged");
  }
  return value;
}

/// Pixels of the Netpbm family. OpenCV's reader scales some kinds to 255 and others not, and needs
/// something behind the last digit.
cv::Mat readNetpbm(const std::string& path, const std::string& bytes, const ImageHeader& header) {
  const int kind = netpbmKind(bytes);
  const int channels = kind % 3 == 0 ? 3 : 1;
  const auto byteAt = [&](std::size_t index) { return static_cast<unsigned char>(bytes[index]); };
  cv::Mat image(static_cast<int>(header.rows), static_cast<int>(header.cols),
                CV_MAKETYPE(CV_16U, channels));
  std::size_t position = header.pixels;
  for (int row = 0; row < image.rows; ++row) {
    auto* const values = image.ptr<std::uint16_t>(row);
    const int count = image.cols * channels;
    for (int i = 0; i < count; ++i) {
      long value = 0;
      if (hasDigits(kind)) {
        value = readDigits(path, bytes, kind, position);
      } else if (kind == 4) {
        value = byteAt(position + static_cast<std::size_t>(i / 8)) >> (7 - i % 8) & 1;
      } else if (header.brightest > 255) {
        value = byteAt(position) * 256 + byteAt(position + 1);
        position += 2;
      } else {
        value = byteAt(position++);
      }
      const bool is_black_one = kind % 3 == 1;
      values[i] =
          static_cast<std::uint16_t>(is_black_one ? 1 - value : std::min(value, header.brightest));
    }
    position += kind == 4 ? static_cast<std::size_t>((image.cols + 7) / 8) : 0;
  }
  return image;
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

/// Pixels as they are stored, and the value of white.
struct Image {
  cv::Mat pixels;
  double brightest = 255.0;
};

Image loadImage(const std::string& path) {
  const std::string bytes = readTextFile(path, kMaxImageBytes);
  const int kind = netpbmKind(bytes);
  if (kind == 0 && bytes.rfind("\x89PNG\r\n\x1a\n", 0) != 0) {
    throw fileError(path, 0,
                    "is not an image of a known kind, must be PNG, PGM, PBM or PPM (P1 ... P6)");
  }
  const ImageHeader header = kind > 0 ? readNetpbmHeader(path, bytes) : readPngHeader(bytes);
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
  if (kind > 0) {
    return {readNetpbm(path, bytes, header), static_cast<double>(header.brightest)};
  }
  Image image;
  try {
    image.pixels =
        cv::imdecode(std::vector<char>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.pixels.release();
  }
  if (image.pixels.empty()) {
    throw fileError(path, 0, "image is damaged");
  }
  image.brightest = image.pixels.depth() == CV_16U ? 65535.0 : 255.0;
  return image;
}

/// Brightness of the pixels of a row, 0 black ... 1 white: the mean of their colours; nothing for
/// one that is not opaque.
std::vector<std::optional<double>> brightnessOf(const Image& image, int row) {
  cv::Mat values;
  image.pixels.row(row).convertTo(values, CV_64F);
  const int channels = image.pixels.channels();
  const int colours = channels == 4 ? 3 : channels;
  std::vector<std::optional<double>> brightness(static_cast<std::size_t>(image.pixels.cols));
  const auto* value = values.ptr<double>();
  for (std::optional<double>& pixel : brightness) {
    // As map_server does.
    const double sum = std::accumulate(value, value + colours, 0.0);
    if (channels == colours || value[colours] >= image.brightest) {
      pixel = std::min(1.0, sum / (colours * image.brightest));
    }
    value += channels;
  }
  return brightness;
}

/// What the meaning of pixels depends on.
struct Interpretation {
  bool is_raw = false;      ///< a pixel is the occupancy in percent; above 100: unknown
  bool is_negated = false;  ///< bright is occupied
  double free_threshold = 0.0;

  bool isFree(std::optional<double> brightness) const {
    if (!brightness) {
      return false;
    }
    const double seen = is_negated ? 1.0 - *brightness : *brightness;
    const double occupancy = is_raw ? std::round(seen * 255.0) / 100.0 : 1.0 - seen;
    return occupancy < free_threshold;
  }
};

Interpretation readInterpretation(const YamlMap& yaml) {
  Interpretation interpretation;
  // Of `scale`, what lies between free and occupied is no more free than the unknown of `trinary`.
  interpretation.is_raw = yaml.word("mode", {"trinary", "scale", "raw"}, "trinary") == "raw";
  const std::string negate = yaml.word("negate", {"0", "1", "false", "true"}, "0");
  interpretation.is_negated = negate == "1" || negate == "true";
  const double occupied_threshold = yaml.number("occupied_thresh", {0.0, 1.0});
  interpretation.free_threshold = yaml.number("free_thresh", {0.0, 1.0});
  if (interpretation.free_threshold > occupied_threshold) {
    throw yaml.error("free_thresh", "is above occupied_thresh, must be at most that");
  }
  return interpretation;
}

}  // namespace

MapFile loadMapServerFile(const std::string& path) {
  const YamlMap yaml = YamlMap::load(path);
  const Interpretation interpretation = readInterpretation(yaml);
  const std::vector<double> origin = yaml.numbers("origin", 3, Range{});
  MapFile map;
  map.cell_size_m = yaml.number("resolution", Range::positive());
  map.origin_x_m = origin[0];
  map.origin_y_m = origin[1];
  map.origin_yaw_rad = origin[2];

  const std::string image_path = resolvePath(path, yaml.text("image"));
  yaml.refuseUnread();
  const Image image = loadImage(image_path);
  map.grid = Grid(image.pixels.rows, image.pixels.cols);
  for (int row = 0; row < map.grid.rows(); ++row) {
    const std::vector<std::optional<double>> brightness = brightnessOf(image, row);
    for (int col = 0; col < map.grid.cols(); ++col) {
      map.grid.setObstacle({row, col},
                           !interpretation.isFree(brightness[static_cast<std::size_t>(col)]));
    }
  }
  return map;
}

}  // namespace sylph

#include "sylph_core/files/write_file.hpp"

#include <cerrno>
#include <cstring>

#include "files/text_file.hpp"

namespace sylph {

void writeFile(const std::string& path, const std::string& content, std::ios::openmode mode) {
  std::ofstream file(path, std::ios::out | std::ios::binary | mode);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  closeWritten(file, path);
}

void closeWritten(std::ofstream& file, const std::string& path) {
  // What fails first leaves its reason: a stream does nothing after that.
  const bool is_written = file.good();
  const int reason = errno;
  file.close();
  if (!file) {
    throw fileError(
        path, 0, std::string("cannot be written: ") + std::strerror(is_written ? errno : reason));
  }
}

}  // namespace sylph

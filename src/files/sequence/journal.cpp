// SPDX-License-Identifier: MIT
#include "sequence/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <string_view>

#include <touchstone/error.hpp>

#include "io/fail.hpp"
#include "io/sha256.hpp"
#include "io/whole_file.hpp"
#include "json/json_node.hpp"
#include "sequence/report_json.hpp"
#include "sequence/results_json.hpp"

namespace touchstone::sequence {
namespace {

constexpr std::size_t kDigestLength = 16;

std::string line_of(const std::string& json) {
  return io::sha256(json).substr(0, kDigestLength).append(" ").append(json).append("\n");
}

/// The JSON of the first line of `text`, which it is removed from; nothing when the line is torn or damaged.
std::optional<std::string> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos || end <= kDigestLength) return std::nullopt;
  std::string json(text.substr(kDigestLength + 1, end - kDigestLength - 1));
  if (text.substr(0, end + 1) != line_of(json)) return std::nullopt;
  text.remove_prefix(end + 1);
  return json;
}

/// One line: the heading's own lines are joined.
std::string heading_line(const Heading& heading) {
  std::string json = fmt::format("{{{}}}", heading_json(heading));
  std::replace(json.begin(), json.end(), '\n', ' ');
  return json;
}

Finished finished_from(const std::string& text, const Result& right, const Heading& heading) {
  const json::JsonDocument document = json::parse_json(text);
  const json::JsonNode root(document.value(), "the line");
  root.check_keys({"sha256", "result"});
  Finished finished{result_from(root.at("result")), {}};
  for (const auto& digest : root.at("sha256").items()) finished.digests.push_back(digest_from(digest));
  if (finished.digests.size() != (right.step ? 2 : 1) || finished.result.step != right.step ||
      finished.result.frame != right.frame) {
    root.fail("is about another frame or step than its place in the file");
  }
  if (finished.result.clearance.has_value() != heading.clearance ||
      finished.result.classes.has_value() != heading.classes) {
    root.fail("answers another question");
  }
  return finished;
}

std::string whole_text(int descriptor, const std::string& path) {
  std::string text;
  std::array<char, 1 << 16> block;
  constexpr std::uint64_t kMost = io::kJsonLimits.file;
  for (;;) {
    const ssize_t count = ::pread(descriptor, block.data(), block.size(), static_cast<off_t>(text.size()));
    if (count == 0) return text;
    if (count > 0) {
      text.append(block.data(), static_cast<std::size_t>(count));
      if (text.size() > kMost) io::fail(path, "is larger than " + io::size_text(kMost));
    } else if (errno != EINTR) {
      io::fail(path, "cannot be read: " + io::system_reason(errno));
    }
  }
}

}  // namespace

Journal::Journal(const std::string& path, const Heading& heading, Earlier earlier) : path_(path) {
  open_locked();
  try {
    struct stat status {};
    const bool empty = ::fstat(descriptor_, &status) == 0 && status.st_size == 0;
    if (!empty && earlier == Earlier::refused) {
      io::fail(
          path_,
          "is there: an earlier run with this report did not finish; --resume goes on with it, or remove the file");
    }
    if (!empty) read(heading);
    if (::lseek(descriptor_, 0, SEEK_END) == 0) {
      keep_ = false;
      write_line(heading_line(heading));
    }
  } catch (...) {
    if (!keep_) ::unlink(path_.c_str());
    ::close(descriptor_);
    throw;
  }
}

void Journal::open_locked() {
  for (;;) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) io::fail(path_, "cannot be written: " + io::system_reason(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      io::fail(path_, "is in use: another process is making this report");
    }
    // The process that held the lock may have finished and removed the file before the lock was free.
    struct stat held {
    }, named{};
    const bool same = ::fstat(descriptor_, &held) == 0 && ::stat(path_.c_str(), &named) == 0 &&
                      held.st_ino == named.st_ino && held.st_dev == named.st_dev;
    if (same && S_ISREG(held.st_mode)) return;
    ::close(descriptor_);
    if (same) io::fail(path_, "is no file; the progress of a run is written to this name");
  }
}

void Journal::read(const Heading& heading) {
  const std::string all = whole_text(descriptor_, path_);
  std::string_view text = all;
  const auto first = take_line(text);
  // A heading that was written in part is the start of this run's. Any other text is somebody's.
  if (!first && !line_of(heading_line(heading)).starts_with(all)) {
    io::fail(path_, "is no journal of touchstone mesh, or it is damaged; remove it to begin again");
  }
  try {
    if (first) {
      if (*first != heading_line(heading)) {
        const std::string difference = difference_of(heading_from(*first), heading, "this run");
        throw Error(difference.empty() ? "is of another run" : difference);
      }
      const Range range = range_of(heading);
      const std::size_t most = result_count(heading.question, range);
      while (finished_.size() < most) {
        const auto line = take_line(text);
        if (!line) break;
        finished_.push_back(finished_from(*line, result_at(heading.question, range, finished_.size()), heading));
      }
    }
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    io::fail(path_, error.what());
  }
  results_ = finished_.size();
  if (::ftruncate(descriptor_, static_cast<off_t>(all.size() - text.size())) != 0) {
    io::fail(path_, "cannot be written: " + io::system_reason(errno));
  }
}

void Journal::write_line(const std::string& json) {
  const std::string line = line_of(json);
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      io::fail(path_, "cannot be written: " + io::system_reason(errno));
    }
  }
}

void Journal::add(const Finished& finished) {
  std::string json = "{\"sha256\":[";
  for (const auto& digest : finished.digests) {
    json.append(json.ends_with('[') ? "\"" : ",\"").append(digest).append("\"");
  }
  write_line(json.append("],\"result\":").append(result_json(finished.result)).append("}"));
  ++results_;
}

void Journal::remove() {
  if (::unlink(path_.c_str()) != 0) io::fail(path_, "cannot be removed: " + io::system_reason(errno));
  ::close(descriptor_);
  descriptor_ = -1;
}

Journal::~Journal() {
  if (descriptor_ < 0) return;
  if (results_ == 0) ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace touchstone::sequence

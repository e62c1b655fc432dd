// SPDX-License-Identifier: MIT
#include "report/pictures/drawing.hpp"

#include <unistd.h>

#include <system_error>

#include <touchstone/error.hpp>

#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "report/pictures/gnuplot.hpp"

namespace touchstone::report {
namespace {

namespace fs = std::filesystem;

/// A folder for files that are not complete yet.
class DrawingFolder {
 public:
  explicit DrawingFolder(const fs::path& beside) : path_(beside / (".drawing-" + std::to_string(::getpid()))) {
    make_folder(path_);
  }
  ~DrawingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

void draw(const Plot& plot, const std::string& gnuplot, const fs::path& drawing, const fs::path& folder) {
  write_whole(drawing / (plot.name + ".gp"), plot.script);
  for (const std::string& name : plot.reads) {
    std::error_code error;
    fs::create_symlink(fs::absolute(folder) / name, drawing / name, error);
    if (error) io::fail((drawing / name).string(), "cannot be made: " + io::system_reason(error.value()));
  }
  run_gnuplot(gnuplot, drawing.string(), plot.name + ".gp");
  for (const char* ending : {".svg", ".png"}) {
    std::error_code error;
    fs::rename(drawing / (plot.name + ending), folder / (plot.name + ending), error);
    if (error) io::fail((folder / (plot.name + ending)).string(), "gnuplot has not drawn it, or it cannot be replaced");
  }
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) io::fail(folder.string(), "no folder can be made here: " + io::system_reason(error.value()));
}

void write_whole(const fs::path& path, const std::string& text) {
  io::OutputFile file(path.string());
  file.write(text);
  file.commit();
}

std::string write_plots(const std::vector<Plot>& plots, const fs::path& folder,
                        const std::function<void(double fraction)>& pulse) {
  for (const Plot& plot : plots) write_whole(folder / (plot.name + ".gp"), plot.script);
  const auto gnuplot = find_gnuplot();
  if (!gnuplot) {
    return "no gnuplot in PATH, so the plots are not drawn: install it (gnuplot-nox on Debian and Ubuntu, gnuplot on "
           "Fedora and Arch) and run `gnuplot *.gp` in " +
           folder.string();
  }
  const DrawingFolder drawing(folder);
  double done = 0;
  for (const Plot& plot : plots) {
    pulse(done / static_cast<double>(plots.size()));
    try {
      draw(plot, *gnuplot, drawing.path(), folder);
    } catch (const Error&) {
      pulse(done / static_cast<double>(plots.size()));  // Ctrl-C ends gnuplot as well, and is then the reason
      throw;
    }
    ++done;
  }
  return {};
}

}  // namespace touchstone::report

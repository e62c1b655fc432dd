# SPDX-License-Identifier: MIT
# There is no address to fetch from: HOMEBREW_TOUCHSTONE_ARCHIVE is the path of a source archive, and
# HOMEBREW_TOUCHSTONE_SHA256 its hash.
class Touchstone < Formula
  desc "Exact continuous collision detection for C++, C and the shell"
  url "file://#{ENV.fetch("HOMEBREW_TOUCHSTONE_ARCHIVE", "/HOMEBREW_TOUCHSTONE_ARCHIVE-is-not-set")}"
  version "0.2.0"
  sha256 ENV.fetch("HOMEBREW_TOUCHSTONE_SHA256", "0" * 64)
  license "MIT"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "nlohmann-json" => :build
  depends_on "cgal"
  depends_on "eigen"
  depends_on "fmt"
  depends_on "gmp"
  depends_on "hdf5"
  depends_on "mpfr"
  depends_on "tbb"

  uses_from_macos "expat"
  uses_from_macos "zlib"

  def install
    system "cmake", "-S", ".", "-B", "build", "-DBUILD_SHARED_LIBS=ON",
                    "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=24",
                    "-DTOUCHSTONE_BUILD_TESTS=OFF", "-DTOUCHSTONE_BUILD_ENGINES=OFF",
                    "-DTOUCHSTONE_BUILD_PYTHON=OFF", *std_cmake_args
    system "cmake", "--build", "build", "--target", "touchstone_installed"
    system "cmake", "--install", "build"
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/touchstone --version")
    system bin/"touchstone", "certify"
    (testpath/"main.c").write <<~C
      #include <touchstone/c.h>
      int main(void) { return touchstone_version()[0] == 0; }
    C
    system ENV.cc, "main.c", "-I#{include}", "-L#{lib}", "-ltouchstone", "-Wl,-rpath,#{lib}", "-o", "main"
    system "./main"
  end
end

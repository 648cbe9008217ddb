# Formula for Homebrew, on Linux:  brew install --HEAD --formula packaging/homebrew/gvd.rb
#
# Tried: `ruby -c`. Not built with Homebrew. On macOS the sources were never compiled; they need a C++ library whose from_chars
# reads doubles, so that gcc is asked for there.
# To publish: add `url` and `sha256` of a release archive.
class Gvd < Formula
  desc "Geodesic Voronoi diagrams on triangle meshes"
  license "MIT"
  head "file://#{File.expand_path("../..", __dir__)}", using: :git, branch: "main"

  depends_on "cmake" => :build
  depends_on "help2man" => :build
  depends_on "nlohmann-json" => :build
  depends_on "node" => :build
  depends_on "tomlplusplus" => :build
  depends_on "eigen"
  depends_on "fmt"
  depends_on "open-mesh"
  depends_on "pugixml"
  depends_on "tbb"
  depends_on "zlib"

  on_macos do
    depends_on "gcc"
  end
  fails_with :clang

  # Without CGAL, whose shortest paths would bind the package to the GPL.
  def install
    system "cmake", "-S", ".", "-B", "build", "-DGVD_BUILD_TESTS=OFF", "-DGVD_WITH_CGAL_GPL=OFF", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    (testpath/"a.off").write "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
    system bin/"gvd-segment", "a.off", "-n", "2", "-o", "b.ply"
    system bin/"gvd", "segment", "a.off", "-n", "2", "-o", "c.ply"
    assert_equal (testpath/"b.ply").read, (testpath/"c.ply").read
  end
end

# Untested: Homebrew was not at hand. Ruby reads the formula (tests/repository/recipes_test).
# brew install --build-from-source ./vandplan.rb    (in a tap of your own, with an address for `homepage`)
class Vandplan < Formula
  desc "Plans paths for trucks and buses"
  url "@ADDRESS@"
  version "@VERSION@"
  sha256 "@SHA256@"
  license "BSD-3-Clause"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pkgconf" => :build
  depends_on "cairo"
  depends_on "fmt"
  depends_on "geographiclib"
  depends_on "highway"
  depends_on "libpng"
  depends_on "pugixml"
  depends_on "sqlite"
  depends_on "yaml-cpp"
  depends_on "zlib"

  resource "d3" do
    url "@D3_ADDRESS@"
    sha256 "@D3_SHA256@"
  end

  def install
    resource("d3").stage buildpath/"d3"
    options = %W[-DVANDPLAN_TESTS=OFF -DVANDPLAN_OMPL=OFF -DVANDPLAN_D3=#{buildpath}/d3/d3.min.js]
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *options, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/vandplan --version")
  end
end

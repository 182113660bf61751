# Untested: nixpkgs was not at hand. Nix evaluates the expression with stand-ins (tests/repository/recipes_test).
# nix-build -E 'with import <nixpkgs> { }; callPackage ./default.nix { }'
{ lib, stdenv, fetchurl, cmake, ninja, pkg-config, cairo, cli11, eigen, fmt, geographiclib, libhwy, libpng
, nlohmann_json, ompl, pugixml, sqlite, yaml-cpp, zlib, withOmpl ? false }:

let
  d3 = fetchurl {
    url = "@D3_ADDRESS@";
    sha256 = "@D3_SHA256@";
  };
in
stdenv.mkDerivation {
  pname = "vandplan";
  version = "@VERSION@";
  src = fetchurl {
    url = "@ADDRESS@";
    sha256 = "@SHA256@";
  };

  nativeBuildInputs = [ cmake ninja pkg-config ];
  buildInputs = [ cli11 nlohmann_json ];
  # Archives: who links them needs these, too.
  propagatedBuildInputs = [ cairo fmt geographiclib libhwy libpng pugixml sqlite yaml-cpp zlib ]
    ++ lib.optionals withOmpl [ eigen ompl ];

  cmakeFlags = [
    "-DCMAKE_INSTALL_INCLUDEDIR=include"
    "-DCMAKE_INSTALL_LIBDIR=lib"
    "-DVANDPLAN_TESTS=OFF"
    "-DVANDPLAN_OMPL=${if withOmpl then "ON" else "OFF"}"
    "-DVANDPLAN_D3=${d3}"
  ];

  meta = {
    description = "Plans paths for trucks and buses";
    license = lib.licenses.bsd3;
    mainProgram = "vandplan";
    platforms = lib.platforms.unix;
  };
}

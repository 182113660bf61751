# nixpkgs, as an expression sees it: each package is its name.
{ recipe, withOmpl ? true }:

let
  expression = import recipe;
  packages = builtins.listToAttrs
    (map (name: { inherit name; value = name; }) (builtins.attrNames (builtins.functionArgs expression)));
in
expression (packages // {
  inherit withOmpl;
  lib = {
    optionals = holds: list: if holds then list else [ ];
    licenses.bsd3 = "BSD-3-Clause";
    platforms.unix = [ ];
  };
  stdenv.mkDerivation = attributes: attributes;
  fetchurl = { url, sha256 }: "${url}#${sha256}";
})

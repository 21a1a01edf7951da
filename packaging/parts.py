#!/usr/bin/env python3
"""What sphereview's packages hold of others, and under which licences.

  parts.py build FOLDER HOW:PART...   what one build has in it: writes the text of `sphereview --licenses` as licenses.cpp, a list as
                                      parts.json, and a file `copyright` as Debian wants it
  parts.py spdx FILE PACKAGE=LIST...  writes an SPDX 2.3 list of the packages, each with the parts.json of the build that it is from;
                                      no LIST: a wheel, which has its parts.json inside

HOW is `compiled` (from headers or sources, or linked in) or `shipped` (a shared library beside the program). Versions and the texts of the
licences are found where the program is built: Debian's packages have them. Elsewhere the list says less, and the text names the licence.
"""
import argparse
import datetime
import hashlib
import json
import os
import re
import subprocess
import uuid
import zipfile
from pathlib import Path
from typing import NamedTuple


class Part(NamedTuple):
    name: str
    license: str  # as SPDX writes it
    url: str
    package: str  # Debian's, whose file `copyright` has the licence
    common: str = ""  # a licence that this file only names: in /usr/share/common-licenses
    stanza: str = ""  # the only licence of this file that concerns the part, where there are hundreds


PARTS = {
    "boost": Part("Boost.Multiprecision", "BSL-1.0", "https://www.boost.org", "libboost*-dev", stanza="BSL-1.0"),
    "brotli": Part("Brotli", "MIT", "https://github.com/google/brotli", "libbrotli-dev"),
    "cli11": Part("CLI11", "BSD-3-Clause", "https://github.com/CLIUtils/CLI11", "libcli11-dev"),
    "expat": Part("Expat", "MIT", "https://github.com/libexpat/libexpat", "libexpat1-dev"),
    "fontconfig": Part("fontconfig", "HPND-sell-variant", "https://www.freedesktop.org/wiki/Software/fontconfig", "libfontconfig-dev"),
    "freetype": Part("FreeType", "FTL", "https://freetype.org", "libfreetype-dev"),
    "gemmi": Part("gemmi", "MPL-2.0", "https://github.com/project-gemmi/gemmi", "gemmi-dev", common="MPL-2.0"),
    "glad": Part("glad's loaders for OpenGL and EGL", "MIT AND Apache-2.0", "https://github.com/Dav1dde/glad", "python3-glad", common="Apache-2.0"),
    "glfw": Part("GLFW", "Zlib", "https://www.glfw.org", "libglfw3"),
    "glm": Part("GLM", "MIT", "https://github.com/g-truc/glm", "libglm-dev"),
    "imgui": Part("Dear ImGui", "MIT", "https://github.com/ocornut/imgui", "libimgui-dev"),
    "json": Part("JSON for Modern C++", "MIT", "https://github.com/nlohmann/json", "nlohmann-json3-dev"),
    "libdeflate": Part("libdeflate", "MIT", "https://github.com/ebiggers/libdeflate", "libdeflate-dev"),
    "libmd": Part("libmd", "BSD-3-Clause", "https://www.hadrons.org/software/libmd", "libmd-dev"),
    "libpng": Part("libpng", "libpng-2.0", "http://www.libpng.org/pub/png/libpng.html", "libpng-dev"),
    "libstdc++": Part("GCC's libstdc++ and libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org", "libstdc++6", common="GPL-3"),
    "mingw-w64": Part("mingw-w64's run-time library", "ZPL-2.1", "https://www.mingw-w64.org", "mingw-w64-x86-64-dev"),
    "pegtl": Part("PEGTL", "MIT", "https://github.com/taocpp/PEGTL", "tao-pegtl-dev"),
    "pybind11": Part("pybind11", "BSD-3-Clause", "https://github.com/pybind/pybind11", "pybind11-dev"),
    "stb": Part("stb", "MIT OR Unlicense", "https://github.com/nothings/stb", "libstb-dev"),
    "toml++": Part("toml++", "MIT", "https://github.com/marzer/tomlplusplus", "libtomlplusplus-dev"),
    # With its text in mingw-w64's, of which this is the part for most of it.
    "winpthreads": Part("winpthreads", "MIT AND BSD-3-Clause", "https://www.mingw-w64.org", "mingw-w64-x86-64-dev", stanza="expat"),
    "zlib": Part("zlib", "Zlib", "https://zlib.net", "zlib1g-dev"),
}
COMMON_LICENSES = Path("/usr/share/common-licenses")
ROOT = Path(__file__).resolve().parent.parent


def installed(pattern):
    """Name, version and architecture of the installed package of Debian; nothing where there is none."""
    try:
        query = ["dpkg-query", "-W", "-f", "${db:Status-Status} ${Package} ${Version} ${Architecture}\n", pattern]
        lines = subprocess.run(query, capture_output=True, text=True).stdout.splitlines()
    except OSError:
        return None
    # Of several the one with its files: libboost-dev only depends on libboost1.74-dev.
    found = [line.split()[1:] for line in lines if line.startswith("installed ")]
    return max(found, key=lambda package: len(package[0]), default=None)


def license_text(part, package, with_common):
    """What the package says of the part's licence, with the licence that this names; "" where no text was found."""
    file = Path("/usr/share/doc") / (package[0] if package else part.package) / "copyright"
    text = file.read_text(encoding="utf-8").rstrip() if file.exists() else ""
    if text and part.stanza:
        texts = re.findall(r"^License: " + re.escape(part.stanza) + r"\n((?: .*\n)+)", text, re.MULTILINE)
        text = max(texts, key=len, default="").rstrip()
    common = COMMON_LICENSES / part.common
    if with_common and text and part.common and common.exists():
        text += "\n\n" + common.read_text(encoding="utf-8").strip("\n")
    return text


def parts_of_build(words):
    parts = []
    for word in sorted(words, key=lambda word: PARTS[word.split(":")[1]].name.lower()):
        how, key = word.split(":")
        package = installed(PARTS[key].package)
        parts.append((PARTS[key], how, package))
    return parts


def licenses(parts, with_common=True):
    """The program's own licence, then those of the parts. Without texts that Debian has in /usr/share/common-licenses, if asked for."""
    line = "-" * 80
    text = (ROOT / "LICENSE").read_text(encoding="utf-8").rstrip()
    text += "\n\nsphereview has parts of others in it:\n\n"
    for part, how, package in parts:
        beside = ", a library beside the program" if how == "shipped" else ""
        text += f"  {part.name}: {part.license}, {part.url}{beside}\n"
    for part, _, package in parts:
        found = license_text(part, package, with_common) or f"Its text was not at hand when this program was built: {part.url}"
        text += f"\n{line}\n{part.name}: {part.license}\n{part.url}\n\n{found}\n"
    return text.rstrip()


def cpp(text):
    # In pieces: MSVC takes no literal of more than 16,380 bytes.
    literals = "".join(f'        R"LICENSE({text[i:i + 4000]})LICENSE",\n' for i in range(0, len(text), 4000))
    return f"""#include <string_view>
#include <vector>

#include "app/licenses.hpp"
#include "base/text.hpp"

namespace sphereview {{

std::string licenses() {{
    static const std::vector<std::string> pieces = {{
{literals}    }};
    return joined(pieces, "");
}}

}}  // namespace sphereview
"""


def write(file, text):
    """Leaves a file alone that is so already: nothing is compiled anew for it."""
    if not file.exists() or file.read_bytes() != text.encode():
        file.write_bytes(text.encode())


def build(arguments):
    parts = parts_of_build(arguments.parts)
    folder = Path(arguments.folder)
    write(folder / "licenses.cpp", cpp(licenses(parts)))
    write(folder / "copyright", licenses(parts, with_common=False) + "\n")
    listed = []
    for part, how, package in parts:
        entry = {"name": part.name, "license": part.license, "url": part.url, "how": how}
        if package:
            entry["version"] = re.sub(r"^\d+:", "", package[1])
            entry["purl"] = "pkg:deb/debian/%s@%s?arch=%s" % (package[0], package[1].replace("+", "%2B").replace(":", "%3A"), package[2])
        listed.append(entry)
    write(folder / "parts.json", json.dumps(listed, indent=1) + "\n")


def spdx_package(identifier, name, version, license, url, **more):
    return {"SPDXID": "SPDXRef-" + re.sub(r"[^A-Za-z0-9.]", "-", identifier), "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": license, "licenseDeclared": license, "copyrightText": "NOASSERTION", **({"homepage": url} if url else {}),
            **more}


def spdx(arguments):
    version = re.search(r"project\(sphereview VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    packages, relationships, sums = {}, [], ""

    def relate(one, kind, other):
        relationships.append({"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other})

    for word in arguments.packages:
        file, _, listed = word.partition("=")
        total = hashlib.sha256(Path(file).read_bytes()).hexdigest()
        sums += total
        name = Path(file).name
        parts = json.loads(Path(listed).read_text() if listed else zipfile.ZipFile(file).read("sphereview/licenses/parts.json"))
        license = " AND ".join(sorted({f"({part['license']})" if " " in part["license"] else part["license"] for part in parts} | {"MIT"}))
        product = spdx_package("Package-" + name, "sphereview", version, license, None, packageFileName=name,
                               checksums=[{"algorithm": "SHA256", "checksumValue": total}])
        product["licenseDeclared"] = "MIT"
        packages[product["SPDXID"]] = product
        relate("SPDXRef-DOCUMENT", "DESCRIBES", product["SPDXID"])
        for part in parts:
            more = {}
            if "purl" in part:
                more["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": part["purl"]}]
            its_version = part.get("version", "NOASSERTION")
            entry = spdx_package(f"Part-{part['name']}-{its_version}", part["name"], its_version, part["license"], part["url"], **more)
            packages[entry["SPDXID"]] = entry
            relate(product["SPDXID"], "CONTAINS", entry["SPDXID"])
    time = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", datetime.datetime.now().timestamp())), datetime.timezone.utc)
    document = {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"sphereview-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/sphereview-{version}-{uuid.uuid5(uuid.NAMESPACE_OID, sums)}",
        "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": [f"Tool: sphereview-packaging-{version}"]},
        "packages": list(packages.values()), "relationships": relationships,
    }
    Path(arguments.file).write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    command = commands.add_parser("build")
    command.add_argument("folder")
    command.add_argument("parts", nargs="*", metavar="HOW:PART")
    command.set_defaults(run=build)
    command = commands.add_parser("spdx")
    command.add_argument("file")
    command.add_argument("packages", nargs="+", metavar="PACKAGE=LIST")
    command.set_defaults(run=spdx)
    arguments = parser.parse_args()
    arguments.run(arguments)


if __name__ == "__main__":
    main()

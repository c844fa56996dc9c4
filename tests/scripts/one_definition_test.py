# SPDX-License-Identifier: MIT
"""No two types of the project have one name (C++'s one-definition rule). No compiler sees both, and of
their functions with one name a linker takes any. GCC can tell by -flto -Wodr, in a second build."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|^[ \t]*#(?:\\\n|[^\n])*'  # comments, macros
    r'|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'',  # texts and characters
    re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r"(?:inline )?namespace ?([\w: ]*)$")
TYPE = re.compile(r"(?:enum (?:class |struct )?|class |struct |union )([\w:]+(?: ?<.*>[\w:]*)?)(?: final)?(?: ?:(?!:).*)?$")
BEFORE_TYPE = re.compile(r"(?:(?:public|private|protected|typedef|static|inline|const|constexpr) ?:? ?)*")


def without_template(head):
    """`template <class T> struct Image` becomes `struct Image`."""
    while head.startswith("template"):
        depth = 0
        for place, sign in enumerate(head):
            depth += (sign == "<") - (sign == ">")
            if sign == ">" and depth == 0:
                break
        head = head[place + 1:].lstrip()
    return head


def scope(head):
    """What the brace after `head` opens, and its name; "" when no other file can name it."""
    head = without_template(BEFORE_TYPE.sub("", " ".join(head.split()), count=1))
    if (match := NAMESPACE.match(head)) is not None:
        return "namespace", match[1].strip()
    if (match := TYPE.match(head)) is not None:
        return "type", match[1].replace(" ", "")
    return "body", ""


def type_definitions(code):
    """Of the types that a file defines and another could define as well: qualified name and line."""
    code = NOT_CODE.sub(lambda text: re.sub(r"[^\n]", " ", text[0]), code)
    scopes, begin = [], 0
    for brace in re.finditer(r"[{};]", code):
        if brace[0] == "{":
            scopes.append(scope(code[begin:brace.start()]))
            if scopes[-1][0] == "type" and all(name for _, name in scopes):
                yield "::".join(name for _, name in scopes), code.count("\n", 0, brace.start()) + 1
        elif brace[0] == "}" and scopes:
            scopes.pop()
        begin = brace.end()


def defined_twice(sources):
    """Of a mapping from file names to code."""
    places = {}
    for file, code in sources.items():
        for name, line in type_definitions(code):
            places.setdefault(name, []).append(f"{file}:{line}")
    return {name: where for name, where in places.items() if len(where) > 1}


def sources():
    for file in sorted(ROOT.rglob("*")):
        place = file.relative_to(ROOT)
        if file.suffix in (".h", ".cpp") and not place.parts[0].startswith((".", "build")):
            yield str(place), file.read_text(encoding="utf-8")


class OneDefinition(unittest.TestCase):
    def names(self, code):
        return [name for name, _ in type_definitions(code)]

    def test_no_two_types_of_the_project_share_a_name(self):
        project = dict(sources())
        self.assertGreater(sum(len(self.names(code)) for code in project.values()), 200)
        self.assertEqual(defined_twice(project), {})

    def test_finds_a_name_that_two_files_define(self):
        found = defined_twice({"flesh.h": "namespace graspdb {\nstruct Capsule { double depth; };\n}",
                               "digits.h": "namespace graspdb {\n\nstruct Capsule {\n};\n}",
                               "other.h": "struct Capsule {};"})
        self.assertEqual(found, {"graspdb::Capsule": ["flesh.h:2", "digits.h:3"]})

    def test_reads_all_ways_to_define_a_type(self):
        self.assertEqual(self.names("""
            namespace a::b {
            template <typename T, class U = std::vector<T>> class Image final : public Base<T> {
             public:
              enum class Kind : int { kOne };
              struct Row { int x; } row{};
            };
            template <> struct Image<int> {};
            union Bits { float f; };
            inline namespace c { enum Flags { kNone }; }
            struct Image<int>::State {};
            }"""), ["a::b::Image", "a::b::Image::Kind", "a::b::Image::Row", "a::b::Image<int>", "a::b::Bits",
                    "a::b::c::Flags", "a::b::Image<int>::State"])

    def test_leaves_out_what_no_other_file_can_name(self):
        self.assertEqual(self.names("""
            // struct Comment {};
            #define MACRO struct Macro {};
            namespace { struct Hidden { struct Inner {}; }; }
            struct Declared;
            struct Elaborated make(struct Parameter p) { struct Local {}; return {}; }
            const char* text = "struct Text {"; const char brace = '{';
            const auto raw = R"(struct Raw {)";
            struct Seen {};"""), ["Seen"])


if __name__ == "__main__":
    unittest.main()

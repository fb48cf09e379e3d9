#!/usr/bin/env python3
"""Writes Native/Generated/*.g.cs from the Vulkan registry (vk.xml).

Usage: generate.py [vk.xml]      default: /usr/share/vulkan/registry/vk.xml (Debian: libvulkan-dev)

Only the commands in commands.txt, the structs they reach and the structs listed there (pNext chains) are written.
Enum members lose their prefix: VK_IMAGE_LAYOUT_GENERAL -> VkImageLayout.General.
"""
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
TARGET = os.path.join(HERE, "..", "Native", "Generated")
BASIC = {"void": "void", "char": "byte", "float": "float", "double": "double", "int32_t": "int", "uint32_t": "uint",
         "int64_t": "long", "uint64_t": "ulong", "uint8_t": "byte", "uint16_t": "ushort", "int": "int", "size_t": "nuint",
         "VkBool32": "uint", "VkDeviceSize": "ulong", "VkDeviceAddress": "ulong", "VkSampleMask": "uint"}
KEYWORDS = {"object", "event", "ref", "in", "out", "params", "lock", "fixed", "base", "string"}


class Registry:
    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        self.types = {t.get("name") or t.findtext("name"): t for t in root.find("types") if t.get("name") or t.findtext("name")}
        self.commands = {c.findtext("proto/name"): c for c in root.find("commands") if c.find("proto") is not None}
        self.enums = {e.get("name"): e for e in root.findall("enums")}
        self.constants = {e.get("name"): e.get("value") for e in self.enums["API Constants"] if e.get("value")}
        self.added = {}
        for source, number in self._sources(root):
            for item in source.iter("enum"):
                if item.get("extends") and not item.get("alias"):
                    self.added.setdefault(item.get("extends"), []).append((item, item.get("extnumber") or number))

    @staticmethod
    def _sources(root):
        for feature in root.findall("feature"):
            yield feature, None
        for extension in root.find("extensions"):
            if extension.get("name") in EXTENSIONS:
                yield extension, extension.get("number")

    def bits(self, flags):
        kind = self.types.get(flags)
        return kind is not None and (kind.get("requires") or kind.get("bitvalues"))

    def members(self, enum):
        values = {}
        items = [(e, None) for e in self.enums[enum].findall("enum")] + self.added.get(enum, [])
        for item, number in items:
            if item.get("alias"):
                continue
            if item.get("bitpos"):
                value = 1 << int(item.get("bitpos"))
            elif item.get("value"):
                value = int(item.get("value"), 0)
            else:
                value = 1000000000 + (int(number) - 1) * 1000 + int(item.get("offset"))
                value = -value if item.get("dir") == "-" else value
            values[item.get("name")] = value
        return values


def member_name(enum, value):
    stem = re.sub(r"(FlagBits\d?|Flags\d?)", "", enum)
    version = re.search(r"FlagBits(\d)", enum)
    stem = re.sub(r"(EXT|KHR)$", "", stem)
    prefix = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", stem).upper() + "_"
    prefix = "VK_" if enum == "VkResult" else prefix + (version.group(1) + "_" if version else "")
    name = value[len(prefix):] if value.startswith(prefix) else value[3:]
    name = re.sub(r"(_EXT|_KHR)$", "", name) if enum.endswith(("EXT", "KHR")) else name
    name = re.sub(r"_(BIT|BIT_EXT|BIT_KHR)$", "", name)
    name = "".join(part[:1].upper() + part[1:].lower() for part in name.split("_"))
    return "_" + name if name[0].isdigit() else name


class Writer:
    def __init__(self, registry):
        self.registry, self.queue, self.done, self.structs, self.enums, self.handles = registry, [], set(), [], [], []

    def type_name(self, name):
        if name in BASIC:
            return BASIC[name]
        kind = self.registry.types.get(name)
        if kind is None:
            return "void"
        if kind.get("alias"):
            return self.type_name(kind.get("alias"))
        category = kind.get("category")
        if category == "funcpointer":
            return "nint"
        if category == "bitmask":
            bits = self.registry.bits(name)
            wide = "VkFlags64" in "".join(kind.itertext())
            return self.type_name(bits) if bits in self.registry.enums and self.registry.members(bits) else "ulong" if wide else "uint"
        if category in ("struct", "union", "enum", "handle") and name not in self.done:
            self.done.add(name)
            self.queue.append((category, name))
        return name.replace("FlagBits", "Flags") if category == "enum" else name

    def declaration(self, node):
        text = "".join(t for child in [node] for t in self._pieces(child))
        name, kind = node.findtext("name"), node.findtext("type")
        sizes = re.findall(r"\[(\w+)\]", text)
        return self.type_name(kind) if text.count("*") or kind != "void" else "void", "*" * text.count("*"), name, sizes

    @staticmethod
    def _pieces(node):
        yield node.text or ""
        for child in node:
            if child.tag != "comment":
                yield child.text or ""
            yield child.tail or ""

    def struct(self, name):
        node, lines, arrays = self.registry.types[name], [], []
        union = node.get("category") == "union"
        for member in node.findall("member"):
            kind, pointers, field, sizes = self.declaration(member)
            field = "@" + field if field in KEYWORDS else field
            offset = "[FieldOffset(0)] " if union else ""
            if sizes:
                count = 1
                for size in sizes:
                    count *= int(self.registry.constants.get(size, size))
                if kind in ("byte", "uint", "int", "float", "ulong"):
                    lines.append(f"    {offset}public fixed {kind} {field}[{count}];")
                else:
                    array = f"{kind}Array{count}"
                    arrays.append((array, kind, count))
                    lines.append(f"    {offset}public {array} {field};")
            else:
                lines.append(f"    {offset}public {kind}{pointers} {field};")
        first = node.find("member")
        layout = "[StructLayout(LayoutKind.Explicit)]\n" if union else ""
        text = f"{layout}internal unsafe struct {name}\n{{\n" + "\n".join(lines) + "\n"
        if first.findtext("name") == "sType" and first.get("values"):
            value = member_name("VkStructureType", first.get("values"))
            text += f"\n    public {name}() => sType = VkStructureType.{value};\n"
        self.structs.append(text + "}\n")
        for array, kind, count in arrays:
            if array not in self.done:
                self.done.add(array)
                self.structs.append(f"[InlineArray({count})]\ninternal struct {array}\n{{\n    private {kind} first;\n}}\n")

    def enum(self, name):
        values = self.registry.members(name) if name in self.registry.enums else {}
        if name == "VkStructureType":
            used = set(re.findall(r"VkStructureType\.(\w+)", "\n".join(self.structs)))
            values = {k: v for k, v in values.items() if member_name(name, k) in used}
        flags = "FlagBits" in name
        kind = "ulong" if flags and self.registry.enums[name].get("bitwidth") == "64" else "uint" if flags else "int"
        seen, lines = set(), ["    None = 0,"] if flags else []
        seen.update({"None"} if flags else ())
        for key, value in values.items():
            member = member_name(name, key)
            if member not in seen:
                seen.add(member)
                lines.append(f"    {member} = {value},")
        head = "[Flags]\n" if flags else ""
        self.enums.append(f"{head}internal enum {name.replace('FlagBits', 'Flags')} : {kind}\n{{\n" + "\n".join(lines) + "\n}\n")

    def handle(self, name):
        kind = "nint" if "VK_DEFINE_HANDLE" in "".join(self.registry.types[name].itertext()) else "ulong"
        self.handles.append(f"internal readonly record struct {name}({kind} Handle)\n{{\n    public bool IsNull => Handle == 0;\n}}\n")

    def command(self, name):
        node = self.registry.commands[name]
        parameters = []
        for parameter in node.findall("param"):
            kind, pointers, field, sizes = self.declaration(parameter)
            parameters.append((kind + pointers + ("*" if sizes else ""), "@" + field if field in KEYWORDS else field))
        return self.type_name(node.findtext("proto/type")), parameters

    def drain(self):
        late = []
        while self.queue:
            category, name = self.queue.pop(0)
            if name == "VkStructureType":
                late.append(name)
            elif category in ("struct", "union"):
                self.struct(name)
            elif category == "enum":
                self.enum(name)
            else:
                self.handle(name)
        for name in late:
            self.enum(name)


def write(file, usings, body):
    os.makedirs(TARGET, exist_ok=True)
    head = "// <auto-generated>Headless/Vulkan/Generator/generate.py</auto-generated>\n#nullable disable\n"
    with open(os.path.join(TARGET, file), "w", encoding="utf-8", newline="\n") as out:
        out.write(head + "".join(f"using {u};\n" for u in usings) + "\nnamespace Headless.Vulkan.Native;\n\n" + body)


with open(os.path.join(HERE, "commands.txt"), encoding="utf-8") as listing:
    WANTED = [line.strip() for line in listing if line.strip() and not line.startswith("#")]
EXTENSIONS = {w for w in WANTED if w.startswith("VK_")}


def main():
    registry = Registry(sys.argv[1] if len(sys.argv) > 1 else "/usr/share/vulkan/registry/vk.xml")
    writer, imports, pointers = Writer(registry), [], []
    for name in [w for w in WANTED if not w.startswith("VK_")]:
        if not name.startswith("vk"):
            writer.type_name(name)
            continue
        result, parameters = writer.command(name)
        listed = ", ".join(f"{kind} {field}" for kind, field in parameters)
        if name.endswith(("EXT", "KHR")):
            kinds = "".join(kind + ", " for kind, _ in parameters)
            pointers.append(f"    public delegate* unmanaged<{kinds}{result}> {name};\n")
        else:
            imports.append(f"    [LibraryImport(VulkanLibrary.Name)]\n    public static partial {result} {name}({listed});\n")
    writer.drain()
    write("Enums.g.cs", ["System"], "\n".join(sorted(set(writer.enums))))
    write("Structs.g.cs", ["System.Runtime.CompilerServices", "System.Runtime.InteropServices"], "\n".join(sorted(set(writer.structs))))
    write("Handles.g.cs", [], "\n".join(sorted(set(writer.handles))))
    write("Functions.g.cs", ["System.Runtime.InteropServices"],
          "internal static unsafe partial class Vk\n{\n" + "\n".join(imports) + "}\n\n"
          + "/// <summary>Extension functions, looked up per instance.</summary>\n"
          + "internal unsafe struct VkExtensions\n{\n" + "".join(pointers) + "}\n")


main()

using System.Text.RegularExpressions;

namespace Headless.Shaders;

/// <summary>Sets a kernel apart from functions that overload its name; glslang takes all of them for the entry point.</summary>
internal static class KernelNames
{
    private const string Suffix = "_KERNEL";

    /// <summary>Text and name of the kernel's function in it: the given ones unless the name is overloaded.</summary>
    public static (string Text, string Name) Separate(string text, string kernel)
    {
        string name = Regex.Escape(kernel);
        if (Regex.Count(text, $@"\b{name}\s*\(") < 2)
        {
            return (text, kernel);
        }
        string renamed = Regex.Replace(text, $@"(\[\s*numthreads\s*\([^\]]*\]\s*void\s+){name}(?=\s*\()", "$1" + kernel + Suffix);
        return renamed == text ? (text, kernel) : (renamed, kernel + Suffix);
    }
}

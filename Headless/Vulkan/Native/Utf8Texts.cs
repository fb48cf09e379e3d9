using System.Runtime.InteropServices;

namespace Headless.Vulkan.Native;

/// <summary>Zero-terminated texts for Vulkan, freed together.</summary>
internal sealed unsafe class Utf8Texts : IDisposable
{
    private readonly List<nint> texts = [];

    public static string Read(byte* text) => Marshal.PtrToStringUTF8((nint)text) ?? "";

    public byte* Add(string text)
    {
        nint pointer = Marshal.StringToCoTaskMemUTF8(text);
        texts.Add(pointer);
        return (byte*)pointer;
    }

    /// <summary>Fills <paramref name="target"/>, which has a place for each text.</summary>
    public void AddAll(IReadOnlyList<string> list, byte** target)
    {
        for (int i = 0; i < list.Count; i++)
        {
            target[i] = Add(list[i]);
        }
    }

    public void Dispose() => texts.ForEach(Marshal.FreeCoTaskMem);
}

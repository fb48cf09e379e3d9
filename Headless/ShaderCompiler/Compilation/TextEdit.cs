using System.Text;

namespace Headless.Shaders;

/// <summary>Changes to a text that are collected first; positions are those of the text before.</summary>
internal sealed class TextEdit(string text)
{
    private readonly SortedDictionary<int, (int Length, string Put)> changes = [];

    public bool IsEmpty => changes.Count == 0;

    public void Replace(int start, int length, string put) => changes[start] = (length, put);

    /// <summary>Takes characters away; line breaks stay, so that messages keep their lines.</summary>
    public void Blank(int start, int end) =>
        Replace(start, end - start, new string([.. text[start..end].Select(c => c == '\n' ? '\n' : ' ')]));

    public override string ToString()
    {
        StringBuilder result = new();
        int at = 0;
        foreach ((int start, (int length, string put)) in changes)
        {
            result.Append(text, at, start - at).Append(put);
            at = start + length;
        }
        return result.Append(text, at, text.Length - at).ToString();
    }
}

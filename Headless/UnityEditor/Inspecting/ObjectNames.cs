using System.Text;

namespace UnityEditor;

public sealed class ObjectNames
{
    /// <summary>"m_maxSpeed" becomes "Max Speed".</summary>
    public static string NicifyVariableName(string name)
    {
        if (name.StartsWith("m_", System.StringComparison.Ordinal)) name = name[2..];
        else if (name.Length > 1 && name[0] == 'k' && char.IsUpper(name[1])) name = name[1..];
        name = name.TrimStart('_');
        var text = new StringBuilder();
        for (int i = 0; i < name.Length; i++)
        {
            bool newWord = i > 0 && char.IsUpper(name[i]) && (!char.IsUpper(name[i - 1]) || (i + 1 < name.Length && char.IsLower(name[i + 1])));
            if (newWord) text.Append(' ');
            text.Append(i == 0 ? char.ToUpperInvariant(name[i]) : name[i]);
        }
        return text.ToString();
    }
}

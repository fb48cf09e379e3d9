using System.Text;

namespace Headless.Shaders;

/// <summary>Follows /* */ comments from line to line.</summary>
internal sealed class CommentState
{
    public bool InBlock { get; private set; }

    public void Advance(string line)
    {
        bool quoted = false;
        for (int i = 0; i < line.Length; i++)
        {
            char next = i + 1 < line.Length ? line[i + 1] : '\0';
            if (InBlock)
            {
                if (line[i] == '*' && next == '/')
                {
                    InBlock = false;
                    i++;
                }
            }
            else if (line[i] == '"')
            {
                quoted = !quoted;
            }
            else if (!quoted && line[i] == '/' && next == '/')
            {
                return;
            }
            else if (!quoted && line[i] == '/' && next == '*')
            {
                InBlock = true;
                i++;
            }
        }
    }

    /// <summary>One line without its comments.</summary>
    public static string WithoutComments(string line)
    {
        StringBuilder kept = new();
        for (int i = 0; i < line.Length; i++)
        {
            if (line[i] == '/' && i + 1 < line.Length && line[i + 1] == '/')
            {
                break;
            }
            if (line[i] == '/' && i + 1 < line.Length && line[i + 1] == '*')
            {
                int end = line.IndexOf("*/", i + 2, StringComparison.Ordinal);
                if (end < 0)
                {
                    break;
                }
                kept.Append(' ');
                i = end + 1;
                continue;
            }
            kept.Append(line[i]);
        }
        return kept.ToString();
    }
}

namespace Headless.Importers.Scenes;

/// <summary>Refuses transforms that are their own ancestors, and chains that no recursion over a hierarchy would survive.</summary>
internal static class HierarchyCheck
{
    /// <summary>Far beyond what scenes have: an arm with a hundred bones has a hundred.</summary>
    public const int Deepest = 1000;

    /// <exception cref="ImportException">There is such a transform; the message names it.</exception>
    public static void Require(
        SourceFile file, Func<SourceObject, SourceObject?> fatherOf, Func<SourceObject, string> placeOf, Func<SourceObject, string> describe)
    {
        var depths = new Dictionary<SourceObject, int>();
        var path = new List<SourceObject>();
        var onPath = new HashSet<SourceObject>();
        foreach (SourceObject item in file.Objects)
        {
            path.Clear();
            onPath.Clear();
            int depth = 0;
            for (SourceObject? next = item; next is not null && !depths.TryGetValue(next, out depth); next = fatherOf(next))
            {
                if (!onPath.Add(next))
                    throw ImportException.At(placeOf(next), $"{describe(next)} is its own ancestor: m_Father leads in a circle.",
                        "Set the m_Father of one of them to {fileID: 0}, or restore the file from version control.");
                path.Add(next);
            }
            for (int i = path.Count - 1; i >= 0; i--)
            {
                if (++depth > Deepest)
                    throw ImportException.At(placeOf(path[i]), $"{describe(path[i])} has more than {Deepest} ancestors.", "Flatten the hierarchy.");
                depths[path[i]] = depth;
            }
        }
    }
}

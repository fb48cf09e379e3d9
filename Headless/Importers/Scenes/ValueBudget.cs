using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>
/// Bounds what a file may grow to when its prefabs are expanded: ten prefabs in ten prefabs in ten are small files, and
/// an override can ask for two thousand million elements.
/// </summary>
public sealed class ValueBudget(string assetPath)
{
    private long used;

    public void Take(long values)
    {
        used += values;
        if (used > UnityYaml.MostValues)
            throw ImportException.At(assetPath, $"its prefab instances and overrides come to more than {UnityYaml.MostValues} values.",
                "Divide the scene, or correct overrides of array sizes and prefabs that contain each other many times.");
    }
}

using Headless.Importers.Scenes;

namespace Headless.Importers.Serialization;

public interface IReferenceResolver
{
    /// <summary>The object a reference means, or null when it is null or missing (which is reported with <paramref name="where"/>).</summary>
    UnityEngine.Object? Resolve(FileReference reference, Type expected, string where);
}

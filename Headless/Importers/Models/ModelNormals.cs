namespace Headless.Importers.Models;

/// <summary><c>normalImportMode</c> of a ModelImporter.</summary>
public enum ModelNormals
{
    Import = 0,
    Calculate = 1,
    None = 2,
}

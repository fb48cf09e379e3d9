namespace UnityEditor;

public class ModelImporter : AssetImporter
{
    public bool isReadable { get; set; }
}

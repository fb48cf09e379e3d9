namespace Headless.Importers.Scenes;

/// <summary>Class ids of Unity's YAML (<c>!u!N</c>) that the importers treat by name; the manual's page "YAML class ID reference" lists all.</summary>
public static class ClassIds
{
    public const int GameObject = 1;
    public const int Transform = 4;
    public const int Camera = 20;
    public const int Material = 21;
    public const int MeshRenderer = 23;
    public const int MeshFilter = 33;
    public const int OcclusionCullingSettings = 29;
    public const int Rigidbody = 54;
    public const int MeshCollider = 64;
    public const int BoxCollider = 65;
    public const int AudioListener = 81;
    public const int RenderTexture = 84;
    public const int RenderSettings = 104;
    public const int Light = 108;
    public const int MonoBehaviour = 114;
    public const int SphereCollider = 135;
    public const int CapsuleCollider = 136;
    public const int SkinnedMeshRenderer = 137;
    public const int CharacterController = 143;
    public const int WheelCollider = 146;
    public const int LightmapSettings = 157;
    public const int NavMeshSettings = 196;
    public const int ReflectionProbe = 215;
    public const int RectTransform = 224;
    public const int PrefabInstance = 1001;
    public const int SceneRoots = 1660057539;
}

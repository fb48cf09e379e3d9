namespace UnityEngine.Rendering.Universal;

public static class CameraExtensions
{
    /// <summary>Adds the component to a camera that lacks it, as Unity does.</summary>
    public static UniversalAdditionalCameraData GetUniversalAdditionalCameraData(this Camera camera) =>
        camera.gameObject.TryGetComponent(out UniversalAdditionalCameraData data) ? data : camera.gameObject.AddComponent<UniversalAdditionalCameraData>();
}

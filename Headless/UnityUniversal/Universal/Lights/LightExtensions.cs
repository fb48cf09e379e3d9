namespace UnityEngine.Rendering.Universal;

public static class LightExtensions
{
    /// <summary>Adds the component to a light that lacks it, as Unity does.</summary>
    public static UniversalAdditionalLightData GetUniversalAdditionalLightData(this Light light) =>
        light.gameObject.TryGetComponent(out UniversalAdditionalLightData data) ? data : light.gameObject.AddComponent<UniversalAdditionalLightData>();
}

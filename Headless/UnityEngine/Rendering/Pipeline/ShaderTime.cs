using UnityEngine;

namespace Headless.Engine;

/// <summary>The time variables of shaders.</summary>
internal static class ShaderTime
{
    public static void Apply()
    {
        float t = Time.timeSinceLevelLoad;
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetVector(BuiltinNames.Time, new Vector4(t / 20f, t, t * 2f, t * 3f));
        sheet.SetVector(BuiltinNames.SinTime, new Vector4(Mathf.Sin(t / 8f), Mathf.Sin(t / 4f), Mathf.Sin(t / 2f), Mathf.Sin(t)));
        sheet.SetVector(BuiltinNames.CosTime, new Vector4(Mathf.Cos(t / 8f), Mathf.Cos(t / 4f), Mathf.Cos(t / 2f), Mathf.Cos(t)));
        float dt = Time.deltaTime;
        float smooth = Time.smoothDeltaTime;
        sheet.SetVector(BuiltinNames.DeltaTime, new Vector4(dt, dt > 0f ? 1f / dt : 0f, smooth, smooth > 0f ? 1f / smooth : 0f));
    }
}

using UnityEngine;

namespace Headless.Engine;

/// <summary>Magenta, for shaders that do not compile or fit.</summary>
internal static class ErrorMaterial
{
    private static Material? instance;

    public static Material Instance
    {
        get
        {
            if (instance == null)
            {
                instance = new Material(ShaderLibrary.Require("Hidden/InternalErrorShader")) { hideFlags = HideFlags.HideAndDontSave };
            }

            return instance;
        }
    }

    public static void Reset() => instance = null;
}

using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Camera
{
    private float[] layerDistances = new float[32];

    /// <summary>A distance a layer beyond which its objects are not drawn; 0 for the far plane.</summary>
    public float[] layerCullDistances
    {
        get => [.. layerDistances];
        set => layerDistances = value.Length == 32 ? [.. value] : throw new UnityException("Array needs to contain exactly 32 floats for layerCullDistances.");
    }

    public bool layerCullSpherical { get; set; }

    public bool TryGetCullingParameters(out ScriptableCullingParameters cullingParameters) => TryGetCullingParameters(false, out cullingParameters);

    /// <summary>False for a camera that cannot draw.</summary>
    public bool TryGetCullingParameters(bool stereoAware, out ScriptableCullingParameters cullingParameters)
    {
        cullingParameters = default;
        if (pixelWidth <= 0 || pixelHeight <= 0 || farClipPlane <= nearClipPlane)
        {
            return false;
        }

        cullingParameters = CameraCulling.Parameters(this);
        return true;
    }

    public void SubmitRenderRequest<RequestData>(RequestData renderRequest) => RenderPipeline.SubmitRenderRequest(this, renderRequest);
}

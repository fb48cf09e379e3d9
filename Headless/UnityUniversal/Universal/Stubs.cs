// Until the stand-in has these types.
namespace UnityEngine.Rendering.Universal;

public abstract class ScriptableRendererData : ScriptableObject
{
}

public class UniversalRendererData : ScriptableRendererData
{
}

public sealed class UniversalRenderer : ScriptableRenderer
{
}

public class UniversalRenderPipelineAsset : RenderPipelineAsset
{
    [SerializeField] private ScriptableRendererData[] m_RendererDataList = [];

    public ScriptableRenderer? scriptableRenderer => null;
    public System.ReadOnlySpan<ScriptableRendererData> rendererDataList => m_RendererDataList;

    public static UniversalRenderPipelineAsset Create(ScriptableRendererData? rendererData = null)
    {
        UniversalRenderPipelineAsset asset = CreateInstance<UniversalRenderPipelineAsset>();
        asset.m_RendererDataList = [rendererData!];
        return asset;
    }
}

public class UniversalAdditionalLightData : MonoBehaviour
{
}

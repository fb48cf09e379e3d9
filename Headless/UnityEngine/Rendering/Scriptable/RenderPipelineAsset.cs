namespace UnityEngine.Rendering;

/// <summary>Makes a render pipeline; the project's GraphicsSettings or QualitySettings name the asset that draws.</summary>
public abstract class RenderPipelineAsset : ScriptableObject
{
    public virtual int terrainBrushPassIndex => (int)RenderQueue.GeometryLast;
    public virtual Shader? terrainDetailLitShader => null;
    public virtual Shader? terrainDetailGrassShader => null;
    public virtual Shader? terrainDetailGrassBillboardShader => null;
    public virtual Material? defaultMaterial => null;
    public virtual Shader? autodeskInteractiveShader => null;
    public virtual Shader? autodeskInteractiveTransparentShader => null;
    public virtual Shader? autodeskInteractiveMaskedShader => null;
    public virtual Material? defaultParticleMaterial => null;
    public virtual Material? defaultLineMaterial => null;
    public virtual Material? defaultTerrainMaterial => null;
    public virtual Material? defaultUIMaterial => null;
    public virtual Material? defaultUIOverdrawMaterial => null;
    public virtual Material? defaultUIETC1SupportedMaterial => null;
    public virtual Material? default2DMaterial => null;
    public virtual Material? default2DMaskMaterial => null;
    public virtual Shader? defaultShader => null;
    public virtual Shader? defaultSpeedTree7Shader => null;
    public virtual Shader? defaultSpeedTree8Shader => null;

    /// <summary>SubShaders whose tag RenderPipeline has this value fit the pipeline, beside those without the tag.</summary>
    public virtual string renderPipelineShaderTag => string.Empty;

    internal RenderPipeline? Create() => CreatePipeline();

    protected abstract RenderPipeline? CreatePipeline();

    /// <summary>The next frame draws with a new pipeline.</summary>
    protected virtual void OnValidate() => RenderPipelineManager.Recreate(this);

    protected virtual void OnDisable() => RenderPipelineManager.Recreate(this);
}

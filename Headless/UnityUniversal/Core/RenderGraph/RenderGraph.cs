using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using UnityEngine.Rendering.RendererUtils;

namespace UnityEngine.Rendering.RenderGraphModule;

/// <summary>Passes that are recorded first and run in the same order, those of no effect left out.</summary>
/// <remarks>Passes are not merged and targets do not alias: a graph here is as slow as its passes one by one, and draws the same.</remarks>
public class RenderGraph
{
    private readonly List<GraphPass> passes = [];
    private readonly List<GraphTexture> textures = [];
    private RenderGraphParameters parameters;

    public RenderGraph(string name = "RenderGraph")
    {
        this.name = name;
        defaultResources = new RenderGraphDefaultResources(this);
    }

    public string name { get; }
    public bool nativeRenderPassesEnabled { get; set; }
    public RenderGraphDefaultResources defaultResources { get; }

    /// <summary>Names of the passes of the last graph that ran.</summary>
    internal IReadOnlyList<string> LastRun { get; private set; } = [];

    public void BeginRecording(in RenderGraphParameters parameters)
    {
        Forget();
        this.parameters = parameters;
    }

    public void EndRecordingAndExecute()
    {
        var run = new GraphRun(this, parameters);
        List<GraphPass> kept = Cull();
        try
        {
            foreach (GraphPass pass in kept)
            {
                run.Execute(pass);
            }
        }
        finally
        {
            LastRun = kept.ConvertAll(p => p.Name);
            Forget();
        }
    }

    public void EndFrame()
    {
    }

    public void Cleanup() => Forget();

    public TextureHandle ImportTexture(RTHandle rt) => ImportTexture(rt, default(ImportResourceParams));

    public TextureHandle ImportTexture(RTHandle rt, ImportResourceParams importParams)
    {
        TextureDesc desc = rt.rt != null ? new TextureDesc(rt.rt) : new TextureDesc(Math.Max(1, rt.externalTexture?.width ?? 1), Math.Max(1, rt.externalTexture?.height ?? 1));
        return Import(rt, desc, importParams);
    }

    public TextureHandle ImportTexture(RTHandle rt, RenderTargetInfo info, ImportResourceParams importParams = default) =>
        Import(rt, new TextureDesc(info.width, info.height) { format = info.format, slices = info.volumeDepth, msaaSamples = (MSAASamples)info.msaaSamples }, importParams);

    public TextureHandle ImportBackbuffer(RenderTargetIdentifier rt) => ImportTexture(RTHandles.Alloc(rt, "Backbuffer"), new RenderTargetInfo { width = Screen.width, height = Screen.height, volumeDepth = 1, msaaSamples = 1 });

    public TextureHandle CreateTexture(in TextureDesc desc)
    {
        if (desc.width <= 0 || desc.height <= 0)
        {
            throw new ArgumentException($"Texture '{desc.name}' was created with a size of {desc.width} x {desc.height}.");
        }

        return Register(new GraphTexture(desc, null));
    }

    public TextureHandle CreateTexture(TextureHandle texture) => CreateTexture(GetTextureDesc(texture));

    public void CreateTextureIfInvalid(in TextureDesc desc, ref TextureHandle texture)
    {
        if (!texture.IsValid())
        {
            texture = CreateTexture(desc);
        }
    }

    public TextureDesc GetTextureDesc(TextureHandle texture) =>
        texture.Texture?.Description ?? throw new ArgumentException("The texture handle is invalid: it is of another frame, or was never made.");

    public RenderTargetInfo GetRenderTargetInfo(TextureHandle texture)
    {
        TextureDesc desc = GetTextureDesc(texture);
        return new RenderTargetInfo
        {
            width = desc.width,
            height = desc.height,
            volumeDepth = desc.slices,
            msaaSamples = (int)desc.msaaSamples,
            format = desc.format,
            bindMS = desc.bindTextureMS,
        };
    }

    public RendererListHandle CreateRendererList(in RendererListParams desc)
    {
        RendererListParams copy = desc;
        return new RendererListHandle(parameters.scriptableRenderContext.CreateRendererList(ref copy));
    }

    public RendererListHandle CreateRendererList(in RendererListDesc desc) => new(parameters.scriptableRenderContext.CreateRendererList(desc));

    public RendererListHandle CreateShadowRendererList(ref ShadowDrawingSettings shadowDrawingSettings) =>
        new(parameters.scriptableRenderContext.CreateShadowRendererList(ref shadowDrawingSettings));

    public RendererListHandle CreateSkyboxRendererList(in Camera camera) => new(parameters.scriptableRenderContext.CreateSkyboxRendererList(camera));

    public RendererListHandle CreateSkyboxRendererList(in Camera camera, Matrix4x4 projectionMatrix, Matrix4x4 viewMatrix) =>
        new(parameters.scriptableRenderContext.CreateSkyboxRendererList(camera, projectionMatrix, viewMatrix));

    public IRasterRenderGraphBuilder AddRasterRenderPass<PassData>(
        string passName, out PassData passData, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
        where PassData : class, new() => Begin(passName, out passData);

    public IRasterRenderGraphBuilder AddRasterRenderPass<PassData>(
        string passName, out PassData passData, ProfilingSampler? sampler, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
        where PassData : class, new() => Begin(passName, out passData);

    public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(
        string passName, out PassData passData, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
        where PassData : class, new() => Begin(passName, out passData);

    public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(
        string passName, out PassData passData, ProfilingSampler? sampler, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
        where PassData : class, new() => Begin(passName, out passData);

    public IComputeRenderGraphBuilder AddComputePass<PassData>(
        string passName, out PassData passData, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
        where PassData : class, new() => Begin(passName, out passData);

    public IComputeRenderGraphBuilder AddComputePass<PassData>(
        string passName, out PassData passData, ProfilingSampler? sampler, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
        where PassData : class, new() => Begin(passName, out passData);

    internal void Add(GraphPass pass)
    {
        if (pass.Function is null)
        {
            throw new InvalidOperationException($"RenderGraph pass '{pass.Name}' was not provided with an execute function.");
        }

        passes.Add(pass);
    }

    private GraphBuilder Begin<PassData>(string passName, out PassData passData)
        where PassData : class, new()
    {
        passData = new PassData();
        return new GraphBuilder(this, new GraphPass(passName, passData));
    }

    private TextureHandle Import(RTHandle handle, TextureDesc desc, ImportResourceParams importParams)
    {
        (desc.name, desc.clearBuffer, desc.clearColor) = (handle.name, importParams.clearOnFirstUse, importParams.clearColor);
        return Register(new GraphTexture(desc, handle));
    }

    private TextureHandle Register(GraphTexture texture)
    {
        textures.Add(texture);
        return new TextureHandle(texture);
    }

    /// <summary>From the last pass back: what has no effect and writes nothing that a later pass reads is left out.</summary>
    private List<GraphPass> Cull()
    {
        var wanted = new HashSet<GraphTexture>();
        var ids = new HashSet<int>();
        bool allGlobals = false;
        var kept = new List<GraphPass>();
        foreach (GraphPass pass in Enumerable.Reverse(passes))
        {
            bool isRead = pass.Written.Exists(wanted.Contains) || pass.GlobalsAfter.Exists(g => allGlobals || ids.Contains(g.Id));
            if (!pass.HasEffect && !isRead)
            {
                continue;
            }

            kept.Add(pass);
            wanted.UnionWith(pass.Read);

            // Blending, and a depth test, read what was there.
            wanted.UnionWith(pass.Written.Where(t => t.IsTouched || passes.Exists(p => p != pass && p.Written.Contains(t))));
            wanted.UnionWith(pass.GlobalsAfter.Select(g => g.Texture));
            ids.UnionWith(pass.GlobalsRead);
            allGlobals |= pass.ReadsAllGlobals;
        }

        kept.Reverse();
        return kept;
    }

    private void Forget()
    {
        textures.ForEach(t => t.Release());
        textures.Clear();
        passes.Clear();
    }
}

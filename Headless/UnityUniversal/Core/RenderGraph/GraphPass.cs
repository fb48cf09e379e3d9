using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering.RenderGraphModule;

/// <summary>A recorded pass: what it reads and writes, and its function.</summary>
internal sealed class GraphPass(string name, object data)
{
    public string Name { get; } = name;
    public object Data { get; } = data;
    public List<GraphTexture> Read { get; } = [];
    public List<GraphTexture> Written { get; } = [];
    public List<Attachment> Colors { get; } = [];
    public Attachment? Depth { get; set; }
    public List<(GraphTexture Texture, int Id)> GlobalsAfter { get; } = [];
    public List<int> GlobalsRead { get; } = [];
    public bool ReadsAllGlobals { get; set; }
    public bool AllowsCulling { get; set; } = true;
    public bool AllowsGlobalState { get; set; }
    public Action<GraphRun>? Function { get; set; }

    /// <summary>What others see of the pass even where nobody reads its textures.</summary>
    public bool HasEffect => !AllowsCulling || AllowsGlobalState || Written.Exists(t => t.IsImported);

    public bool Uses(in TextureHandle handle) => handle.Texture is { } texture && (texture.IsImported || Read.Contains(texture) || Written.Contains(texture));

    public readonly record struct Attachment(GraphTexture Texture, int Index, AccessFlags Access, int Mip, int Slice);
}

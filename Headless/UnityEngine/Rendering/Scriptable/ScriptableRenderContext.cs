using System;
using System.Collections.Generic;
using Headless.Engine;
using Unity.Collections;
using UnityEngine.Rendering.RendererUtils;

namespace UnityEngine.Rendering;

/// <summary>What a pipeline records a frame into. Commands run in their order when Submit is called; what is never submitted is not drawn.</summary>
public struct ScriptableRenderContext : IEquatable<ScriptableRenderContext>
{
    private readonly ContextCommands? recorded;

    internal ScriptableRenderContext(ContextCommands commands) => recorded = commands;

    private readonly ContextCommands Commands => recorded is { IsOver: false } commands
        ? commands
        : throw new InvalidOperationException("The ScriptableRenderContext is not valid: it is used while RenderPipeline.Render runs.");

    public static bool operator ==(ScriptableRenderContext left, ScriptableRenderContext right) => left.Equals(right);

    public static bool operator !=(ScriptableRenderContext left, ScriptableRenderContext right) => !left.Equals(right);

    /// <summary>What a camera sees now: objects, lights and reflection probes.</summary>
    public readonly CullingResults Cull(ref ScriptableCullingParameters parameters)
    {
        _ = Commands;
        return new CullingResults(new CulledScene(parameters));
    }

    public readonly void Submit() => Commands.Submit();

    /// <summary>The commands are those of now: the buffer may be cleared afterwards.</summary>
    public readonly void ExecuteCommandBuffer(CommandBuffer commandBuffer)
    {
        ArgumentNullException.ThrowIfNull(commandBuffer);
        Commands.Add(commandBuffer.Snapshot());
    }

    public readonly void SetupCameraProperties(Camera camera, bool stereoSetup = false) => SetupCameraProperties(camera, stereoSetup, 0);

    /// <summary>The camera's render target, viewport and shader variables, as they are now.</summary>
    public readonly void SetupCameraProperties(Camera camera, bool stereoSetup, int eye) => Commands.Add(new SetupCameraCommand(camera));

    public readonly RendererList CreateRendererList(ref RendererListParams param) => param.cullingResults.Scene is { } scene
        ? new RendererList(new ObjectRendererList(Commands, scene, param))
        : RendererList.nullRendererList;

    public readonly RendererList CreateRendererList(RendererListDesc desc)
    {
        RendererListParams parameters = RendererListDesc.ConvertToParameters(desc);
        return CreateRendererList(ref parameters);
    }

    public readonly RendererList CreateShadowRendererList(ref ShadowDrawingSettings settings) => settings.cullingResults.Scene is { } scene
        ? new RendererList(new ShadowRendererList(Commands, scene, settings))
        : RendererList.nullRendererList;

    public readonly RendererList CreateSkyboxRendererList(Camera camera) =>
        CreateSkyboxRendererList(camera, camera.projectionMatrix, camera.worldToCameraMatrix);

    public readonly RendererList CreateSkyboxRendererList(Camera camera, Matrix4x4 projectionMatrix, Matrix4x4 viewMatrix) =>
        new(new SkyboxRendererList(Commands, camera, projectionMatrix, viewMatrix));

    public readonly void PrepareRendererListsAsync(List<RendererList> rendererLists) => rendererLists.ForEach(l => l.Content?.Prepare());

    public readonly RendererListStatus QueryRendererListStatus(RendererList rendererList) => rendererList switch
    {
        { isValid: false } => RendererListStatus.kRendererListInvalid,
        { Content.IsEmpty: true } => RendererListStatus.kRendererListEmpty,
        _ => RendererListStatus.kRendererListPopulated,
    };

    public readonly void DrawRenderers(CullingResults cullingResults, ref DrawingSettings drawingSettings, ref FilteringSettings filteringSettings) =>
        Draw(new RendererListParams(cullingResults, drawingSettings, filteringSettings));

    public readonly void DrawRenderers(
        CullingResults cullingResults, ref DrawingSettings drawingSettings, ref FilteringSettings filteringSettings, ref RenderStateBlock stateBlock) =>
        Draw(new RendererListParams(cullingResults, drawingSettings, filteringSettings)
        {
            tagValues = NativeMemoryOwner.Array<ShaderTagId>([default]),
            stateBlocks = NativeMemoryOwner.Array([stateBlock]),
        });

    public readonly void DrawRenderers(
        CullingResults cullingResults, ref DrawingSettings drawingSettings, ref FilteringSettings filteringSettings,
        NativeArray<ShaderTagId> renderTypes, NativeArray<RenderStateBlock> stateBlocks) =>
        DrawRenderers(cullingResults, ref drawingSettings, ref filteringSettings, new ShaderTagId("RenderType"), false, renderTypes, stateBlocks);

    public readonly void DrawRenderers(
        CullingResults cullingResults, ref DrawingSettings drawingSettings, ref FilteringSettings filteringSettings, ShaderTagId tagName, bool isPassTagName,
        NativeArray<ShaderTagId> tagValues, NativeArray<RenderStateBlock> stateBlocks) =>
        Draw(new RendererListParams(cullingResults, drawingSettings, filteringSettings)
        {
            tagName = tagName,
            isPassTagName = isPassTagName,
            tagValues = tagValues,
            stateBlocks = stateBlocks,
        });

    public readonly void DrawShadows(ref ShadowDrawingSettings settings) => Draw(CreateShadowRendererList(ref settings));

    public readonly void DrawSkybox(Camera camera) => Draw(CreateSkyboxRendererList(camera));

    /// <summary>Sends OnRenderObject to all scripts.</summary>
    public readonly void InvokeOnRenderObjectCallback() => Commands.Add(new ActionCommand(c => c.SendRenderObject()));

    public readonly bool Equals(ScriptableRenderContext other) => ReferenceEquals(recorded, other.recorded);

    public override readonly bool Equals(object? obj) => obj is ScriptableRenderContext other && Equals(other);

    public override readonly int GetHashCode() => recorded?.GetHashCode() ?? 0;

    private readonly void Draw(RendererListParams parameters) => Draw(CreateRendererList(ref parameters));

    private readonly void Draw(RendererList list) => Commands.Add(new DrawListCommand(list));
}

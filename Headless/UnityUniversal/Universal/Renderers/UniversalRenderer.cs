using System;
using System.Linq;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>Forward and Forward+: shadows, prepass where one is needed, opaques, sky, copies of depth and colour, transparents, the blit.</summary>
public sealed class UniversalRenderer : ScriptableRenderer
{
    private readonly UniversalRendererData settings;
    private readonly ForwardLights lights;
    private readonly MainLightShadowPass mainShadows = new();
    private readonly AdditionalLightsShadowPass additionalShadows = new();
    private readonly StackTargets stack = new();
    private bool isIntermediate;

    public UniversalRenderer(UniversalRendererData data)
        : base(data)
    {
        settings = data;
        lights = new ForwardLights(data.renderingMode == RenderingMode.ForwardPlus);
        if (data.renderingMode == RenderingMode.Deferred)
        {
            Debug.LogWarning($"Renderer '{data.name}': deferred rendering is not drawn here; objects are drawn forward.");
        }
    }

    public override int SupportedCameraStackingTypes() => (1 << (int)CameraRenderType.Base) | (1 << (int)CameraRenderType.Overlay);

    public override void SetupCullingParameters(ref ScriptableCullingParameters cullingParameters, ref CameraData cameraData)
    {
        if (cameraData.maxShadowDistance == 0f)
        {
            cullingParameters.cullingOptions &= ~CullingOptions.ShadowCasters;
        }

        cullingParameters.maximumVisibleLights = UniversalRenderPipeline.maxVisibleAdditionalLights + (lights.IsClustered ? 0 : 1);
        cullingParameters.shadowDistance = cameraData.maxShadowDistance;
    }

    internal override bool DrawsIntoTexture(UniversalCameraData camera) => isIntermediate || camera.targetTexture != null;

    internal override void Describe(UniversalRenderingData rendering)
    {
        rendering.renderingMode = lights.IsClustered ? RenderingMode.ForwardPlus : RenderingMode.Forward;
        (rendering.opaqueLayerMask, rendering.transparentLayerMask) = (settings.opaqueLayerMask, settings.transparentLayerMask);
    }

    internal override void Record(RenderGraph graph, ScriptableRenderContext context, ContextContainer frame)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        RenderingKeywords.RecordReset(graph);
        lights.Record(graph, frame);
        PassInputs inputs = PassInputs.Of(activeRenderPassQueue, camera);
        bool texturePrepass = inputs.Normals || (inputs.Depth && (!CanCopyDepth(camera) || inputs.EarliestDepth < RenderPassEvent.AfterRenderingOpaques));
        texturePrepass |= inputs.Depth && settings.copyDepthMode == CopyDepthMode.ForcePrepass;
        bool priming = settings.depthPrimingMode != DepthPrimingMode.Disabled && camera.cameraTargetDescriptor.msaaSamples == 1
            && (camera.renderType == CameraRenderType.Base || camera.clearDepth) && (!inputs.Depth || CanCopyDepth(camera));
        bool copiesDepth = inputs.Depth && (priming || !texturePrepass);
        if (camera.renderType == CameraRenderType.Base)
        {
            isIntermediate = NeedsIntermediate(camera, inputs) || copiesDepth;
        }

        Targets(graph, frame, inputs, texturePrepass && !priming);
        RecordEvents(graph, frame, RenderPassEvent.BeforeRendering, RenderPassEvent.BeforeRenderingShadows);
        CameraProperties.Record(graph, frame);
        RecordEvents(graph, frame, RenderPassEvent.BeforeRenderingShadows, RenderPassEvent.AfterRenderingShadows);
        bool shadowed = mainShadows.Record(graph, frame);
        shadowed |= additionalShadows.Record(graph, frame);
        if (shadowed)
        {
            CameraProperties.Record(graph, frame);
        }

        RecordEvents(graph, frame, RenderPassEvent.AfterRenderingShadows, RenderPassEvent.AfterRenderingPrePasses);
        if (texturePrepass || priming)
        {
            DepthPrepass.Record(graph, frame, priming ? resources.activeDepthTexture : resources.cameraDepthTexture, inputs.Normals, !priming);
        }

        RenderPassEvent copyAfter = !copiesDepth ? RenderPassEvent.AfterRendering : DepthCopyEvent(inputs);
        CopyDepthAt(RenderPassEvent.AfterRenderingPrePasses);
        RecordEvents(graph, frame, RenderPassEvent.AfterRenderingPrePasses, RenderPassEvent.AfterRenderingOpaques);
        ObjectsPass.RecordOpaque(graph, frame, priming);
        CopyDepthAt(RenderPassEvent.AfterRenderingOpaques);
        RecordEvents(graph, frame, RenderPassEvent.AfterRenderingOpaques, RenderPassEvent.AfterRenderingSkybox);
        if (camera.camera.clearFlags == CameraClearFlags.Skybox && camera.renderType != CameraRenderType.Overlay)
        {
            SkyboxPass.Record(graph, frame);
        }

        CopyDepthAt(RenderPassEvent.AfterRenderingSkybox);
        RecordEvents(graph, frame, RenderPassEvent.AfterRenderingSkybox, RenderPassEvent.BeforeRenderingTransparents);
        if (inputs.Color)
        {
            CopyColorPass.Record(graph, frame, UniversalRenderPipeline.asset!.opaqueDownsampling);
        }

        RecordEvents(graph, frame, RenderPassEvent.BeforeRenderingTransparents, RenderPassEvent.AfterRenderingTransparents);
        RenderingKeywords.RecordTransparent(graph, settings.shadowTransparentReceive);
        ObjectsPass.RecordTransparent(graph, frame);
        CopyDepthAt(RenderPassEvent.AfterRenderingTransparents);
        RecordEvents(graph, frame, RenderPassEvent.AfterRenderingTransparents, RenderPassEvent.BeforeRenderingPostProcessing);
        ObjectsPass.RecordRenderObject(graph, frame);
        RecordEvents(graph, frame, RenderPassEvent.BeforeRenderingPostProcessing, RenderPassEvent.AfterRendering);
        if (!resources.isActiveTargetBackBuffer && camera.resolveFinalTarget)
        {
            FinalBlitPass.Record(graph, frame);
        }

        RecordEvents(graph, frame, RenderPassEvent.AfterRendering, RenderPassEvent.AfterRendering + 1000);

        void CopyDepthAt(RenderPassEvent at)
        {
            if (copiesDepth && at == copyAfter)
            {
                CopyDepthPass.Record(graph, frame);
            }
        }
    }

    protected override void Dispose(bool disposing)
    {
        lights.Dispose();
        stack.Dispose();
    }

    private static bool CanCopyDepth(UniversalCameraData camera) =>
        camera.cameraTargetDescriptor.msaaSamples == 1 || SystemInfo.supportsMultisampledTextures != 0;

    private RenderPassEvent DepthCopyEvent(in PassInputs inputs)
    {
        RenderPassEvent earliest = inputs.EarliestDepth;
        if (inputs.DepthOfCamera && settings.copyDepthMode == CopyDepthMode.AfterOpaques && earliest > RenderPassEvent.AfterRenderingOpaques)
        {
            earliest = RenderPassEvent.AfterRenderingOpaques;
        }

        return earliest < RenderPassEvent.AfterRenderingOpaques ? RenderPassEvent.AfterRenderingPrePasses
            : earliest < RenderPassEvent.AfterRenderingSkybox ? RenderPassEvent.AfterRenderingOpaques
            : earliest < RenderPassEvent.AfterRenderingTransparents ? RenderPassEvent.AfterRenderingSkybox
            : RenderPassEvent.AfterRenderingTransparents;
    }

    private bool NeedsIntermediate(UniversalCameraData camera, in PassInputs inputs)
    {
        bool asked = rendererFeatures.Any(f => f.isActive) && settings.intermediateTextureMode == IntermediateTextureMode.Always;
        asked |= activeRenderPassQueue.Any(p => p.requiresIntermediateTexture);
        asked |= inputs.Color || !camera.resolveFinalTarget || !camera.isDefaultViewport || camera.cameraTargetDescriptor.msaaSamples > 1;
        return asked || ((camera.targetTexture == null || camera.xrRendering) && (camera.renderScale != 1f || camera.isHdrEnabled));
    }

    private void Targets(RenderGraph graph, ContextContainer frame, in PassInputs inputs, bool depthFormat)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalResourceData resources = frame.Get<UniversalResourceData>();
        bool isBase = camera.renderType == CameraRenderType.Base;
        BackBuffer.Import(graph, frame, isBase && !isIntermediate);
        resources.isActiveTargetBackBuffer = !isIntermediate;
        if (isIntermediate)
        {
            stack.Import(graph, frame, isBase, isBase || camera.clearDepth);
        }

        RenderTextureDescriptor desc = camera.cameraTargetDescriptor;
        if (inputs.Depth || inputs.Normals)
        {
            var depth = new TextureDesc(desc.width, desc.height)
            {
                slices = desc.volumeDepth,
                dimension = desc.dimension,
                format = depthFormat ? GraphicsFormat.D32_SFloat : GraphicsFormat.R32_SFloat,
                name = "_CameraDepthTexture",
                clearBuffer = true,
                clearColor = Color.clear,
            };
            resources.cameraDepthTexture = graph.CreateTexture(depth);
        }

        if (inputs.Normals)
        {
            resources.cameraNormalsTexture = graph.CreateTexture(new TextureDesc(desc.width, desc.height)
            {
                slices = desc.volumeDepth,
                dimension = desc.dimension,
                format = GraphicsFormat.R16G16B16A16_SFloat,
                name = "_CameraNormalsTexture",
                clearBuffer = true,
                clearColor = Color.clear,
            });
        }
    }
}

using System.Collections.Generic;
using System.Linq;
using Headless.Shaders;
using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Records single draws: pass variant, pipeline, bindings and geometry.</summary>
internal static class Drawer
{
    private static readonly Dictionary<PipelineKey, GpuRenderPipeline> Pipelines = [];
    private static readonly PropertySheet PerDraw = new();
    private static readonly HashSet<(string, string)> Reported = [];

    /// <summary>Triangles count as front-facing with the other winding: GL.invertCulling.</summary>
    public static bool InvertCulling { get; set; }

    /// <summary>Units and slope that are added to every pass's Offset.</summary>
    public static (float Units, float Slope) DepthBias { get; set; }

    public static void Draw(Material material, int passIndex, PropertySheet? block, DrawGeometry geometry, in Matrix4x4 matrix)
    {
        if (material == null || TargetState.Current is null || !geometry.Prepare())
        {
            return;
        }

        IReadOnlyList<PassProgram> passes = material.Usable.Programs.Passes;
        if (passIndex < 0)
        {
            for (int i = 0; i < passes.Count; i++)
            {
                DrawPass(material, passes[i], block, geometry, matrix);
            }
        }
        else if (passIndex < passes.Count)
        {
            DrawPass(material, passes[passIndex], block, geometry, matrix);
        }
        else
        {
            Debug.LogError($"Material '{material.name}' with shader '{material.shader.name}' has {passes.Count} passes; there is none with index {passIndex}.");
        }
    }

    public static void DrawPass(Material material, PassProgram pass, PropertySheet? block, DrawGeometry geometry, in Matrix4x4 matrix) =>
        DrawPass(material, material.shader.Programs, pass, block, geometry, matrix, null);

    /// <param name="programs">Whose defaults stand for properties that the material does not set.</param>
    /// <param name="overrides">Takes the place of the pass's own state.</param>
    public static void DrawPass(
        Material material, ShaderProgramSet programs, PassProgram pass, PropertySheet? block, DrawGeometry geometry, in Matrix4x4 matrix,
        UnityEngine.Rendering.RenderStateBlock? overrides)
    {
        if (LayeredDraws.AreOn)
        {
            DrawLayered(material, programs, pass, block, geometry, matrix, overrides);
        }
        else
        {
            DrawPass(material, programs, pass, block, geometry, matrix, overrides, 1);
        }
    }

    private static void DrawLayered(
        Material material, ShaderProgramSet programs, PassProgram pass, PropertySheet? block, DrawGeometry geometry, Matrix4x4 matrix,
        UnityEngine.Rendering.RenderStateBlock? overrides) =>
        LayeredDraws.Draw(pass, copies => DrawPass(material, programs, pass, block, geometry, matrix, overrides, copies));

    private static void DrawPass(
        Material material, ShaderProgramSet programs, PassProgram pass, PropertySheet? block, DrawGeometry geometry, in Matrix4x4 matrix,
        UnityEngine.Rendering.RenderStateBlock? overrides, int copies)
    {
        PassVariant? variant = pass.Variant(material.Keywords.Set);
        if (variant is null)
        {
            Material error = ErrorMaterial.Instance;
            if (material != error && geometry.Mesh is not null)
            {
                Draw(error, 0, null, geometry, matrix);
            }

            return;
        }

        SetObject(matrix);
        var chain = new PropertyChain(block, material, programs, PerDraw);
        ResourceBindings bindings = variant.Bindings;
        UnsetProperties.ReadBy(pass);
        foreach (BindingTable table in variant.Tables)
        {
            if (!StageBinder.Bind(table, chain, bindings, out string? problem))
            {
                Report(material, pass, problem!);
                return;
            }
        }

        PassState state = PassState.Of(pass.Source.State, chain).With(overrides).Offset(DepthBias);
        GpuRenderPipeline pipeline = Pipeline(variant, pass, state, geometry, matrix);
        VertexBinding.Prepare();
        TargetState.Begin();
        VertexBinding.SetBuffers(GraphicsDevice.Recorder, variant, geometry.Mesh);
        geometry.Record(GraphicsDevice.Recorder, pipeline, bindings, copies);
    }

    public static void Reset()
    {
        Pipelines.Clear();
        Reported.Clear();
        TargetState.Reset();
        VertexBinding.Reset();
        QuadIndices.Reset();
        ErrorMaterial.Reset();
    }

    private static void SetObject(in Matrix4x4 matrix)
    {
        PerDraw.SetMatrix(BuiltinNames.ObjectToWorld, matrix);
        PerDraw.SetMatrix(BuiltinNames.WorldToObject, matrix.inverse);
        PerDraw.SetVector(BuiltinNames.WorldTransformParams, new Vector4(0f, 0f, 0f, matrix.determinant < 0f ? -1f : 1f));
        PerDraw.SetVector(BuiltinNames.LodFade, new Vector4(1f, 1f, 0f, 0f));
    }

    private static GpuRenderPipeline Pipeline(PassVariant variant, PassProgram pass, PassState state, DrawGeometry geometry, in Matrix4x4 matrix)
    {
        DrawTarget target = TargetState.Current!;
        bool clockwise = !(target.Flipped ^ InvertCulling ^ (matrix.determinant < 0f));
        string layout = variant.Inputs.Count == 0 ? string.Empty : VertexBinding.Key(geometry.Mesh);
        var key = new PipelineKey(
            variant, state, DrawGeometry.Convert(geometry.Topology), layout, clockwise,
            target.Colors.Length > 0 ? target.Colors[0].Description.Format : GpuFormat.None,
            target.Colors.Length > 1 ? target.Colors[1].Description.Format : GpuFormat.None,
            target.Colors.Length, target.DepthFormat, target.Samples);
        if (Pipelines.TryGetValue(key, out GpuRenderPipeline? pipeline))
        {
            return pipeline;
        }

        (VertexStream[] streams, VertexAttribute[] attributes) = VertexBinding.Describe(variant, geometry.Mesh);
        bool hasDepth = target.Depth is not null;
        pipeline = GraphicsDevice.Device.GetRenderPipeline(new RenderPipelineDescription
        {
            Stages = variant.Stages,
            Name = $"{pass.Source.ShaderName} {pass.Source.Name}",
            Topology = key.Topology,
            Streams = streams,
            Attributes = attributes,
            ColorFormats = [.. target.Colors.Select(c => c.Description.Format)],
            DepthFormat = target.DepthFormat,
            Samples = target.Samples,
            Cull = (GpuCull)state.Cull,
            FrontClockwise = clockwise,
            DepthCompare = hasDepth ? state.DepthCompare : GpuCompare.Always,
            DepthWrite = hasDepth && state.ZWrite,
            DepthClip = state.ZClip,

            // Reversed depth: what moves a surface away from the viewer makes its depth smaller.
            DepthBiasSlope = -state.OffsetFactor,
            DepthBiasUnits = -state.OffsetUnits,
            Blend = [state.ToBlendState()],
            AlphaToCoverage = state.AlphaToMask && target.Samples > 1,
        });
        Pipelines.Add(key, pipeline);
        return pipeline;
    }

    private static void Report(Material material, PassProgram pass, string problem)
    {
        if (Reported.Add((material.shader.name, problem)))
        {
            Debug.LogError($"Shader \"{material.shader.name}\" (material '{material.name}', pass '{pass.Source.Name}') {problem}");
        }
    }
}

using System;
using SphFluid.Laboratory;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// The picture that drawings of the benchmark go to, with its camera and light, and the particles: recorded into the same command
    /// buffer as the step, so that nothing else of a game's frame is measured.
    /// </summary>
    internal sealed class BenchDrawing : IDisposable
    {
        /// <summary>Width and height of the picture.</summary>
        public static readonly Vector2Int Size = new Vector2Int(1280, 720);

        /// <summary>Iso value of every surface with the thesis's field.</summary>
        public const float IsoValue = 0.5f;

        /// <summary>Smoothness of every surface.</summary>
        public const float Smoothness = 0.75f;

        /// <summary>Colour of every drawing.</summary>
        public static readonly Color Colour = new Color(0.06f, 0.4f, 0.66f);

        private const float Near = 0.1f;
        private const float Far = 10f;
        private const float SquareSize = 1.2f; // as FluidParticleRenderer's default

        private static readonly ProfilerMarker ParticlesMarker = GpuLaboratory.CreateMarker(FrameBlocks.DrawParticles);
        private static readonly ProfilerMarker SurfaceMarker = GpuLaboratory.CreateMarker(FrameBlocks.DrawSurface);
        private static readonly ProfilerMarker ThicknessMarker = GpuLaboratory.CreateMarker(FrameBlocks.DrawThickness);
        private static readonly ProfilerMarker SprayMarker = GpuLaboratory.CreateMarker(FrameBlocks.DrawSpray);
        private static readonly int ProjectionParameters = Shader.PropertyToID("_ProjectionParams");
        private static readonly int DepthParameters = Shader.PropertyToID("_ZBufferParams");
        private static readonly Vector3 Eye = new Vector3(1f, 0.7f, -1.6f);
        private static readonly int CameraPosition = Shader.PropertyToID("_WorldSpaceCameraPos");
        private static readonly int LightDirection = Shader.PropertyToID("_WorldSpaceLightPos0");
        private static readonly int LightColour = Shader.PropertyToID("_LightColor0");

        private readonly Matrix4x4 view;
        private readonly Matrix4x4 projection;
        private readonly MeasuredParticles particles;
        private RenderTexture target;
        private BenchBackdrop backdrop;

        public BenchDrawing(FluidShaderSet shaders, Vector2Int size)
        {
            projection = Matrix4x4.Perspective(45f, (float)size.x / size.y, Near, Far);
            // Unity's view matrix looks down -z.
            Quaternion rotation = Quaternion.LookRotation(-Eye, Vector3.up);
            view = Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Matrix4x4.TRS(Eye, rotation, Vector3.one).inverse;
            particles = new MeasuredParticles(shaders);
            target = new RenderTexture(size.x, size.y, 24) { name = "SPH Fluid benchmark", hideFlags = HideFlags.HideAndDontSave };
            target.Create();
        }

        /// <summary>The picture drawn last.</summary>
        public RenderTexture Target => target;

        /// <summary>What clear water is drawn before.</summary>
        public BenchBackdrop Backdrop => backdrop ??
            (backdrop = new BenchBackdrop(view, projection, Near, Far, -0.5f * BenchLiquid.Edge, target.width, target.height));

        /// <summary>Records how much water lies behind each pixel.</summary>
        public void RecordThickness(CommandBuffer cmd, MeasuredWater water)
        {
            cmd.BeginSample(ThicknessMarker);
            SetView(cmd);
            water.RecordThickness(cmd, view, projection);
            cmd.EndSample(ThicknessMarker);
        }

        /// <summary>Records the spray that is seen through the water.</summary>
        public void RecordSprayBehind(CommandBuffer cmd, MeasuredWater water)
        {
            cmd.BeginSample(SprayMarker);
            cmd.SetRenderTarget(backdrop.Colour);
            SetView(cmd);
            water.RecordSprayBehind(cmd);
            cmd.EndSample(SprayMarker);
        }

        /// <summary>Records the spray over the water.</summary>
        public void RecordSpray(CommandBuffer cmd, MeasuredWater water)
        {
            cmd.BeginSample(SprayMarker);
            water.RecordSpray(cmd);
            cmd.EndSample(SprayMarker);
        }

        public void RecordParticles(CommandBuffer cmd, FluidSolver solver)
        {
            cmd.BeginSample(ParticlesMarker);
            Begin(cmd);
            particles.Record(cmd, solver, SquareSize * solver.Settings.Spacing, Colour, 0.4f);
            cmd.EndSample(ParticlesMarker);
        }

        /// <summary>Before the drawing of a surface: an empty picture.</summary>
        public void BeginSurface(CommandBuffer cmd)
        {
            cmd.BeginSample(SurfaceMarker);
            Begin(cmd);
        }

        /// <summary>Behind the drawing of a surface.</summary>
        public void EndSurface(CommandBuffer cmd) => cmd.EndSample(SurfaceMarker);

        public void Dispose()
        {
            particles.Dispose();
            backdrop?.Dispose();
            if (target == null) return;
            target.Release();
            UnityEngine.Object.DestroyImmediate(target);
            target = null;
        }

        private void Begin(CommandBuffer cmd)
        {
            cmd.SetRenderTarget(target);
            cmd.ClearRenderTarget(true, true, Color.black);
            SetView(cmd);
        }

        private void SetView(CommandBuffer cmd)
        {
            cmd.SetViewProjectionMatrices(view, projection);
            cmd.SetGlobalVector(ProjectionParameters, new Vector4(-1f, Near, Far, 1f / Far));
            cmd.SetGlobalVector(DepthParameters, BenchBackdrop.BufferParameters(Near, Far));
            cmd.SetGlobalVector(CameraPosition, Eye);
            cmd.SetGlobalVector(LightDirection, new Vector3(0.4f, 0.8f, -0.45f).normalized);
            cmd.SetGlobalVector(LightColour, Vector4.one);
        }
    }
}

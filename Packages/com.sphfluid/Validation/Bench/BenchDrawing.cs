using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// Draws the liquid as the components do, with their materials, into a picture of its own: into the same command buffer as the
    /// step, so that nothing else of a game's frame is measured.
    /// </summary>
    sealed class BenchDrawing : IDisposable
    {
        public const int Width = 1280;
        public const int Height = 720;

        const int ForwardPass = 0;
        const float IsoValue = 0.5f;
        const float SquareSize = 1.2f; // as FluidParticleRenderer's default

        static readonly ProfilerMarker ParticlesMarker = ComputeKernel.CreateMarker(BenchBlocks.DrawParticles);
        static readonly ProfilerMarker SurfaceMarker = ComputeKernel.CreateMarker(BenchBlocks.DrawSurface);
        static readonly Color Colour = new Color(0.06f, 0.4f, 0.66f);
        static readonly Vector3 Eye = new Vector3(1f, 0.7f, -1.6f);
        static readonly int CameraPosition = Shader.PropertyToID("_WorldSpaceCameraPos");
        static readonly int LightDirection = Shader.PropertyToID("_WorldSpaceLightPos0");
        static readonly int LightColour = Shader.PropertyToID("_LightColor0");

        readonly DrawPlacement placement = new DrawPlacement(Matrix4x4.identity, Vector3.one * BenchLiquid.Edge, 0f, 0, false);
        readonly Matrix4x4 view;
        readonly Matrix4x4 projection = Matrix4x4.Perspective(45f, (float)Width / Height, 0.1f, 10f);
        readonly ParticleSquares squares;
        readonly GeometrySurface surface;
        RenderTexture target;

        public BenchDrawing(FluidShaderSet shaders)
        {
            // Unity's view matrix looks down -z.
            Quaternion rotation = Quaternion.LookRotation(-Eye, Vector3.up);
            view = Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Matrix4x4.TRS(Eye, rotation, Vector3.one).inverse;
            squares = new ParticleSquares(shaders);
            surface = GeometrySurface.MissingSupport() == null ? new GeometrySurface(shaders) : null;
            target = new RenderTexture(Width, Height, 24) { name = "SPH Fluid benchmark", hideFlags = HideFlags.HideAndDontSave };
            target.Create();
        }

        /// <summary>Whether the device has geometry shaders.</summary>
        public bool HasSurface => surface != null;

        /// <summary>The picture drawn last.</summary>
        public RenderTexture Target => target;

        public void RecordParticles(CommandBuffer cmd, FluidSolver solver)
        {
            var look = new ParticleLook { Size = SquareSize * solver.Settings.Spacing, Colour = Colour, FastColour = Colour, Smoothness = 0.4f };
            cmd.BeginSample(ParticlesMarker);
            Begin(cmd);
            cmd.DrawProcedural(Matrix4x4.identity, squares.Material, ForwardPass, MeshTopology.Triangles,
                solver.ParticleCount * ParticleSquares.VerticesPerParticle, 1, squares.Properties(solver.Particles, look, placement));
            cmd.EndSample(ParticlesMarker);
        }

        public void RecordSurface(CommandBuffer cmd, SurfaceField field)
        {
            cmd.BeginSample(SurfaceMarker);
            Begin(cmd);
            cmd.DrawProcedural(Matrix4x4.identity, surface.Material, ForwardPass, MeshTopology.Points, field.Grid.CubeCount, 1,
                surface.Properties(field, IsoValue, Colour, 0.75f, placement));
            cmd.EndSample(SurfaceMarker);
        }

        public void Dispose()
        {
            squares.Dispose();
            surface?.Dispose();
            if (target != null)
                target.Release();
            DrawMaterial.Destroy(ref target);
        }

        void Begin(CommandBuffer cmd)
        {
            cmd.SetRenderTarget(target);
            cmd.ClearRenderTarget(true, true, Color.black);
            cmd.SetViewProjectionMatrices(view, projection);
            cmd.SetGlobalVector(CameraPosition, Eye);
            cmd.SetGlobalVector(LightDirection, new Vector3(0.4f, 0.8f, -0.45f).normalized);
            cmd.SetGlobalVector(LightColour, Vector4.one);
        }
    }
}

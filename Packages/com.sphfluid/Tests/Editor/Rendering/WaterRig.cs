using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Water of known shape, drawn by a parallel camera before a scene of known colours and depths.</summary>
    internal sealed class WaterRig : IDisposable
    {
        public const int Size = 64;
        public const float HalfWidth = 0.5f;
        public const float Near = 0.1f;
        public const float Far = 10f;

        /// <summary>Of the camera from the origin, in metres.</summary>
        public const float Distance = 2f;

        public const float Spacing = 0.025f;

        public const int ForwardPass = 0;
        public const int ShadowPass = 1;

        /// <summary>Half the width of what the camera sees a metre before it, where it is not a parallel one.</summary>
        public const float HalfAngle = 0.12f;

        private readonly WaterDrawing water = new WaterDrawing(SurfaceTestScene.LoadShaders());
        private Vector3 eye = new Vector3(0f, 0f, -Distance);
        private UploadedSurface surface;
        private Texture2D depth;

        public WaterRig()
        {
            Scene = NewTexture((x, y) => new Color(0.7f, 0.5f, 0.3f));
            depth = NewTexture((x, y) => Color.clear);
        }

        public FluidWaterLook Look
        {
            get;
        } = new FluidWaterLook { ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f), Visibility = 8f, Refraction = 1f };

        /// <summary>The picture behind the water.</summary>
        public Texture2D Scene { get; private set; }

        /// <summary>The domain: walls and the cells of its grid, 64 an edge.</summary>
        public Bounds Domain { get; set; } = new Bounds(Vector3.zero, Vector3.one * 4f);

        /// <summary>Whether what is far away is small.</summary>
        public bool Perspective { get; set; }

        /// <summary>Where the camera is; it looks at the origin.</summary>
        public Vector3 Eye { get => eye; set => eye = value; }

        public UploadedSurface Surface
        {
            set
            {
                surface?.Dispose();
                surface = value;
            }
        }

        /// <summary>A box of water 4 m wide and high.</summary>
        public void Box(float thickness) => Surface = new UploadedSurface().Box(Vector3.zero, new Vector3(4f, 4f, thickness));

        /// <summary>0.4 m of water whose front has another normal than its shape.</summary>
        public void Slope(Vector3 normal)
        {
            Surface = new UploadedSurface()
                .Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 2f, Vector3.right * 2f, normal)
                .Quad(new Vector3(0f, 0f, 0.2f), Vector3.right * 2f, Vector3.up * 2f, Vector3.forward);
        }

        /// <summary>Clear water, and a picture that tells where on it one looks: red grows from left to right, green upwards.</summary>
        public void ShowPlaces()
        {
            ReplaceScene((x, y) => new Color((x + 0.5f) / Size, (y + 0.5f) / Size, 0f));
            Look.ColorAtOneMetre = Color.white;
            Look.Visibility = 1e6f;
        }

        public void ReplaceScene(Func<int, int, Color> colour)
        {
            Object.DestroyImmediate(Scene);
            Scene = NewTexture(colour);
        }

        /// <summary>Metres from the camera as a depth texture holds them.</summary>
        public void SetDepth(Func<int, int, float> metres)
        {
            Object.DestroyImmediate(depth);
            depth = NewTexture((x, y) =>
            {
                float between = Perspective ? (1f / Near - 1f / metres(x, y)) / (1f / Near - 1f / Far)
                    : (metres(x, y) - Near) / (Far - Near);
                return new Color(SystemInfo.usesReversedZBuffer ? 1f - between : between, 0f, 0f);
            });
        }

        /// <summary>Draws the water.</summary>
        /// <param name="change">Changes the properties before the draw.</param>
        /// <param name="pass">Of the water's shader.</param>
        /// <param name="background">What the picture is cleared to.</param>
        /// <param name="fromWithin">Whether the camera is in the water.</param>
        public Color[] Render(Action<MaterialPropertyBlock> change = null, int pass = ForwardPass, Color background = default,
            bool fromWithin = false)
        {
            SurfaceBuffers buffers = surface.Buffers;
            MaterialPropertyBlock block = Fill(buffers);
            block.SetVector("_FluidLightDirection", Vector3.up);
            block.SetVector("_FluidLightColour", Vector4.zero);
            block.SetVectorArray("_FluidAmbient", new Vector4[7]);
            block.SetVector("_FluidReflection", Vector4.zero);
            block.SetTexture("_FluidSceneColour", Scene);
            change?.Invoke(block);
            Material material = fromWithin ? water.Within : water.Material;
            return Draw(cmd =>
            {
                cmd.ClearRenderTarget(false, true, background);
                cmd.DrawProceduralIndirect(buffers.Indices, Matrix4x4.identity, material, pass, MeshTopology.Triangles,
                    buffers.Arguments, 0, block);
            });
        }

        /// <summary>What caustics multiply the scene by, 1 where they leave it as it is.</summary>
        /// <param name="toLight">Direction to the main light.</param>
        /// <param name="light">Its colour.</param>
        public Color[] RenderCaustics(Vector3 toLight, Color light)
        {
            MaterialPropertyBlock block = Fill(surface.Buffers);
            block.SetVector("_FluidLightDirection", toLight.normalized);
            block.SetVector("_FluidLightColour", light);
            block.SetVectorArray("_FluidAmbient", new Vector4[7]);
            GpuTest.Run(water.Caustics.RecordMap);
            return Draw(cmd =>
            {
                cmd.ClearRenderTarget(false, true, Color.white);
                water.Caustics.Record(cmd);
            });
        }

        /// <summary>Draws one particle of spray alone, a picture of whose drops is the colour that is left of nothing.</summary>
        /// <param name="position">Where it is.</param>
        /// <param name="spacing">dx, which its drops are spread over [m].</param>
        /// <param name="behind">Into the picture that the water refracts, instead of after the water.</param>
        /// <param name="drops">How many; the first is mist.</param>
        public Color[] RenderSpray(Vector3 position, float spacing, bool behind, int drops = 14)
        {
            DrawPlacement placement = Placement;
            water.Thickness.Prepare(surface.Buffers, placement, Vector2Int.one * Size, false);
            using (var particle = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1, 32))
            using (GraphicsBuffer arguments = GpuBuffers.CreateArguments("Arguments", 4))
            {
                particle.SetData(new[] { position.x, position.y, position.z, 1f, 0f, 0f, 0f, 0f });
                arguments.SetData(new[] { (uint)(drops * SprayBuffers.VerticesPerDrop), 1u, 0u, 0u });
                water.Spray.Prepare(new SprayBuffers(particle, arguments, drops, spacing), Look, placement, water.Thickness);
                return Draw(cmd =>
                {
                    cmd.SetGlobalVector("_FluidScene", new SceneTextures(SceneColourSource.Copy, true).ToVector());
                    cmd.SetGlobalVector("_FluidThicknessView", new Vector4(Size, Size, 0f, 0f));
                    cmd.SetGlobalTexture("_CameraDepthTexture", depth);
                    cmd.SetGlobalFloat("_FluidSceneHeight", Size);
                    if (behind)
                        water.Spray.RecordBehindWater(cmd, 0);
                    else
                        water.Spray.RecordAfterWater(cmd);
                });
            }
        }

        private MaterialPropertyBlock Fill(in SurfaceBuffers buffers)
        {
            DrawPlacement placement = Placement;
            water.Fill(buffers, new SurfaceGrid(Domain.min, Domain.size, 64), SurfaceWalls.Closed, placement);
            water.SetLook(buffers, Look, Vector2Int.one * Size, placement);
            water.SetSurface(Look);
            MaterialPropertyBlock block = water.Block;
            block.SetVector("_FluidScene", new SceneTextures(SceneColourSource.Copy, true).ToVector());
            block.SetVector("_FluidThicknessView", new Vector4(Size, Size, 0f, 0f));
            block.SetTexture("_CameraDepthTexture", depth);
            return block;
        }

        private DrawPlacement Placement => new DrawPlacement(Matrix4x4.identity, Domain.size, 0f, 0, false, false, Spacing);

        private Color[] Draw(Action<CommandBuffer> record)
        {
            Matrix4x4 view = SurfaceTestScene.LookAtOrigin(eye);
            const float near = HalfAngle * Near;
            Matrix4x4 projection = Perspective ? Matrix4x4.Frustum(-near, near, -near, near, Near, Far)
                : Matrix4x4.Ortho(-HalfWidth, HalfWidth, -HalfWidth, HalfWidth, Near, Far);
            GpuTest.Run(cmd => water.Thickness.Record(cmd, new CameraViews(view, projection), Vector2Int.one * Size));
            return SurfaceTestScene.Render(Size, view, projection, cmd =>
            {
                bool reversed = SystemInfo.usesReversedZBuffer;
                float first = 1f / Near, last = 1f / Far;
                cmd.SetGlobalVector("_WorldSpaceCameraPos", eye);
                cmd.SetGlobalVector("_ProjectionParams", new Vector4(-1f, Near, Far, 1f / Far));
                cmd.SetGlobalVector("_ZBufferParams", new Vector4(0f, 0f, reversed ? first - last : last - first, reversed ? last : first));
                cmd.SetGlobalVector("unity_OrthoParams", new Vector4(HalfWidth, HalfWidth, 0f, Perspective ? 0f : 1f));
                record(cmd);
            });
        }

        public static Color Centre(Color[] picture) => picture[Size / 2 * Size + Size / 2];

        public void Dispose()
        {
            water.Dispose();
            surface?.Dispose();
            Object.DestroyImmediate(Scene);
            Object.DestroyImmediate(depth);
        }

        private static Texture2D NewTexture(Func<int, int, Color> colour)
        {
            var made = new Texture2D(Size, Size, TextureFormat.RGBAFloat, false, true) { wrapMode = TextureWrapMode.Clamp };
            for (int i = 0; i < Size * Size; i++) made.SetPixel(i % Size, i / Size, colour(i % Size, i / Size));
            made.Apply();
            return made;
        }
    }
}

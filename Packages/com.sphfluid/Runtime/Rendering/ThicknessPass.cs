using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// How much water lies behind each pixel of a camera: the closed surface drawn with additive blending into a texture of four half
    /// floats, Shaders/Rendering/WaterThickness.hlsl. One texture serves all cameras of a frame, one after the other; smaller ones fill its
    /// lower left part.
    /// </summary>
    internal sealed class ThicknessPass : IDisposable
    {
        private const RenderTextureFormat Format = RenderTextureFormat.ARGBHalf;

        // Alpha where no far face is; Shaders/Rendering/WaterThickness.hlsl.
        private const float NoFarFace = -1000f;

        private readonly MaterialPropertyBlock block = new MaterialPropertyBlock();
        private Material material;
        private RenderTexture texture;
        private RenderTexture eyes;
        private SurfaceBuffers surface;
        private int divisor = 1;
        private int preparedAt = -1;
        private Matrix4x4 localToWorld;
        private Bounds bounds;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot blend half floats.</exception>
        public ThicknessPass(FluidShaderSet shaders)
        {
            if (!SystemInfo.SupportsRenderTextureFormat(Format) || !SystemInfo.SupportsBlendingOnRenderTextureFormat(Format))
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) cannot add up half floats in a picture, which " +
                    "the water look needs. " +
                    "Choose the opaque look.");
            }
            material = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Water Thickness");
        }

        /// <summary>Red: sum of far depths minus sum of near ones [m]; green: number of far faces minus number of near ones;
        /// alpha: minus the depth of the nearest far face [m].</summary>
        public RenderTexture Texture => texture;

        /// <summary>The same of both eyes, in two slices, once a camera has drawn both at once; else null.</summary>
        public RenderTexture Eyes => eyes;

        /// <summary>The last frame in which a camera that drew the liquid was near it, <see cref="IsNear"/>.</summary>
        public int NearAt { get; set; } = -1;

        /// <summary>Layer of the liquid: cameras that do not see it are skipped.</summary>
        public int Layer { get; private set; }

        /// <summary>Takes the surface of this frame and makes the texture as large as the largest view asks.</summary>
        /// <param name="drawn">The surface.</param>
        /// <param name="placement">Where it is.</param>
        /// <param name="largestView">Pixels of the largest picture that will be asked for.</param>
        /// <param name="halfResolution">Whether four pixels of a picture share one of the texture.</param>
        public void Prepare(in SurfaceBuffers drawn, in DrawPlacement placement, Vector2Int largestView, bool halfResolution)
        {
            surface = drawn;
            preparedAt = Time.frameCount;
            Layer = placement.Layer;
            bounds = placement.WorldBounds;
            localToWorld = placement.LocalToWorld;
            divisor = halfResolution ? 2 : 1;
            DrawPipeline.Prepare(material, placement.Pipeline);
            block.SetBuffer(SurfaceBuffers.VerticesId, surface.Vertices);
            block.SetMatrix(RenderShaderIds.FluidLocalToWorld, placement.LocalToWorld);
            Fit(ref texture, ViewSize(largestView), 1);
            if (eyes != null || EyeDraws.Begin() > 1) Fit(ref eyes, ViewSize(largestView), 2);
        }

        /// <summary>Sets the texture for the draw that reads it.</summary>
        public void Apply(MaterialPropertyBlock properties)
        {
            properties.SetTexture(RenderShaderIds.FluidThickness, texture);
            if (eyes != null) properties.SetTexture(RenderShaderIds.FluidThicknessEyes, eyes);
            properties.SetVector(RenderShaderIds.FluidThicknessSize, new Vector4(texture.width, texture.height, divisor, 0f));
        }

        /// <summary>Sets the texture of no water, for a draw that reads it where there may be none.</summary>
        public static void ApplyNone(MaterialPropertyBlock properties)
        {
            properties.SetTexture(RenderShaderIds.FluidThickness, Texture2D.blackTexture);
            properties.SetVector(RenderShaderIds.FluidThicknessSize, Vector4.one);
        }

        /// <summary>Whether it is that of this frame's water in the domain of a drawing.</summary>
        public bool IsOf(in DrawPlacement placement) => preparedAt == Time.frameCount && localToWorld == placement.LocalToWorld;

        /// <summary>Whether a camera may show the liquid.</summary>
        public bool IsSeenBy(Camera camera) => (camera.cullingMask & (1 << Layer)) != 0 && new ViewVolume(camera).Touches(bounds);

        /// <summary>Whether a camera may be in the liquid: its near plane reaches the box around the domain.</summary>
        public bool IsNear(Camera camera)
        {
            float reach = 2f * camera.nearClipPlane;
            return bounds.SqrDistance(camera.transform.position) <= reach * reach;
        }

        /// <summary>Records the thickness as one camera sees it; nothing if no surface was given in this frame.</summary>
        /// <param name="cmd">Where it is recorded.</param>
        /// <param name="views">The matrices that it draws with.</param>
        /// <param name="size">Pixels of the camera's picture.</param>
        public void Record(CommandBuffer cmd, in CameraViews views, Vector2Int size)
        {
            if (preparedAt != Time.frameCount) return;
            if (views.Count == 1)
            {
                Record(cmd, texture, views.View(0), views.Projection(0), size);
                return;
            }
            if (eyes == null) Fit(ref eyes, new Vector2Int(texture.width, texture.height), views.Count);
            for (int eye = 0; eye < views.Count; eye++)
            {
                var slice = new RenderTargetIdentifier(eyes, 0, CubemapFace.Unknown, eye);
                Record(cmd, slice, views.View(eye), views.Projection(eye), size);
            }
        }

        private void Record(CommandBuffer cmd, RenderTargetIdentifier target, Matrix4x4 view, Matrix4x4 projection, Vector2Int size)
        {
            Vector2Int part = ViewSize(size);
            cmd.SetRenderTarget(target);
            cmd.ClearRenderTarget(false, true, new Color(0f, 0f, 0f, NoFarFace));
            cmd.SetViewport(new Rect(0f, 0f, Mathf.Min(part.x, texture.width), Mathf.Min(part.y, texture.height)));
            cmd.SetViewProjectionMatrices(view, projection);
            cmd.DrawProceduralIndirect(surface.Indices, Matrix4x4.identity, material, 0, MeshTopology.Triangles,
                surface.Arguments, 0, block);
        }

        public void Dispose()
        {
            OwnedObject.Destroy(ref material);
            Release(ref texture);
            Release(ref eyes);
        }

        // Half of an odd number is rounded up, e.g. 5 pixels to 3.
        private Vector2Int ViewSize(Vector2Int size) => new Vector2Int((size.x + divisor - 1) / divisor, (size.y + divisor - 1) / divisor);

        private static void Fit(ref RenderTexture texture, Vector2Int size, int slices)
        {
            if (texture != null && texture.width == size.x && texture.height == size.y) return;
            Release(ref texture);
            texture = new RenderTexture(size.x, size.y, 0, Format, RenderTextureReadWrite.Linear)
            {
                name = "Water Thickness",
                dimension = slices > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D,
                volumeDepth = slices,
                filterMode = FilterMode.Bilinear,
                wrapMode = TextureWrapMode.Clamp,
                hideFlags = HideFlags.HideAndDontSave,
            };
            texture.Create();
        }

        private static void Release(ref RenderTexture texture)
        {
            if (texture != null) texture.Release();
            OwnedObject.Destroy(ref texture);
        }
    }
}

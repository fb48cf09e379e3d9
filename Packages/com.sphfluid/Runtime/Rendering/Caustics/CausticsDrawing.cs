using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Caustics of one liquid, Shaders/Rendering/Caustics: once a frame a map of where its surface sends the main light, as the light sees
    /// it, and for each camera the light that arrives, multiplied into the picture before water refracts it.
    /// </summary>
    internal sealed class CausticsDrawing : IDisposable
    {
        private const RenderTextureFormat Format = RenderTextureFormat.ARGBHalf;
        private const int EndsPass = 0;
        private const int MapPass = 1;
        private const int LightPass = 2;
        private const int BoxVertices = 36;

        // Texels along a side of the map, and those of them that stay empty at each border.
        private const int Side = 256;
        private const int Border = 4;

        // A texel in spacings: the surface's cells are as large.
        private const float Texel = 0.75f;

        // Light that comes more level than this, as the cosine to the vertical, makes none.
        private const float LeastHeight = 0.1f;

        // Thickness of no layer, Shaders/Rendering/Caustics/CausticsMap.hlsl.
        private const float NoEnd = -1000f;

        private static readonly int endsId = Shader.PropertyToID("_CausticsEnds");
        private static readonly int mapId = Shader.PropertyToID("_CausticsMap");
        private static readonly int rowsId = Shader.PropertyToID("_CausticsRows");
        private static readonly int strengthId = Shader.PropertyToID("_CausticsStrength");

        private readonly Vector4[] rows = new Vector4[2];
        private Material material;
        private RenderTexture map;
        private MaterialPropertyBlock block;
        private SurfaceBuffers surface;
        private DrawPlacement placement;
        private float strength;
        private int preparedAt = -1;
        private bool isMapped;

        /// <exception cref="FluidDeviceException">The shader is missing, or the device cannot run it.</exception>
        public CausticsDrawing(FluidShaderSet shaders)
        {
            material = DrawMaterial.Create(shaders, "Hidden/SPH Fluid/Caustics");
            WaterCaustics.Add(this);
        }

        /// <summary>Takes the surface of this frame.</summary>
        /// <param name="drawn">The surface.</param>
        /// <param name="properties">Those that the water is drawn with.</param>
        /// <param name="where">Where it is.</param>
        /// <param name="share">Of what caustics add and take, 0 to 1.</param>
        public void Prepare(in SurfaceBuffers drawn, MaterialPropertyBlock properties, in DrawPlacement where, float share)
        {
            (surface, block, placement, strength) = (drawn, properties, where, share);
            preparedAt = Time.frameCount;
            isMapped = false;
        }

        /// <summary>Whether a camera may show the liquid while the sun is up.</summary>
        public bool IsSeenBy(Camera camera) => preparedAt == Time.frameCount && ToLight.y > LeastHeight &&
            (camera.cullingMask & (1 << placement.Layer)) != 0 && new ViewVolume(camera).Touches(placement.WorldBounds);

        /// <summary>Records the map, once a frame; leaves another render target and other matrices.</summary>
        public void RecordMap(CommandBuffer cmd)
        {
            if (isMapped) return;
            isMapped = true;
            if (map == null) map = NewMap();
            float reach = placement.WorldBounds.extents.magnitude;
            float texel = Mathf.Max(Texel * placement.Spacing, 2f * reach / (Side - 2 * Border));
            int used = Mathf.Min(Mathf.CeilToInt(2f * reach / texel) + 2 * Border, Side);
            float half = 0.5f * used * texel;
            Vector3 middle = placement.WorldBounds.center, toLight = ToLight;
            Quaternion turn = Quaternion.LookRotation(-toLight, Mathf.Abs(toLight.y) > 0.99f ? Vector3.forward : Vector3.up);
            Matrix4x4 view = Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) *
                Matrix4x4.TRS(middle + toLight * half, turn, Vector3.one).inverse;
            rows[0] = Row(turn * Vector3.right);
            rows[1] = Row(turn * Vector3.up);
            block.SetVectorArray(rowsId, rows);
            block.SetVector(strengthId, new Vector4(strength, Side, 0f, 0f));

            cmd.GetTemporaryRT(endsId, Side, Side, 0, FilterMode.Point, Format, RenderTextureReadWrite.Linear);
            Draw(cmd, endsId, new Color(NoEnd, 0f, 0f, 0f), EndsPass);
            cmd.SetGlobalTexture(endsId, new RenderTargetIdentifier(endsId));
            Draw(cmd, map, Color.clear, MapPass);
            cmd.ReleaseTemporaryRT(endsId);
            cmd.GenerateMips(map);
            block.SetTexture(mapId, map);

            void Draw(CommandBuffer buffer, RenderTargetIdentifier target, Color clear, int pass)
            {
                buffer.SetRenderTarget(target);
                buffer.ClearRenderTarget(true, true, clear);
                buffer.SetViewport(new Rect(0f, 0f, used, used));
                buffer.SetViewProjectionMatrices(view, Matrix4x4.Ortho(-half, half, -half, half, 0f, 2f * half));
                buffer.DrawProceduralIndirect(surface.Indices, Matrix4x4.identity, material, pass, MeshTopology.Triangles,
                    surface.Arguments, 0, block);
            }

            Vector4 Row(Vector3 axis)
            {
                Vector4 row = axis / texel;
                row.w = 0.5f * used - Vector3.Dot(axis, middle) / texel;
                return row;
            }
        }

        /// <summary>Multiplies the light of the map into the render target, with a camera's matrices and depth texture.</summary>
        public void Record(CommandBuffer cmd)
        {
            block.SetFloat(RenderShaderIds.FluidEye, 0f);
            cmd.DrawProcedural(Matrix4x4.identity, material, LightPass, MeshTopology.Triangles, BoxVertices, 1, block);
        }

        public void Dispose()
        {
            WaterCaustics.Remove(this);
            OwnedObject.Destroy(ref material);
            if (map != null) map.Release();
            OwnedObject.Destroy(ref map);
        }

        private Vector3 ToLight => block.GetVector(RenderShaderIds.FluidLightDirection);

        private static RenderTexture NewMap() => new RenderTexture(Side, Side, 16, Format, RenderTextureReadWrite.Linear)
        {
            name = "Caustics Map",
            useMipMap = true,
            autoGenerateMips = false,
            filterMode = FilterMode.Bilinear,
            wrapMode = TextureWrapMode.Clamp,
            hideFlags = HideFlags.HideAndDontSave,
        };
    }
}

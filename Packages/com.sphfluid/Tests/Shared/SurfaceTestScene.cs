using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>Shaders, fields and pictures for the tests of the drawings.</summary>
    internal static class SurfaceTestScene
    {
        private const string ShaderSetPath = "Packages/com.sphfluid/Runtime/Assets/DefaultFluidShaderSet.asset";

        public static FluidShaderSet LoadShaders()
        {
            GpuTest.Require();
            return TestAssets.Load<FluidShaderSet>(ShaderSetPath);
        }

        /// <summary>A field whose values come from a function of the position.</summary>
        public static SurfaceField Field(FluidShaderSet shaders, SurfaceGrid grid, Func<Vector3, float> density)
        {
            var values = new float[grid.VertexCount];
            for (int z = 0; z <= grid.Cells.z; z++)
            {
                for (int y = 0; y <= grid.Cells.y; y++)
                {
                    for (int x = 0; x <= grid.Cells.x; x++) values[grid.Index(x, y, z)] = density(grid.Position(x, y, z));
                }
            }
            var field = new SurfaceField(shaders, grid);
            field.Values.SetData(values);
            return field;
        }

        /// <summary>
        /// World space as seen from a point towards the origin: Unity's view matrix, which looks down -z.
        /// </summary>
        public static Matrix4x4 LookAtOrigin(Vector3 eye)
        {
            Quaternion rotation = Quaternion.LookRotation(-eye, Vector3.up);
            return Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * Matrix4x4.TRS(eye, rotation, Vector3.one).inverse;
        }

        /// <summary>
        /// Draws into a square picture of floats, cleared to zero, and reads it back; row 0 is the lowest.
        /// </summary>
        public static Color[] Render(int size, Matrix4x4 view, Matrix4x4 projection, Action<CommandBuffer> draw)
        {
            var target = new RenderTexture(size, size, 24, RenderTextureFormat.ARGBFloat,
                RenderTextureReadWrite.Linear);
            var picture = new Texture2D(size, size, TextureFormat.RGBAFloat, false, true);
            RenderTexture before = RenderTexture.active;
            try
            {
                target.Create();
                GpuTest.Run(cmd =>
                {
                    cmd.SetRenderTarget(target);
                    cmd.ClearRenderTarget(true, true, Color.clear);
                    cmd.SetViewProjectionMatrices(view, projection);
                    draw(cmd);
                });
                RenderTexture.active = target;
                picture.ReadPixels(new Rect(0, 0, size, size), 0, 0);
                picture.Apply();
                return picture.GetPixels();
            }
            finally
            {
                RenderTexture.active = before;
                target.Release();
                UnityEngine.Object.DestroyImmediate(target);
                UnityEngine.Object.DestroyImmediate(picture);
            }
        }
    }
}

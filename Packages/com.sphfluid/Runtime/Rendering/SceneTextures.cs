using UnityEngine;

namespace SphFluid
{
    /// <summary>Where water reads the picture of the scene behind it; the numbers are those of Shaders/Rendering/WaterPath.hlsl.</summary>
    internal enum SceneColourSource
    {
        /// <summary>Nowhere: the water is blended over the scene, without refraction.</summary>
        None = 0,

        /// <summary>A copy of the camera's picture that the package makes: Built-in.</summary>
        Copy = 1,

        /// <summary><c>_CameraOpaqueTexture</c> of the Universal Render Pipeline.</summary>
        OpaqueTexture = 2,
    }

    /// <summary>What a camera shows of the scene to the water in it.</summary>
    internal readonly struct SceneTextures
    {
        public SceneTextures(SceneColourSource colour, bool depth)
        {
            Colour = colour;
            Depth = depth;
        }

        public SceneColourSource Colour { get; }

        /// <summary>Whether <c>_CameraDepthTexture</c> holds the scene's depth.</summary>
        public bool Depth { get; }

        /// <summary>The vector that shaders read.</summary>
        public Vector4 ToVector() => new Vector4((float)Colour, Depth ? 1f : 0f, 0f, 0f);
    }

    /// <summary>Why a renderer hands out no picture of the scene.</summary>
    internal enum RendererLimit
    {
        /// <summary>It does.</summary>
        None,

        /// <summary>The Universal Renderer in Tile-Only Mode: colour and depth stay on the chip.</summary>
        TileOnly,

        /// <summary>The 2D Renderer.</summary>
        TwoDimensional,
    }

    /// <summary>Asks a render pipeline for the scene's colour and depth before a camera draws.</summary>
    internal interface ISceneTextureSource
    {
        /// <summary>What the renderer of cameras that choose none of their own cannot do.</summary>
        RendererLimit Limit { get; }

        /// <summary>Called when a camera begins to draw.</summary>
        SceneTextures Request(Camera camera);

        /// <summary>Called when the last water is gone: leaves no trace on any camera.</summary>
        void Release();
    }
}

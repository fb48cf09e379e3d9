using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A surface as the GPU draws it.</summary>
    internal readonly struct SurfaceBuffers
    {
        /// <summary>Property id of the vertices.</summary>
        public static readonly int VerticesId = Shader.PropertyToID("_SurfaceVertices");

        /// <param name="vertices">Vertices, Shaders/Surface/Sparse/SurfaceVertices.hlsl.</param>
        /// <param name="indices">32-bit indices, three a triangle.</param>
        /// <param name="arguments">One <see cref="GraphicsBuffer.IndirectDrawIndexedArgs"/>, in a buffer as of
        /// <see cref="GpuBuffers.CreateArguments"/>.</param>
        public SurfaceBuffers(GraphicsBuffer vertices, GraphicsBuffer indices, GraphicsBuffer arguments)
        {
            Vertices = vertices ?? throw new ArgumentNullException(nameof(vertices));
            Indices = indices ?? throw new ArgumentNullException(nameof(indices));
            Arguments = arguments ?? throw new ArgumentNullException(nameof(arguments));
        }

        public GraphicsBuffer Vertices { get; }

        public GraphicsBuffer Indices { get; }

        public GraphicsBuffer Arguments { get; }
    }
}

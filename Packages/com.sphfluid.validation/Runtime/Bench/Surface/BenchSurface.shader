// Benchmark only: meshes that compute shaders left in buffers, lit as the thesis's surface.
Shader "Hidden/SPH Fluid/Benchmark/Surface"
{
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }

        // Corners of triangles as EmitSurfaceVertices.compute emits them.
        Pass
        {
            Name "TriangleCorners"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ProjectCorner
            #pragma fragment ShadeSurface

            #include "Packages/com.sphfluid/Shaders/Surface/SurfaceShading.hlsl"
            #include "Packages/com.sphfluid/Thesis/Shaders/Surface/EmittedVertex.hlsl"

            StructuredBuffer<EmittedVertex> _SurfaceVertices;

            SurfaceFragment ProjectCorner(uint id : SV_VertexID)
            {
                SurfaceVertex surface;
                surface.position = _SurfaceVertices[id].position;
                surface.normal = _SurfaceVertices[id].normal;
                return ProjectSurfaceVertex(surface);
            }
            ENDHLSL
        }

        // Vertices of the sparse surface.
        Pass
        {
            Name "PackedVertices"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ProjectVertex
            #pragma fragment ShadeSurface

            #include "Packages/com.sphfluid/Shaders/Surface/SurfaceShading.hlsl"
            #include "Packages/com.sphfluid/Shaders/Surface/Sparse/SurfaceVertices.hlsl"

            SurfaceFragment ProjectVertex(uint id : SV_VertexID)
            {
                return ProjectSurfaceVertex(FetchSurfaceVertex(id));
            }
            ENDHLSL
        }
    }
}

// Test only: what both backends of the surface drew, as numbers. Red: distance to the eye; green and blue: normal x and
// y; alpha: 1.
Shader "Hidden/SPH Fluid/Tests/Surface Compare"
{
    SubShader
    {
        Pass
        {
            Name "GeometryShader"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma require geometry
            #pragma multi_compile_local _ FLUID_CUBES
            #pragma vertex PassThrough
            #pragma geometry GenerateIsosurface
            #pragma fragment WriteNumbers

            #include "Packages/com.sphfluid/Thesis/Shaders/Surface/SurfaceGeometry.hlsl"

            float4 _Eye;

            float4 WriteNumbers(SurfaceFragment input) : SV_Target
            {
                return float4(distance(SurfaceWorld(input), _Eye.xyz), normalize(input.normal).xy, 1.0);
            }
            ENDHLSL
        }

        Pass
        {
            Name "Mesh"
            Cull Back
            ZWrite On
            ZTest LEqual

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex ProjectMesh
            #pragma fragment WriteNumbers

            #include "Packages/com.sphfluid/Shaders/Rendering/FluidShading.hlsl"

            float4 _Eye;

            struct MeshVertex
            {
                float3 position : POSITION;
                float3 normal : NORMAL;
            };

            struct MeshFragment
            {
                float4 clipPosition : SV_Position;
                float3 world : TEXCOORD0;
                float3 normal : TEXCOORD1;
            };

            MeshFragment ProjectMesh(MeshVertex input)
            {
                MeshFragment output;
                output.world = FluidWorldPosition(input.position);
                output.normal = FluidWorldDirection(input.normal);
                output.clipPosition = FluidClipPosition(output.world);
                return output;
            }

            float4 WriteNumbers(MeshFragment input) : SV_Target
            {
                return float4(distance(input.world, _Eye.xyz), normalize(input.normal).xy, 1.0);
            }
            ENDHLSL
        }
    }
}

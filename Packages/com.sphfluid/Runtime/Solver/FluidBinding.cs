using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The names of Shaders/FluidBuffers.hlsl, and one of the three things that they are set in: a kernel's dispatch, a property block, a
    /// material.
    /// </summary>
    internal readonly struct FluidBinding
    {
        public static readonly int Particles = Shader.PropertyToID("_FluidParticles");
        public static readonly int Cells = Shader.PropertyToID("_FluidCells");
        public static readonly int Densities = Shader.PropertyToID("_FluidDensities");
        public static readonly int Pressures = Shader.PropertyToID("_FluidPressures");
        public static readonly int ParticleCount = Shader.PropertyToID("_FluidParticleCount");
        public static readonly int Spacing = Shader.PropertyToID("_FluidSpacing");
        public static readonly int SupportRadius = Shader.PropertyToID("_FluidSupportRadius");
        public static readonly int ParticleMass = Shader.PropertyToID("_FluidParticleMass");
        public static readonly int RestDensity = Shader.PropertyToID("_FluidRestDensity");
        public static readonly int GridOrigin = Shader.PropertyToID("_FluidGridOrigin");
        public static readonly int CellSize = Shader.PropertyToID("_FluidCellSize");
        public static readonly int CellCounts = Shader.PropertyToID("_FluidCellCounts");
        public static readonly int Period = Shader.PropertyToID("_FluidPeriod");
        public static readonly int ToWorld = Shader.PropertyToID("_FluidSimulationToWorld");
        public static readonly int FromWorld = Shader.PropertyToID("_FluidWorldToSimulation");

        private readonly CommandBuffer commands;
        private readonly ComputeShader shader;
        private readonly int kernel;
        private readonly MaterialPropertyBlock properties;
        private readonly Material material;

        public FluidBinding(CommandBuffer commands, ComputeShader shader, int kernel) : this()
        {
            this.commands = commands;
            this.shader = shader;
            this.kernel = kernel;
        }

        public FluidBinding(MaterialPropertyBlock properties) : this()
        {
            this.properties = properties;
        }

        public FluidBinding(Material material) : this()
        {
            this.material = material;
        }

        public void Set(int id, GraphicsBuffer buffer)
        {
            commands?.SetComputeBufferParam(shader, kernel, id, buffer);
            properties?.SetBuffer(id, buffer);
            if (!(material is null)) material.SetBuffer(id, buffer);
        }

        public void Set(int id, int value)
        {
            commands?.SetComputeIntParam(shader, id, value);
            properties?.SetInteger(id, value);
            if (!(material is null)) material.SetInteger(id, value);
        }

        public void Set(int id, float value)
        {
            commands?.SetComputeFloatParam(shader, id, value);
            properties?.SetFloat(id, value);
            if (!(material is null)) material.SetFloat(id, value);
        }

        public void Set(int id, Vector3 value)
        {
            commands?.SetComputeVectorParam(shader, id, value);
            properties?.SetVector(id, value);
            if (!(material is null)) material.SetVector(id, value);
        }

        public void Set(int id, in Matrix4x4 value)
        {
            commands?.SetComputeMatrixParam(shader, id, value);
            properties?.SetMatrix(id, value);
            if (!(material is null)) material.SetMatrix(id, value);
        }
    }
}

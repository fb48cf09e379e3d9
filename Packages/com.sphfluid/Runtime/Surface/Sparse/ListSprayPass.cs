using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Particles that left the surface as spray, for the drawing (Shaders/Surface/Sparse/ListSpray.compute).
    /// </summary>
    internal sealed class SprayParticles : BufferSet
    {
        private const int Stride = 8 * sizeof(float);

        /// <summary>Numbers of <see cref="DrawArguments"/>; the first are the vertices.</summary>
        public const int ArgumentWords = 4;

        private FluidBuffer spray, groups, particles, arguments;

        /// <summary>
        /// Two numbers of 32 bits a particle of the liquid: which part of it left the surface, 0 to 1, and how far apart along the flow the
        /// two kernels of the rest lie.
        /// </summary>
        public FluidBuffer Spray => spray;

        /// <summary>uint a group of 256 particles of the liquid.</summary>
        public FluidBuffer Groups => groups;

        /// <summary>Shaders/Surface/Sparse/SprayParticle.hlsl: those of which any part did, in the liquid's order.</summary>
        public FluidBuffer Particles => particles;

        /// <summary>One <see cref="UnityEngine.GraphicsBuffer.IndirectDrawArgs"/>: the vertices of all of them, one instance.</summary>
        public FluidBuffer DrawArguments => arguments;

        /// <summary>Makes the buffers large enough; what they held may be lost.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory.</exception>
        public void Reserve(int count)
        {
            Grow(ref spray, "Spray", count, 2 * sizeof(uint));
            Grow(ref groups, "SprayGroups", GroupsOf(count), sizeof(uint));
            Grow(ref particles, "SprayParticles", count, Stride);
            Grow(ref arguments, "SprayArguments", ArgumentWords, sizeof(uint), Arguments);
        }

        /// <summary>Groups of 256 that hold so many particles, at least one.</summary>
        public static int GroupsOf(int count) => count > 0 ? (count + 255) / 256 : 1;
    }

    /// <summary>Writes one after the other the particles of which a part left the surface, and how much of them is drawn.</summary>
    internal sealed class ListSprayPass : ComputePass
    {
        private const int ScanThreads = 256;

        private static readonly int Particles = Id("_Particles");
        private static readonly int GroupTotal = Id("_GroupTotal");
        private static readonly int VerticesPerParticle = Id("_VerticesPerParticle");

        private readonly ComputeKernel count, scan, list;

        public ListSprayPass(FluidShaderSet shaders)
            : base(shaders, "ListSpray")
        {
            count = Kernel("CountSpray");
            scan = Kernel("ScanSpray");
            list = Kernel();
        }

        /// <summary>After <see cref="PrepareSurfaceParticlesPass"/> with the same input.</summary>
        /// <param name="cmd">Where it is recorded.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="spray">What the pass before wrote, and what this one writes.</param>
        /// <param name="vertices">Vertices that a particle is drawn with.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, SprayParticles spray, int vertices)
        {
            int groups = SprayParticles.GroupsOf(solver.ParticleCount);
            using (Sample(cmd))
            {
                count.SetInt(cmd, FluidShaderIds.ParticleCount, solver.ParticleCount);
                count.SetInt(cmd, GroupTotal, groups);
                count.Set(cmd, spray.Spray);
                count.Set(cmd, spray.Groups);
                count.DispatchThreads(cmd, solver.ParticleCount);

                scan.SetInt(cmd, GroupTotal, groups);
                scan.SetInt(cmd, VerticesPerParticle, vertices);
                scan.Set(cmd, spray.Groups);
                scan.Set(cmd, spray.DrawArguments);
                scan.DispatchThreads(cmd, ScanThreads);

                list.SetInt(cmd, FluidShaderIds.ParticleCount, solver.ParticleCount);
                list.SetBuffer(cmd, Particles, solver.Particles);
                list.Set(cmd, spray.Spray);
                list.Set(cmd, spray.Groups);
                list.SetOut(cmd, spray.Particles);
                list.DispatchThreads(cmd, solver.ParticleCount);
            }
        }
    }
}

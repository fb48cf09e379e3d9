using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// How much air each particle of the liquid takes in, and the births that it asks for (Ihmsen et al. 2012, section 3.1).
    /// </summary>
    internal sealed class WhitewaterPotentialsPass : ComputePass
    {
        /// <summary>Births of a particle whose trapped air and energy are at their limits [1/s].</summary>
        public const float AirRate = 90f;

        /// <summary>Births of a particle whose wave crest and energy are at their limits [1/s].</summary>
        public const float CrestRate = 90f;

        /// <summary>Time that the running means of the largest potentials go over [s].</summary>
        public const float MeanTime = 2f;

        /// <summary>
        /// Upper limits are no lower: trapped air [m/s], wave crest, energy [J/kg]. Jets take in air from about 1 m/s on, 0.5 J/kg.
        /// </summary>
        public static readonly Vector3 LeastLimits = new Vector3(8f, 1.5f, 1f);

        private static readonly int SupportRadius = Id("_SupportRadius");
        private static readonly int Duration = Id("_Duration");
        private static readonly int BirthRates = Id("_BirthRates");
        private static readonly int LeastLimitsId = Id("_LeastLimits");
        private static readonly int MeanTimeId = Id("_MeanTime");

        private readonly ComputeKernel potentials, crests, limits;

        public WhitewaterPotentialsPass(FluidShaderSet shaders)
            : base(shaders, "WhitewaterPotentials")
        {
            potentials = Kernel();
            crests = Kernel("WhitewaterCrests");
            limits = Kernel("WhitewaterLimits");
        }

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="buffers">What is written, reserved for the liquid.</param>
        /// <param name="amount">Times as many births as by default.</param>
        /// <param name="duration">Length of the frame [s].</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, WhitewaterBuffers buffers, float amount, float duration)
        {
            using (Sample(cmd))
            {
                SetLiquid(cmd, potentials, solver);
                potentials.SetOut(cmd, buffers.Normals);
                potentials.DispatchThreads(cmd, solver.ParticleCount);

                SetLiquid(cmd, crests, solver);
                crests.Set(cmd, buffers.Normals);
                crests.SetOut(cmd, buffers.Potentials);
                crests.Set(cmd, buffers.State);
                crests.SetFloat(cmd, Duration, duration);
                crests.SetVector(cmd, BirthRates, amount * new Vector2(AirRate, CrestRate));
                crests.SetVector(cmd, LeastLimitsId, LeastLimits);
                crests.DispatchThreads(cmd, solver.ParticleCount);

                limits.Set(cmd, buffers.State);
                limits.SetFloat(cmd, Duration, duration);
                limits.SetFloat(cmd, MeanTimeId, MeanTime);
                limits.DispatchThreads(cmd, 1);
            }
        }

        private static void SetLiquid(CommandBuffer cmd, ComputeKernel kernel, FluidSolver solver)
        {
            solver.BindNeighbours(cmd, kernel);
            solver.BindNeighbourList(cmd, kernel);
            DomainBindings.SetFaces(cmd, kernel, solver.Settings);
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, solver.ParticleCount);
            kernel.SetFloat(cmd, SupportRadius, solver.Settings.SupportRadius);
        }
    }
}

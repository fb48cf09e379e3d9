using Unity.Profiling;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Proves every step free of every triangle and changes those that are not (Shaders/Solver/Standard/{FindContacts,ResolveContacts}.compute):
    /// two dispatches, the second as large as there are such steps.
    /// </summary>
    internal sealed class ContactPass
    {
        static readonly ProfilerMarker Marker = ComputeKernel.CreateMarker("Contacts");

        readonly ComputeKernel find;
        readonly ComputeKernel resolve;

        public ContactPass(FluidShaderSet shaders)
        {
            find = shaders.Kernel("FindContacts", "FindContacts");
            resolve = shaders.Kernel("ResolveContacts", "ResolveContacts");
        }

        public void Record(CommandBuffer cmd, FluidState state, float timeStep)
        {
            FluidSolverSettings settings = state.Settings;
            MeshWallBuffers walls = state.Standard.Walls;
            cmd.BeginSample(Marker);
            Bind(cmd, find, state);
            find.SetFloat(cmd, StandardShaderIds.LongestDisplacement, MeshContact.LongestDisplacement(settings));
            find.SetBuffer(cmd, StandardShaderIds.ContactList, walls.ContactList);
            find.SetBuffer(cmd, StandardShaderIds.ContactArguments, walls.ContactArguments);
            find.DispatchThreads(cmd, state.ParticleCount);

            Bind(cmd, resolve, state);
            resolve.SetFloat(cmd, FluidShaderIds.TimeStep, timeStep);
            resolve.SetBuffer(cmd, StandardShaderIds.ContactListIn, walls.ContactList);
            resolve.SetBuffer(cmd, StandardShaderIds.ContactArgumentsIn, walls.ContactArguments);
            resolve.SetBuffer(cmd, StandardShaderIds.NewVelocitiesOut, state.Standard.NewVelocities);
            resolve.DispatchIndirect(cmd, walls.ContactArguments);
            cmd.EndSample(Marker);
        }

        static void Bind(CommandBuffer cmd, ComputeKernel kernel, FluidState state)
        {
            CellRowsBinding.Set(cmd, kernel, state.Cells, state.Standard.CellStart);
            DomainFaces.Set(cmd, kernel, state.Settings, MeshContact.Distance(state.Settings));
            kernel.SetInt(cmd, FluidShaderIds.ParticleCount, state.ParticleCount);
            DomainBindings.SetPeriodic(cmd, kernel, state.Settings);
            MeshContact.Set(cmd, kernel, state.Settings);
            state.Bodies.Bind(cmd, kernel, state.BodyStep.x, state.BodyStep.y);
            kernel.SetBuffer(cmd, StandardShaderIds.Positions, state.Standard.Positions);
            kernel.SetBuffer(cmd, StandardShaderIds.NewPositionsOut, state.Standard.NewPositions);
            kernel.SetBuffer(cmd, StandardShaderIds.CellCount, state.Standard.CellCount);
            kernel.SetBuffer(cmd, StandardShaderIds.RankOut, state.Standard.Rank);
            kernel.SetBuffer(cmd, FluidShaderIds.Counters, state.Buffers.Counters);
        }
    }
}

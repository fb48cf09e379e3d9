using System;

namespace SphFluid
{
    /// <summary>What a method can do, and what follows from how it computes.</summary>
    [Flags]
    internal enum FluidMethodFeatures
    {
        None = 0,

        /// <summary>Faces of the domain through which liquid leaves.</summary>
        OpenFaces = 1,

        /// <summary>Each step is proved free of every triangle of the scene, which moves as rigid or stretched bodies.</summary>
        BodyContact = 2,

        /// <summary>Each collider has a friction of its own.</summary>
        ColliderFriction = 4,

        /// <summary>A liquid can be brought to rest before the start.</summary>
        RelaxedStart = 8,

        /// <summary>Walls are springs, which a fast particle can cross.</summary>
        PenaltyWalls = 16,

        /// <summary>Density and force have different kernels, which feeds energy in and makes particles pair.</summary>
        TwoKernels = 32,

        /// <summary>The speed of sound can change while the liquid runs.</summary>
        FollowingSoundSpeed = 64,

        /// <summary>One neighbour setup serves several steps, more of a slow liquid: <see cref="FluidSolver.FlowSpeed"/>.</summary>
        KeptNeighbours = 128,

        /// <summary>Particles are born and drained while the liquid runs: its stepper is an <see cref="IExchangingStepper"/>.</summary>
        ChangingCount = 256,

        /// <summary>Accelerations in parts of the domain: <see cref="SphFluid.ForceZones"/>.</summary>
        ForceZones = 512,

        /// <summary>The force on walls is summed in each step: <see cref="SphFluid.WallForces"/>.</summary>
        WallForces = 1024,

        /// <summary>A frame is cut into a number of equal steps, whatever the liquid does: <see cref="FluidMethod.MakeClock"/>.</summary>
        StepsByFrame = 2048,

        /// <summary>Surface tension and contact angle.</summary>
        SurfaceTension = 4096,

        /// <summary>Viscosity that is solved for, so that no step is too long for it.</summary>
        ImplicitViscosity = 8192,

        /// <summary>Parts of the liquid that rest take no part in the steps.</summary>
        SleepingParts = 16384,
    }
}

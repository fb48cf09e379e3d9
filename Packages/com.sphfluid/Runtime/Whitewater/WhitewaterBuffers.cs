using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The whitewater of a liquid on the GPU, and what is computed of the liquid's particles for it.</summary>
    internal sealed class WhitewaterBuffers : BufferSet
    {
        /// <summary>Bytes of WhitewaterParticle in Shaders/Whitewater/WhitewaterTypes.hlsl.</summary>
        public const int Stride = 48;

        /// <summary>Vertices of the triangle that a piece is drawn on.</summary>
        public const int VerticesPerPiece = 3;

        private const int GroupThreads = 256;

        // Slots of the state, mirrored by Shaders/Whitewater/WhitewaterTypes.hlsl.
        private const int Count = 0, Before = 1, Survivors = 2, Requested = 3, Born = 4, Refused = 5, Largest = 6, Means = 9, Time = 12;

        private static readonly uint[] Zeros = new uint[StateSlots];

        private FluidBuffer normals, potentials, groups;

        /// <exception cref="FluidDeviceException">The device has too little memory.</exception>
        public WhitewaterBuffers(int capacity)
        {
            Capacity = capacity;
            Present = Add("Whitewater", capacity, Stride);
            Next = Add("Whitewater", capacity, Stride);
            State = Add("WhitewaterState", StateSlots, sizeof(uint));
            DrawArguments = Add("WhitewaterArguments", 4, sizeof(uint), Arguments);
            NoBodies = Add("Bodies", 1, CollisionBody.Stride);
            NoTriangles = Add("BodyTriangles", 1, BodyTriangle.Stride);
            NoLists = Add("BodyLists", 1, sizeof(uint));
            NoBodies.SetData(new uint[CollisionBody.Stride / sizeof(uint)]);
            DrawArguments.SetData(new uint[] { 0, 1, 0, 0 });
            State.SetData(Zeros);
        }

        /// <summary>Numbers of the state.</summary>
        public const int StateSlots = 16;

        /// <summary>Where the state has the numbers of a frame that begin at 0: survivors and requested births.</summary>
        public const int FirstOfFrame = Survivors, SlotsOfFrame = Requested - Survivors + 1;

        /// <summary>Most pieces.</summary>
        public int Capacity { get; }

        /// <summary>The pieces; <see cref="Exchange"/> puts the next in their place.</summary>
        public FluidBuffer Present { get; }

        /// <summary>The pieces after the frame that is recorded.</summary>
        public FluidBuffer Next { get; }

        /// <summary>uint each; see Shaders/Whitewater/WhitewaterTypes.hlsl.</summary>
        public FluidBuffer State { get; }

        /// <summary>One <see cref="GraphicsBuffer.IndirectDrawArgs"/>: the vertices of all pieces, one instance.</summary>
        public FluidBuffer DrawArguments { get; }

        /// <summary>An element each to bind where the liquid collides with nothing.</summary>
        public FluidBuffer NoBodies { get; }
        public FluidBuffer NoTriangles { get; }
        public FluidBuffer NoLists { get; }

        /// <summary>float4 a particle of the liquid: the normal out of it, zero within, and trapped air [m/s].</summary>
        public FluidBuffer Normals => normals;

        /// <summary>float4 a particle of the liquid: trapped air [m/s], wave crest, energy [J/kg], births in the frame.</summary>
        public FluidBuffer Potentials => potentials;

        /// <summary>uint a group of 256 pieces, then of 256 particles.</summary>
        public FluidBuffer Groups => groups;

        /// <summary>Groups of pieces.</summary>
        public int SurvivorGroups => GroupsOf(Capacity);

        /// <summary>Groups of pieces and of particles.</summary>
        public int GroupTotal(int particleCount) => SurvivorGroups + GroupsOf(particleCount);

        /// <summary>Makes what has an element a particle large enough.</summary>
        /// <exception cref="FluidDeviceException">The device has too little memory.</exception>
        public void Reserve(int particleCount)
        {
            Grow(ref normals, "WhitewaterNormals", particleCount, 4 * sizeof(float));
            Grow(ref potentials, "WhitewaterPotentials", particleCount, 4 * sizeof(float));
            Grow(ref groups, "WhitewaterGroups", GroupTotal(particleCount), sizeof(uint));
        }

        /// <summary>The next pieces are the present ones from now on.</summary>
        public void Exchange() => FluidBuffer.Exchange(Present, Next);

        /// <summary>What of the state is worth showing.</summary>
        public static WhitewaterCounts Read(uint[] state) => new WhitewaterCounts(state[Count], state[Born], state[Refused],
            new Vector3(Number(state[Means]), Number(state[Means + 1]), Number(state[Means + 2])));

        private static float Number(uint bits) => BitConverter.Int32BitsToSingle(unchecked((int)bits));

        private static int GroupsOf(int count) => Math.Max(1, (count + GroupThreads - 1) / GroupThreads);
    }
}

using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where the particles of a liquid come from that is shown and not stepped.</summary>
    internal interface IFluidPlayback
    {
        /// <summary>Most particles of a frame.</summary>
        long MostParticles { get; }

        /// <summary>Says what is wrong or worth knowing where a simulation is to show it; changes nothing.</summary>
        /// <param name="domainSize">Edge lengths of the simulation's domain [m].</param>
        /// <param name="spacing">Its particle spacing [m].</param>
        /// <param name="messages">Receives the messages.</param>
        void Check(Vector3 domainSize, float spacing, List<FluidMessage> messages);

        /// <summary>Gives the particles to show from now on.</summary>
        /// <param name="domainSize">Edge lengths of the domain: particles beyond are left out [m].</param>
        /// <param name="period">Length of the domain along periodic axes, 0 along others [m].</param>
        /// <param name="isNew">Whether nothing is shown so far.</param>
        /// <param name="frame">The particles.</param>
        /// <returns>False where those that are shown stay.</returns>
        bool TryTake(Vector3 domainSize, Vector3 period, bool isNew, out PlayedFrame frame);
    }

    /// <summary>A component that plays a liquid.</summary>
    internal interface IFluidPlaybackSource
    {
        /// <summary>What it plays; null while it is disabled or cannot.</summary>
        IFluidPlayback Playback { get; }
    }

    /// <summary>Particles to show.</summary>
    internal readonly struct PlayedFrame
    {
        public PlayedFrame(NativeArray<FluidParticle> particles, int count, double time, bool isJump)
        {
            Particles = particles;
            Count = count;
            Time = time;
            IsJump = isJump;
        }

        /// <summary>The particles, and where there are none one that is marked as removed; simulation space.</summary>
        public NativeArray<FluidParticle> Particles { get; }

        /// <summary>Number of them.</summary>
        public int Count { get; }

        /// <summary>Time of the liquid [s].</summary>
        public double Time { get; }

        /// <summary>Whether they do not follow from what was shown before: what goes on from frame to frame begins anew.</summary>
        public bool IsJump { get; }
    }
}

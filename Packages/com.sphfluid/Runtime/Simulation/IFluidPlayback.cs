using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A liquid that a <see cref="FluidSimulation"/> shows in place of computing it, frame by frame.</summary>
    public interface IFluidPlayback
    {
        /// <summary>Most particles of any frame.</summary>
        long MostParticles { get; }

        /// <summary>Checks, before the simulation starts, that it can show the liquid; changes nothing.</summary>
        /// <param name="domainSize">Edge lengths of the simulation's domain [m].</param>
        /// <param name="spacing">Its particle spacing [m].</param>
        /// <param name="messages">Receives what is wrong or worth knowing; an error keeps the simulation from starting.</param>
        void Check(Vector3 domainSize, float spacing, List<FluidMessage> messages);

        /// <summary>Gives the particles to show from now on; called once in each of the simulation's frames.</summary>
        /// <param name="domainSize">Edge lengths of the domain, in which all particles must lie [m].</param>
        /// <param name="period">Length of the domain along periodic axes, 0 along others [m].</param>
        /// <param name="isNew">Whether nothing has been shown since the simulation started.</param>
        /// <param name="frame">The particles.</param>
        /// <returns>False to keep showing the last ones.</returns>
        bool TryTake(Vector3 domainSize, Vector3 period, bool isNew, out FluidPlaybackFrame frame);
    }
}

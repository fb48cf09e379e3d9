using System;

namespace SphFluid
{
    /// <summary>The graphics device or a shader cannot do what the fluid asks of it. The message names both and the cure.</summary>
    public sealed class FluidDeviceException : Exception
    {
        /// <summary>Creates the exception.</summary>
        /// <param name="message">What is missing, on which device, and what to do.</param>
        public FluidDeviceException(string message) : base(message)
        {
        }
    }
}

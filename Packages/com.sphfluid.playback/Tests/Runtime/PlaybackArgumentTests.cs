using System;
using System.Reflection;

namespace SphFluid.Tests
{
    /// <summary>Calls of the package with arguments that they should not get.</summary>
    public sealed class PlaybackArgumentTests : ArgumentContract
    {
        protected override Assembly Package => typeof(FluidPlayback).Assembly;

        protected override (string call, string reason)[] Exempt => new[]
        {
            (@"^FluidSequenceWriter\.Write.* frame\.", "is left out and counted by the playback"),
        };

        protected override object Example(Type type)
        {
            if (type == typeof(FluidSequenceWriter))
            {
                return Made(new FluidSequenceWriter(FreshFolder(), Simulation.DomainSize, Simulation.Spacing));
            }
            return base.Example(type);
        }
    }
}

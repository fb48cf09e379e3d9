using System;
using System.Collections.Generic;
using System.Reflection;

namespace SphFluid.Tests
{
    /// <summary>Calls of the package with arguments that they should not get.</summary>
    public sealed class PysphArgumentTests : ArgumentContract
    {
        protected override Assembly Package => typeof(FluidExport).Assembly;

        protected override (string call, string reason)[] Exempt => new[]
        {
            (@" options\.|^FluidExportOptions\.", "are settings: what is out of range is thrown where they are used"),
        };

        protected override object Example(Type type)
        {
            if (type == typeof(IReadOnlyList<FluidSimulation>)) return new[] { Simulation };
            if (type == typeof(Action<IReadOnlyList<FluidExport>>)) return (Action<IReadOnlyList<FluidExport>>)(_ => { });
            if (type == typeof(FluidExportOptions)) return new FluidExportOptions();
            if (type == typeof(FluidExport)) return Made(FluidExport.Begin(Simulation, new FluidExportOptions()));
            return base.Example(type);
        }
    }
}

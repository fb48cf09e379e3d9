using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What a table was measured with, beside the graphics device.</summary>
    public sealed class BenchMachine
    {
        /// <summary>Nothing is known.</summary>
        public static readonly BenchMachine None = new BenchMachine("", "", "");

        private BenchMachine(string driver, string processor, string commit)
        {
            Driver = driver;
            Processor = processor;
            Commit = commit;
        }

        /// <summary>This machine and this program.</summary>
        public static BenchMachine This => new BenchMachine(
            $"{SystemInfo.graphicsDeviceVendor}; {SystemInfo.graphicsDeviceVersion}",
            $"{SystemInfo.processorType}; {SystemInfo.processorCount} threads", SweepBuild.Commit);

        /// <summary>The graphics driver and the API that it is spoken to by, as they name themselves.</summary>
        public string Driver { get; }

        /// <summary>The processor and how many threads it runs at once.</summary>
        public string Processor { get; }

        /// <summary>The commit, with a hash of what differs from it behind a +; empty where none is known.</summary>
        public string Commit { get; }
    }
}

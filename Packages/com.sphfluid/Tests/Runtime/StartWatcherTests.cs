using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Starts that take long tell how far they are, and can be ended.</summary>
    public sealed class StartWatcherTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private IFluidStartWatcher before;
        private Watcher watcher;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create(liquid: false);
            simulation.Method = FluidMethodKind.Standard;
            simulation.StartJitter = 0f;
            simulation.DomainSize = new Vector3(0.2f, 0.4f, 0.2f);
            FluidVolume volume = rig.AddVolume(simulation);
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f);
            before = FluidSimulation.StartWatcher;
            FluidSimulation.StartWatcher = watcher = new Watcher();
        }

        [TearDown]
        public void TearDown()
        {
            FluidSimulation.StartWatcher = before;
            rig.Dispose();
        }

        [Test]
        public void TheWatcherSeesStepsTimeAndAnEstimate()
        {
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(watcher.Seen.Count, Is.GreaterThan(3));
            Assert.That(watcher.Seen.Select(p => p.Steps), Is.Ordered);
            Assert.That(watcher.Seen.All(p => p.Seconds >= 0.0 && p.SecondsLeft >= 0.0 && p.Share >= 0f && p.Share <= 1f));
            Assert.That(watcher.Ends, Is.EqualTo(1));
        }

        [Test]
        public void WatchingChangesNothing()
        {
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            FluidParticle[] watched = SimulationRig.Read(simulation);
            FluidSimulation.StartWatcher = null;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(SimulationRig.Read(simulation), Is.EqualTo(watched), "to the last bit");
        }

        [UnityTest]
        public IEnumerator AStartThatIsEndedDoesNotRunAndIsNotTriedAgain()
        {
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            watcher.Patience = 2;
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid': The start was ended before the liquid came to rest"));
            Assert.That(simulation.StartSimulation(), Is.False);
            Assert.That(watcher.Seen.Count, Is.EqualTo(2));
            Assert.That(watcher.Ends, Is.EqualTo(1));
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(watcher.Seen.Count, Is.EqualTo(2));
            FluidSimulation.StartWatcher = null;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
        }

        [Test]
        public void StartsWithoutRelaxationAreNotWatched()
        {
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            Assert.That(watcher.Seen, Is.Empty);
        }

        private sealed class Watcher : IFluidStartWatcher
        {
            public readonly List<FluidStartProgress> Seen = new List<FluidStartProgress>();
            public int Patience = int.MaxValue;

            public int Ends { get; private set; }

            public bool Continue(FluidSimulation simulation, FluidStartProgress progress)
            {
                Seen.Add(progress);
                return Seen.Count < Patience;
            }

            public void Ended(FluidSimulation simulation) => Ends++;
        }
    }
}

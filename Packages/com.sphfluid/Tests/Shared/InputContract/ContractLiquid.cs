using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A small liquid that is given bad values, and all that is said and done while it is.</summary>
    internal sealed class ContractLiquid : IDisposable
    {
        private readonly List<string> lines = new List<string>();
        private int updates;

        public ContractLiquid()
        {
            LogAssert.ignoreFailingMessages = true;
            Rig = new SimulationRig(0.002f);
            Simulation = Rig.Create();
            Simulation.SleepsAtRest = false;
            Simulation.MaxSubstepsPerFrame = 4;
            Simulation.Updated += _ => updates++;
            Application.logMessageReceived += Note;
            Assert.That(Simulation.StartSimulation(), Simulation.StatusMessage);
        }

        public SimulationRig Rig { get; }

        public FluidSimulation Simulation { get; }

        /// <summary>Exceptions in the console since <see cref="Listen"/>.</summary>
        public string Exception { get; private set; }

        /// <summary>
        /// What is said about an object since <see cref="Listen"/>: lines of the console, and what stands in messages that were said
        /// before.
        /// </summary>
        public IEnumerable<string> Said => lines.Concat(Simulation.Messages.Select(m => m.ToString()));

        /// <summary>Forgets what was said.</summary>
        public void Listen()
        {
            lines.Clear();
            Exception = null;
        }

        /// <summary>Frames of the scene.</summary>
        public IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++) yield return null;
        }

        /// <summary>Frames until the liquid has gone on by one; it is started where it was stopped.</summary>
        /// <param name="goesOn">Receives whether it did.</param>
        public IEnumerator GoOn(Action<bool> goesOn)
        {
            int before = updates;
            for (int i = 0; i < 4 && updates == before; i++) yield return null;
            goesOn(updates > before);
        }

        /// <summary>Whether a particle has a number that is none.</summary>
        public bool IsDamaged =>
            SimulationRig.Read(Simulation)
                .Any(p => !AffineMath.IsFinite(p.Position) || !AffineMath.IsFinite(p.VelT0) || !AffineMath.IsFinite(p.VelT1));

        public void Dispose()
        {
            Application.logMessageReceived -= Note;
            Rig.Dispose();
        }

        private void Note(string line, string trace, LogType type)
        {
            lines.Add(line);
            if (type == LogType.Exception) Exception ??= line.Split('\n')[0];
        }
    }
}

using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>What ./run export makes of a scene with several liquids: all that can be exported, and an exit code.</summary>
    public sealed class ExportPlayTests
    {
        private readonly List<(string Message, int Code)> ends = new List<(string Message, int Code)>();
        private SimulationRig rig;
        private string folder;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            folder = TestFolder.Fresh();
            ends.Clear();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            TestFolder.Delete(folder);
        }

        private void AddLiquid(string name, bool liquid, float x) => rig.Create(name, liquid, new Vector3(x, 0f, 0f)).StopSimulation();

        private void Export(params string[] flags) =>
            ExportPlay.WriteOpenScene(
                ExportArguments.Parse(new[] { "player", "--" }.Concat(flags).Concat(new[] { "--seconds", "0.1", "--out", folder })
                    .ToArray()),
                (message, code) => ends.Add((message, code)));

        // The folders of cases that were written.
        private string[] Written => Directory.Exists(folder)
            ? Directory.GetFiles(folder, "manifest.json", SearchOption.AllDirectories)
                .Select(f => Path.GetFileName(Path.GetDirectoryName(f))).OrderBy(n => n).ToArray()
            : new string[0];

        [Test]
        public void OneWithoutLiquidIsNamedAndTheOthersAreWritten()
        {
            AddLiquid("Basin", true, 0f);
            AddLiquid("Jug", false, 1f);
            AddLiquid("Tank", true, 2f);
            LogAssert.Expect(LogType.Error, new Regex("'Jug'.*holds no liquid"));

            Export("--particles", "27");

            Assert.That(Written, Is.EqualTo(new[] { "Basin", "Tank" }));
            Assert.That(ends, Is.EqualTo(new[] { ((string)null, 1) }));
        }

        [Test]
        public void AllOfASceneIsExitCode0()
        {
            AddLiquid("Basin", true, 0f);
            AddLiquid("Tank", true, 1f);

            Export("--strict");

            Assert.That(Written, Is.EqualTo(new[] { "Basin", "Tank" }));
            Assert.That(ends, Is.EqualTo(new[] { ((string)null, 0) }));
        }

        [Test]
        public void StrictWritesNothingWhereOneIsWithoutLiquid()
        {
            AddLiquid("Basin", true, 0f);
            AddLiquid("Jug", false, 1f);
            LogAssert.Expect(LogType.Error, new Regex("'Jug'.*holds no liquid"));

            Export("--strict");

            Assert.That(Written, Is.Empty);
            Assert.That(ends.Single().Code, Is.EqualTo(1));
        }

        [Test]
        public void ASceneWithoutASimulationIsExitCode2()
        {
            Export();

            Assert.That(ends.Single().Code, Is.EqualTo(2));
            Assert.That(ends.Single().Message, Does.Contain("has no Fluid Simulation"));
        }
    }
}

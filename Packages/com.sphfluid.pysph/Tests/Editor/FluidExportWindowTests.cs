using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The window's export outside play mode: the liquids of the open scenes, which start nothing.</summary>
    public sealed class FluidExportWindowTests
    {
        private string folder;
        private FluidExportWindow window;

        [SetUp]
        public void SetUp()
        {
            folder = TestFolder.Fresh();
            window = ScriptableObject.CreateInstance<FluidExportWindow>();
            window.Folder = folder;
        }

        [TearDown]
        public void TearDown()
        {
            UnityEngine.Object.DestroyImmediate(window);
            TestFolder.Delete(folder);
        }

        [Test]
        public void TheLiquidOfTheSceneIsWritten()
        {
            using (var rig = new SimulationRig())
            {
                rig.Create();
                window.Export();

                Assert.That(window.Lines.Last(), Does.StartWith("64 particles of liquid and ").And.EndWith($"in {folder}."));
                Assert.That(File.Exists(Path.Combine(folder, "case.py")), Is.True);
            }
        }

        [Test]
        public void WithoutASimulationItSaysSo()
        {
            window.Export();

            Assert.That(window.Lines.Single(), Does.StartWith("No Fluid Simulation is enabled"));
            Assert.That(Directory.Exists(folder), Is.False);
        }

        [Test]
        public void AForeignFolderIsLeftAlone()
        {
            Directory.CreateDirectory(folder);
            File.WriteAllText(Path.Combine(folder, "mine.txt"), "");
            using (var rig = new SimulationRig())
            {
                rig.Create();
                window.Export();

                Assert.That(window.Lines.Last(), Does.Contain("no export wrote"));
                Assert.That(Directory.GetFiles(folder).Length, Is.EqualTo(1));
            }
        }
    }
}

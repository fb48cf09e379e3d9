using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Settings of the package that they should not have.</summary>
    public sealed class PlaybackSettingsTests : SettingsContract
    {
        private SequenceFiles files;

        private static IEnumerable<Type> Roots => RootsOf(typeof(FluidPlayback).Assembly);

        [SetUp]
        public void MakeFolder() => files = new SequenceFiles();

        [TearDown]
        public void DeleteFolder() => files.Dispose();

        [UnityTest]
        public IEnumerator BadValuesAreClampedOrToldOrThrown([ValueSource(nameof(Roots))] Type type) => TryAll(type);

        protected override object Make(Type type)
        {
            object made = base.Make(type);
            if (made is FluidPlayback playback) playback.Folder = Sequence();
            return made;
        }

        // Without sequence.json, so that a playback's own numbers count.
        private string Sequence()
        {
            for (int i = 0; i < 3; i++) File.WriteAllBytes(files[$"f{i}.ply"], SequenceFiles.Ply(SimulationRig.Read(Simulation)));
            return files.Folder;
        }
    }
}

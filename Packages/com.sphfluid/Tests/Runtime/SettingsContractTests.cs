using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Settings of the package that they should not have.</summary>
    public sealed class SettingsContractTests : SettingsContract
    {
        private static IEnumerable<Type> Roots => RootsOf(typeof(FluidSimulation).Assembly);

        [UnityTest]
        public IEnumerator BadValuesAreClampedOrToldOrThrown([ValueSource(nameof(Roots))] Type type) => TryAll(type);
    }
}

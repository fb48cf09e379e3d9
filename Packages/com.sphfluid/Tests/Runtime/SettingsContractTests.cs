using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Settings of the package that they should not have.</summary>
    public sealed class SettingsContractTests : SettingsContract
    {
        private static IEnumerable<Type> Roots => ProductTypes.Assemblies.SelectMany(RootsOf);

        [UnityTest]
        public IEnumerator BadValuesAreClampedOrToldOrThrown([ValueSource(nameof(Roots))] Type type) => TryAll(type);
    }
}

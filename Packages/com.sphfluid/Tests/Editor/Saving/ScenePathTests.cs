using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Names by which components are found again.</summary>
    public sealed class ScenePathTests
    {
        [Test]
        public void SiblingsOfANameAndComponentsOfAKindHaveNumbers()
        {
            var root = new GameObject("Crates of a test");
            try
            {
                GameObject[] crates = Enumerable.Range(0, 3).Select(_ => new GameObject("Crate")).ToArray();
                foreach (GameObject crate in crates) crate.transform.SetParent(root.transform, false);
                var barrel = new GameObject("Barrel");
                barrel.transform.SetParent(root.transform, false);
                barrel.transform.SetSiblingIndex(0);
                BoxCollider first = crates[2].AddComponent<BoxCollider>(), second = crates[2].AddComponent<BoxCollider>();
                SphereCollider ball = crates[2].AddComponent<SphereCollider>();
                Assert.That(ScenePath.GetPath(first), Is.EqualTo("Crates of a test/Crate#2:BoxCollider"));
                Assert.That(ScenePath.GetPath(second), Is.EqualTo("Crates of a test/Crate#2:BoxCollider#1"));
                Assert.That(ScenePath.GetPath(ball), Is.EqualTo("Crates of a test/Crate#2:SphereCollider"));
                Assert.That(ScenePath.GetPath(crates[0].transform), Is.EqualTo("Crates of a test/Crate:Transform"));
                Assert.That(ScenePath.GetPath(barrel.transform), Is.EqualTo("Crates of a test/Barrel:Transform"));
                var twin = new GameObject("Crates of a test");
                Assert.That(ScenePath.GetPath(twin.transform), Is.EqualTo("Crates of a test#1:Transform"));
                Object.DestroyImmediate(twin);
            }
            finally
            {
                Object.DestroyImmediate(root);
            }
        }
    }
}

using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class PackageLiquidsTests
    {
        [Test]
        public void NamesAreThoseOfTheFolder()
        {
            string folder = Path.GetFullPath(PackageLiquids.Folder);
            Assert.That(PackageLiquids.Names.Select(PackageLiquids.AssetName),
                Is.EquivalentTo(Directory.GetFiles(folder, "*.asset").Select(Path.GetFileNameWithoutExtension)));
        }

        [TestCaseSource(typeof(PackageLiquids), nameof(PackageLiquids.Names))]
        public void ANameIsALiquid(string name) => Assert.That(PackageLiquids.Load(name).Profile, Is.Not.Null);
    }
}

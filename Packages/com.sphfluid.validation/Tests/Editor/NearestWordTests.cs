using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class NearestWordTests
    {
        private static readonly string[] Flags = { "--scene", "--seconds", "--fps", "--size", "--surface", "--seed" };

        [TestCase("--szie", "--size", TestName = "TwoLettersSwapped")]
        [TestCase("--sizes", "--size", TestName = "OneTooMany")]
        [TestCase("--scen", "--scene", TestName = "OneMissing")]
        [TestCase("--surfaec", "--surface", TestName = "TwoSwappedInALongWord")]
        [TestCase("--sorfacce", "--surface", TestName = "TwoLettersWrongInALongWord")]
        [TestCase("--fsp", "--fps", TestName = "InAShortWord")]
        [TestCase("--speed", "--seed", TestName = "ALetterTooMany")]
        public void IsFound(string word, string nearest)
        {
            Assert.That(NearestWord.Of(word, Flags), Is.EqualTo(nearest));
            Assert.That(NearestWord.Question(word, Flags), Is.EqualTo($"; did you mean {nearest}?"));
        }

        [TestCase("--colour")]
        [TestCase("--xyz")]
        [TestCase("")]
        [TestCase("-")]
        public void NothingIsNearWhereMoreThanAThirdDiffers(string word)
        {
            Assert.That(NearestWord.Of(word, Flags), Is.Empty);
            Assert.That(NearestWord.Question(word, Flags), Is.EqualTo("."));
        }
    }
}

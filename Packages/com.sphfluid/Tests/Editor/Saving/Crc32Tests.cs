using System;
using System.Text;
using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>The check of bytes, against its definition bit by bit.</summary>
    public sealed class Crc32Tests
    {
        [TestCase("", 0x00000000u)]
        [TestCase("a", 0xE8B7BE43u)]
        [TestCase("123456789", 0xCBF43926u)]
        public void KnownChecksAreMet(string text, uint expected) =>
            Assert.That(Crc32.Compute(Encoding.ASCII.GetBytes(text)), Is.EqualTo(expected));

        [Test]
        public void EveryLengthAndEveryCutGiveWhatTheDefinitionGives()
        {
            var bytes = new byte[67];
            new System.Random(3).NextBytes(bytes);
            for (int length = 0; length <= bytes.Length; length++)
            {
                uint expected = ByDefinition(bytes, length);
                for (int cut = 0; cut <= length; cut++)
                {
                    Assert.That(Crc32.Compute(new ReadOnlySpan<byte>(bytes, cut, length - cut),
                        Crc32.Compute(new ReadOnlySpan<byte>(bytes, 0, cut))), Is.EqualTo(expected), $"{cut} of {length}");
                }
            }
        }

        private static uint ByDefinition(byte[] bytes, int length)
        {
            uint crc = 0xFFFFFFFFu;
            for (int bit = 0; bit < 8 * length; bit++)
            {
                bool isSet = ((crc ^ (uint)bytes[bit / 8] >> bit % 8) & 1u) != 0u;
                crc = crc >> 1 ^ (isSet ? 0xEDB88320u : 0u);
            }
            return ~crc;
        }
    }
}

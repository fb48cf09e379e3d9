using System;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>A part of a sweep, the work of one machine: I of N, counted from 1.</summary>
    internal sealed class Shard : IEquatable<Shard>
    {
        /// <summary>Most shards that a sweep is divided into.</summary>
        public const int Most = 10000;

        /// <param name="index">From 1.</param>
        /// <param name="count">Number of shards.</param>
        public Shard(int index, int count)
        {
            Index = index;
            Count = count;
        }

        /// <summary>I, from 1.</summary>
        public int Index { get; }

        /// <summary>N.</summary>
        public int Count { get; }

        /// <summary>Whether there can be such a shard.</summary>
        public bool IsPossible => Count >= 1 && Count <= Most && Index >= 1 && Index <= Count;

        /// <summary>The value of a flag.</summary>
        /// <exception cref="CommandLineException">It is no shard.</exception>
        public static Shard Parse(string flag, string value)
        {
            string[] words = value.Split('/');
            if (words.Length == 2 && TryNumber(words[0], out int index) && TryNumber(words[1], out int count))
            {
                var shard = new Shard(index, count);
                if (shard.IsPossible) return shard;
            }
            throw new CommandLineException(
                $"{flag} must be I/N, one of N shards from 1/N to N/N with N at most {Most}, such as 1/4; found " +
                $"'{CommandLineWords.Shown(value)}'.");
        }

        /// <inheritdoc/>
        public bool Equals(Shard other) => other != null && other.Index == Index && other.Count == Count;

        /// <inheritdoc/>
        public override bool Equals(object other) => Equals(other as Shard);

        /// <inheritdoc/>
        public override int GetHashCode() => Index * (Most + 1) + Count;

        /// <summary>For instance "1/4".</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0}/{1}", Index, Count);

        private static bool TryNumber(string word, out int number) =>
            int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out number);
    }
}

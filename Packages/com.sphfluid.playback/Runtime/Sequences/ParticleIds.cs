using System;

namespace SphFluid
{
    /// <summary>Particles in the order of their numbers.</summary>
    internal static class ParticleIds
    {
        /// <summary>Sorts particles by their numbers where they are not, in place and without garbage (heap sort, Williams 1964).</summary>
        /// <exception cref="SequenceException">Two have the same number.</exception>
        public static void Sort(Span<StoredParticle> particles)
        {
            if (!AreSorted(particles))
            {
                for (int i = particles.Length / 2 - 1; i >= 0; i--) Sink(particles, i, particles.Length);
                for (int end = particles.Length - 1; end > 0; end--)
                {
                    (particles[0], particles[end]) = (particles[end], particles[0]);
                    Sink(particles, 0, end);
                }
            }
            for (int i = 1; i < particles.Length; i++)
                if (particles[i].Id == particles[i - 1].Id)
                {
                    throw new SequenceException($"has two particles with the id {particles[i].Id}",
                        "Give each particle a number of its own, the same in all frames.");
                }
        }

        private static bool AreSorted(ReadOnlySpan<StoredParticle> particles)
        {
            for (int i = 1; i < particles.Length; i++)
                if (particles[i].Id < particles[i - 1].Id) return false;
            return true;
        }

        private static void Sink(Span<StoredParticle> heap, int place, int length)
        {
            StoredParticle sinking = heap[place];
            while (true)
            {
                int child = 2 * place + 1;
                if (child >= length) break;
                if (child + 1 < length && heap[child + 1].Id > heap[child].Id) child++;
                if (heap[child].Id <= sinking.Id) break;
                heap[place] = heap[child];
                place = child;
            }
            heap[place] = sinking;
        }
    }
}

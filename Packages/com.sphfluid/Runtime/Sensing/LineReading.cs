using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The questions of a <see cref="SensorLine"/>.</summary>
    internal sealed class LineReading
    {
        private readonly List<FluidQuery> queries = new List<FluidQuery>();
        private readonly List<float> densities = new List<float>();

        /// <summary>Asks at the points of a line from now on.</summary>
        /// <param name="all">The liquid's queries.</param>
        /// <param name="line">The line.</param>
        /// <param name="foot">Its foot in the world [m].</param>
        /// <param name="up">Its direction in the world.</param>
        public void Place(FluidQueries all, in SensorLine line, Vector3 foot, Vector3 up)
        {
            while (queries.Count > line.Count)
            {
                all.Remove(queries[queries.Count - 1]);
                queries.RemoveAt(queries.Count - 1);
            }
            for (int i = 0; i < line.Count; i++)
            {
                Vector3 place = foot + (line.First + i * line.Step) * up;
                if (i == queries.Count) queries.Add(all.AddPoint(place));
                else all.Move(queries[i], place);
            }
        }

        /// <summary>The answers.</summary>
        /// <param name="all">The liquid's queries.</param>
        /// <param name="last">Answer of the last point; of a point alone its own.</param>
        /// <returns>Densities from the foot on [kg/m³]; null while one is missing.</returns>
        public IReadOnlyList<float> Densities(FluidQueries all, out FluidPointResult last)
        {
            last = default;
            densities.Clear();
            foreach (FluidQuery query in queries)
            {
                if (!all.TryGet(query, out last)) return null;
                densities.Add(last.Density);
            }
            return queries.Count > 0 ? densities : null;
        }

        /// <summary>Ends the questions.</summary>
        public void Remove(FluidQueries all)
        {
            foreach (FluidQuery query in queries) all.Remove(query);
            queries.Clear();
        }
    }
}

using System;
using System.Collections;

namespace SphFluid.Validation
{
    /// <summary>A part of a long measurement, done as a whole.</summary>
    internal sealed class SessionJob
    {
        /// <summary>A job.</summary>
        /// <param name="name">For progress lines.</param>
        /// <param name="cost">Expected work, in any unit that all jobs of the session share.</param>
        /// <param name="isDone">Whether an earlier session has done it.</param>
        /// <param name="work">The work, which writes its results.</param>
        /// <param name="report">Says what came out, when the time left is known anew; null for nothing.</param>
        /// <param name="kind">Equal for jobs whose costs compare well with each other.</param>
        /// <param name="share">The part of its cost that is done, 0 to 1, while it runs; null where it does not know.</param>
        /// <param name="key">Names the job among all of its session, the same on every machine; null where the name does.</param>
        /// <param name="group">Equal for jobs that one machine should do, as they share work; null for a job of its own.</param>
        public SessionJob(string name, double cost, Func<bool> isDone, Func<IEnumerator> work, Action report = null, string kind = "",
            Func<double> share = null,
            string key = null, string group = null)
        {
            Name = name;
            Cost = cost;
            IsDone = isDone;
            Work = work;
            Report = report;
            Kind = kind;
            Share = share;
            Key = key ?? name;
            Group = group ?? Key;
        }

        public string Name { get; }

        public double Cost { get; }

        public Func<bool> IsDone { get; }

        public Func<IEnumerator> Work { get; }

        public Action Report { get; }

        public string Kind { get; }

        public Func<double> Share { get; }

        public string Key { get; }

        public string Group { get; }
    }
}

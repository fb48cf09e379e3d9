using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What a chart answers: the best way within what was asked, or the nearest ones in both directions.</summary>
    public sealed class ChoiceAnswer
    {
        internal ChoiceAnswer(ChoiceQuestion question, ChartData chart, IReadOnlyList<ChoiceOption> options)
        {
            Question = question;
            Chart = chart;
            Options = options;
            bool asksError = !double.IsNaN(question.Error), asksTime = !double.IsNaN(question.Milliseconds);
            List<ChoiceOption> accurate = options.Where(o => !asksError || o.Error.Likely <= question.Error).ToList();
            List<ChoiceOption> fast = options.Where(o => !asksTime || o.Milliseconds.Likely <= question.Milliseconds).ToList();
            Fastest = asksError ? Cheapest(accurate) : null;
            MostAccurate = asksTime ? LeastWrong(fast) : null;
            Best = asksError ? Cheapest(accurate.Intersect(fast).ToList()) : MostAccurate;
            PerMethod = options.GroupBy(o => o.Method).Select(own => asksError
                ? Cheapest(own.Intersect(accurate).ToList()) ?? LeastWrong(own)
                : LeastWrong(own.Intersect(fast)) ?? Quickest(own)).ToList();
        }

        /// <summary>What was asked.</summary>
        public ChoiceQuestion Question { get; }

        /// <summary>The chart that answers.</summary>
        public ChartData Chart { get; }

        /// <summary>All ways within what the chart measured.</summary>
        public IReadOnlyList<ChoiceOption> Options { get; }

        /// <summary>
        /// The answer: the fastest with the error asked for, one that holds what is also held if there is one; or with a time alone the
        /// most accurate. Null when there is none.
        /// </summary>
        public ChoiceOption Best { get; }

        /// <summary>
        /// The fastest with the error asked for, however long it takes; null when none has it, or no error was asked for.
        /// </summary>
        public ChoiceOption Fastest { get; }

        /// <summary>The most accurate within the time asked for; null when none is within it, or no time was asked for.</summary>
        public ChoiceOption MostAccurate { get; }

        /// <summary>The best of each method; where a method has none, its nearest.</summary>
        public IReadOnlyList<ChoiceOption> PerMethod { get; }

        /// <summary>The most accurate of all, however long it takes.</summary>
        public ChoiceOption Finest => LeastWrong(Options);

        /// <summary>The fastest of all, however wrong it is.</summary>
        public ChoiceOption QuickestOfAll => Quickest(Options);

        /// <summary>Whether an option errs by no more than was asked in what is also held; without an error asked for, always.</summary>
        public bool Holds(ChoiceOption option) => double.IsNaN(Question.Error) || option.Holds(Question.Error);

        // Of those that hold what is also held, if there are some.
        private ChoiceOption Cheapest(IReadOnlyList<ChoiceOption> options) => Quickest(options.Where(Holds)) ?? Quickest(options);

        private static ChoiceOption Quickest(IEnumerable<ChoiceOption> options) =>
            options.OrderBy(o => o.Milliseconds.Likely).FirstOrDefault();

        // Of equal errors, as below a reference's floor, the fastest.
        private static ChoiceOption LeastWrong(IEnumerable<ChoiceOption> options) =>
            options.OrderBy(o => o.Error.Likely).ThenBy(o => o.Milliseconds.Likely).FirstOrDefault();
    }
}

using System;
using System.Diagnostics;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>How far a measurement is: a bar on a terminal, else a line every ten seconds.</summary>
    public sealed class SessionProgress
    {
        private const int BarCells = 24;
        private const double SecondsBetweenLines = 10.0;

        private readonly Action<string> line;
        private readonly Action<string> bar;
        private readonly Stopwatch sinceLast = new Stopwatch();
        private bool barShown;

        /// <param name="line">Takes whole lines.</param>
        /// <param name="bar">Takes the bar, which overwrites itself; null where there is no terminal.</param>
        public SessionProgress(Action<string> line, Action<string> bar)
        {
            this.line = line;
            this.bar = bar;
        }

        /// <summary>For the console of this process.</summary>
        public static SessionProgress OfConsole() =>
            new SessionProgress(Console.WriteLine, Console.IsOutputRedirected ? null : (Action<string>)Console.Write);

        /// <summary>Writes a line.</summary>
        /// <param name="text">The line.</param>
        public void Say(string text)
        {
            if (barShown) bar("\r\u001b[2K");
            barShown = false;
            line(text);
        }

        /// <summary>Shows how far it is, unless it was shown a moment ago.</summary>
        /// <param name="share">Done part, 0 to 1.</param>
        /// <param name="left">Time left; null while it is not known.</param>
        /// <param name="what">What comes next.</param>
        public void Show(double share, TimeSpan? left, string what)
        {
            double pause = bar != null ? 0.1 : SecondsBetweenLines;
            if (sinceLast.IsRunning && sinceLast.Elapsed.TotalSeconds < pause) return;
            sinceLast.Restart();
            string text = Text(share, left, what, bar != null);
            if (bar == null)
            {
                line(text);
                return;
            }
            bar("\r\u001b[2K" + text);
            barShown = true;
        }

        internal static string Text(double share, TimeSpan? left, string what, bool withBar)
        {
            int filled = (int)(Math.Min(1.0, share) * BarCells);
            string cells = withBar ? new string('█', filled) + new string('░', BarCells - filled) + " " : "";
            string time = left.HasValue ? Duration(left.Value) + " left  " : "";
            return string.Format(CultureInfo.InvariantCulture, "{0}{1,3:F0} %  {2}{3}", cells, 100.0 * share, time, what);
        }

        /// <summary>A time as one says it: "about 40 s", "about 3 min", "about 1 h 20 min".</summary>
        internal static string About(TimeSpan time)
        {
            if (time.TotalSeconds < 95.0) return $"about {Math.Max(5, 5 * (int)Math.Round(time.TotalSeconds / 5.0))} s";
            int minutes = (int)Math.Round(time.TotalMinutes);
            return minutes < 90 ? $"about {minutes} min" : $"about {minutes / 60} h{(minutes % 60 > 0 ? $" {minutes % 60} min" : "")}";
        }

        /// <summary>Minutes and seconds, e.g. 2:05.</summary>
        internal static string Duration(TimeSpan time) =>
            string.Format(CultureInfo.InvariantCulture, "{0}:{1:00}", (int)time.TotalMinutes, time.Seconds);
    }
}

using System;

namespace SphFluid
{
    /// <summary>
    /// The speed that a running liquid's constants are made for. It follows the measured one down slowly, because a softer liquid is
    /// compressed more and its level sinks, and up at once as fast as pressure can follow; never above the speed by rule but for what
    /// colliders do. Where a softer liquid would save no step it stays as it is.
    /// </summary>
    internal sealed class SpeedReference
    {
        // s, in which the speed changes by a factor e at most: down in many swings of a pool's compression, up in one or two.
        private const double FallTime = 1.0;
        private const double RiseTime = 0.1;

        // s: nothing needs what costs no step, and where frames differ in length the next may cost one, so it comes slowly.
        private const double SpareTime = 6.0;

        // A bin's edge is no change: the fall begins below a bin's width. What costs no step depends on bins but little, and must be met.
        private const double Slack = 1.07, SpareSlack = 1.01;

        // s: a single long frame counts for no more.
        private const double LongestFrame = 0.1;

        private bool falls;

        /// <summary>Starts with the speed by rule.</summary>
        /// <param name="most">The speed by rule [m/s].</param>
        public SpeedReference(double most)
        {
            Most = Speed = most;
        }

        /// <summary>The speed by rule, which only colliders exceed [m/s].</summary>
        public double Most { get; private set; }

        /// <summary>The speed in use [m/s].</summary>
        public double Speed { get; private set; }

        /// <summary>Starts below the speed by rule.</summary>
        /// <param name="speed">The speed in use [m/s].</param>
        public void Begin(double speed) => Speed = Math.Min(speed, Most);

        /// <summary>Takes over another speed by rule; where it grows, the speed in use grows with it at once.</summary>
        public void Limit(double most)
        {
            if (most > Most) Speed *= most / Most;
            Speed = Math.Min(Speed, most);
            Most = most;
        }

        /// <summary>Back to the speed by rule: the liquid is another one.</summary>
        public void Restart()
        {
            Speed = Most;
            falls = false;
        }

        /// <summary>The speed in use, and whether it falls; for saves.</summary>
        internal (double speed, bool falls) Progress
        {
            get => (Speed, falls);
            set => (Speed, falls) = (double.IsInfinity(value.speed) ? Most : value.speed, value.falls);
        }

        /// <summary>Follows the measured speed for a frame.</summary>
        /// <param name="measured">What the liquid has or will have at the domain's lowest place [m/s].</param>
        /// <param name="time">Length of the frame [s].</param>
        /// <param name="driven">What colliders make necessary, whatever the rule says [m/s].</param>
        /// <param name="loaded">The part of that by accelerations, which comes with the pressure that a stiffer liquid needs [m/s].</param>
        /// <param name="leap">Times that the speed may be at once for such a part: liquid under no pressure does not feel it.</param>
        /// <param name="spare">The speed up to which frames take no more steps [m/s].</param>
        /// <returns>Whether the speed in use changed.</returns>
        public bool Update(double measured, double time, double driven = 0.0, double loaded = 0.0, double leap = 1.0, double spare = 0.0)
        {
            double before = Speed, target = Math.Max(Math.Min(measured, Most), driven), frame = Math.Min(time, LongestFrame);
            double least = Math.Max(target, Math.Min(spare, Most));
            if (target > Speed) Speed = Math.Min(target, Math.Max(Speed * Math.Exp(frame / RiseTime), Math.Min(loaded, Speed * leap)));
            else if (least > Speed) Speed = Math.Min(least, Speed * Math.Exp(frame / SpareTime));
            falls = least < Speed && (falls || least * (least > target ? SpareSlack : Slack) < Speed);
            if (falls) Speed = Math.Max(least, Speed * Math.Exp(-frame / FallTime));
            return Speed != before;
        }
    }
}

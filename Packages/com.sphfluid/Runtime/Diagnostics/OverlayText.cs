using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace SphFluid
{
    /// <summary>Writes figures of liquids and the times of stages as lines of text.</summary>
    internal sealed class OverlayText
    {
        // Longest line of a message: it shall not make the box as wide as the screen.
        private const int MessageWidth = 64;

        private readonly StringBuilder text = new StringBuilder(1024);

        /// <summary>Text of a frame, lines parted by '\n'.</summary>
        /// <param name="liquids">The liquids.</param>
        /// <param name="times">Times of the stages, or null where none are wanted.</param>
        /// <param name="stages">The stages.</param>
        /// <param name="frameTime">Mean time of a frame [s].</param>
        /// <param name="dispatches">Mean compute dispatches of a frame, of all liquids and their surfaces.</param>
        public string Write(IReadOnlyList<LiquidFigures> liquids, StageTimes times, IReadOnlyList<FluidStage> stages, double frameTime,
            double dispatches)
        {
            text.Clear();
            Add($"SPH Fluid   frame {1e3 * frameTime:0.0} ms, {dispatches:0} dispatches");
            if (liquids.Count == 0) text.Append("\nno Fluid Simulation is enabled");
            for (int i = 0; i < liquids.Count; i++) Write(liquids[i]);
            if (times != null) Write(times, stages);
            return text.ToString();
        }

        private void Write(in LiquidFigures liquid)
        {
            text.Append('\n').Append(liquid.Name).Append("   ").Append(liquid.State);
            if (liquid.Runs)
            {
                if (liquid.Method != null) text.Append("\n  ").Append(liquid.Method);
                if (liquid.Detail != null) text.Append("\n  ").Append(liquid.Detail);
                Add($"\n  {liquid.Particles:N0} particles, {liquid.Slots:N0} slots");
                if (liquid.Removed > 0) Add($", {liquid.Removed:N0} removed");
                if (liquid.Refused > 0) Add($", {liquid.Refused:N0} not born for want of slots");
                Add($"\n  {liquid.StepsPerFrame:0.0} steps a frame of {1e3 * liquid.TimeStep:0.00} ms");
                Add($", {liquid.SetupsPerFrame:0.0} neighbour set-ups, real time x {liquid.RealTimeFactor:0.00}");
                text.Append("\n  limited by ").Append(TimeStepAdvice.NameOf(liquid.Limit));
                if (liquid.CapHits > 0) Add($" and Max Substeps Per Frame, {liquid.MostSteps}");
                Add($"; {Math.Ceiling(liquid.Bytes / 1048576.0):0} MB");
            }
            if (!string.IsNullOrEmpty(liquid.Message)) WriteMessage(liquid.Message);
        }

        private void WriteMessage(string message)
        {
            int width = MessageWidth + 1;
            foreach (string word in message.Split(' '))
            {
                bool breaks = width + 1 + word.Length > MessageWidth;
                if (breaks) text.Append(width > MessageWidth ? "\n  ! " : "\n    ");
                else text.Append(' ');
                text.Append(word);
                width = breaks ? word.Length : width + 1 + word.Length;
            }
        }

        private void Write(StageTimes times, IReadOnlyList<FluidStage> stages)
        {
            if (times.Clock == StageClock.None)
            {
                text.Append("\nno stage times: Unity measures them in the Editor and in development builds");
                return;
            }
            text.Append(times.Clock == StageClock.Gpu ? "\nGPU, ms a frame" : "\nCPU, ms a frame to submit: no GPU times here");
            if (!times.HasTimes)
            {
                text.Append(": none yet");
                return;
            }
            double sum = 0.0;
            for (int i = 0; i < stages.Count; i++)
            {
                sum += times.Milliseconds(i);
                Add($"\n  {times.Milliseconds(i),7:0.00}  {stages[i].Name}");
            }
            Add($"\n  {sum,7:0.00}  together");
        }

        private void Add(FormattableString line) => text.Append(line.ToString(CultureInfo.InvariantCulture));
    }
}

namespace SphFluid.Validation
{
    /// <summary>A line of playback.csv: a sequence that was streamed at a frame rate, and jumps in it.</summary>
    internal sealed class PlaybackRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<PlaybackRow> Format = new TableFormat<PlaybackRow>("playback.csv")
            .Text("mode", r => r.Mode)
            .Count("particles", r => r.Particles)
            .Count("frames", r => r.Frames)
            .Count("file_bytes", r => r.FileBytes)
            .Number("budget_mib", r => r.Budget)
            .Number("memory_mib", r => r.Memory)
            .Number("frames_a_second", r => r.Rate)
            .Count("held_frames", r => r.Held)
            .Number("main_ms_median", r => r.MainMedian)
            .Number("main_ms_max", r => r.MainMost)
            .Count("seeks", r => r.Seeks)
            .Number("seek_ms_median", r => r.SeekMedian)
            .Number("seek_ms_max", r => r.SeekMost)
            .Text("device", r => r.Device)
            .Text("date", r => r.Date)
            .Text("driver", r => r.Machine.Driver)
            .Text("processor", r => r.Machine.Processor)
            .Text("commit", r => r.Machine.Commit);

        /// <summary>Whether each frame is shown as it is, or particles between frames too.</summary>
        public string Mode = "";

        public BenchMachine Machine = BenchMachine.This;

        public long Particles, Frames, FileBytes;

        /// <summary>Memory that may be taken, and is [MiB].</summary>
        public double Budget, Memory;

        /// <summary>Frames of the scene a second, as they came.</summary>
        public double Rate;

        /// <summary>Frames of the scene that had to show an older one.</summary>
        public long Held;

        /// <summary>Time of the playback and the simulation on the main thread, a frame that shows other particles [ms].</summary>
        public double MainMedian, MainMost;

        /// <summary>Number of jumps.</summary>
        public long Seeks;

        /// <summary>Time from a jump to the frame being shown [ms].</summary>
        public double SeekMedian, SeekMost;
    }
}

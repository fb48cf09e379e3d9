using System.Globalization;
using System.Text;

namespace Headless.Player.Output;

/// <summary>
/// <c>timings.csv</c>: a row a frame. GPU times arrive some frames late and a pass may appear at any time, so the file is
/// written whole beside the old one and then put in its place: what is on the disk is always valid.
/// </summary>
public sealed class TimingsFile(string path)
{
    public const string FileName = "timings.csv";

    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(2);

    private readonly Lock gate = new();
    private readonly List<Row> rows = [];
    private readonly List<string> passes = [];
    private DateTime last = DateTime.MinValue;

    private sealed record Row(int Frame, double Time, double CpuMilliseconds)
    {
        public double? Gpu { get; set; }
        public Dictionary<string, double> Passes { get; } = [];
    }

    public int Rows => rows.Count;

    public void AddFrame(int frame, double time, double cpuMilliseconds)
    {
        lock (gate) rows.Add(new Row(frame, time, cpuMilliseconds));
        if (DateTime.UtcNow - last > Interval) Save();
    }

    /// <summary>Adds GPU time of a frame already added; a pass that ran several times sums up.</summary>
    public void AddGpu(int frame, double totalMilliseconds, IEnumerable<(string Pass, double Milliseconds)> times)
    {
        lock (gate) Add(frame, totalMilliseconds, times);
    }

    private void Add(int frame, double totalMilliseconds, IEnumerable<(string Pass, double Milliseconds)> times)
    {
        if (rows.Find(r => r.Frame == frame) is not { } row) return;
        row.Gpu = (row.Gpu ?? 0) + totalMilliseconds;
        foreach (var (pass, milliseconds) in times)
        {
            if (!passes.Contains(pass)) passes.Add(pass);
            row.Passes[pass] = row.Passes.GetValueOrDefault(pass) + milliseconds;
        }
    }

    /// <summary>Safe for the thread that ends an interrupted run.</summary>
    public void Save()
    {
        lock (gate) Write();
    }

    private void Write()
    {
        last = DateTime.UtcNow;
        var text = new StringBuilder("frame,time_s,cpu_ms,gpu_ms");
        foreach (string pass in passes) text.Append(',').Append(Escape("gpu_ms." + pass));
        text.Append('\n');
        foreach (Row row in rows)
        {
            text.Append(CultureInfo.InvariantCulture, $"{row.Frame},{row.Time:0.######},{row.CpuMilliseconds:0.###},{Number(row.Gpu)}");
            foreach (string pass in passes) text.Append(',').Append(row.Passes.TryGetValue(pass, out double ms) ? Number(ms) : "");
            text.Append('\n');
        }
        WholeFile.WriteText(path, text.ToString());
    }

    private static string Number(double? value) => value?.ToString("0.####", CultureInfo.InvariantCulture) ?? "";

    private static string Escape(string name) => name.AsSpan().IndexOfAny(",\"\n") < 0 ? name : '"' + name.Replace("\"", "\"\"") + '"';
}

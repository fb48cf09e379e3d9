using System.Diagnostics;

namespace Headless.Shaders.Direct3D;

/// <summary>A running d3dcompiler_47.dll that takes one job after another. Not safe for several threads.</summary>
internal sealed class FxcSession : IDisposable
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(5);

    private readonly string _folder = Directory.CreateTempSubdirectory("headless-fxc-").FullName;
    private readonly WineToolchain _toolchain;
    private readonly Process _process;
    private int _jobs;

    public FxcSession(WineToolchain toolchain)
    {
        _toolchain = toolchain;
        ProcessStartInfo start = toolchain.Start(_folder, "-");
        start.RedirectStandardInput = true;
        start.RedirectStandardOutput = true;
        start.RedirectStandardError = true;
        _process = Process.Start(start)!;
        // What Wine says of itself; unread, it would fill the pipe.
        _process.ErrorDataReceived += (_, _) => { };
        _process.BeginErrorReadLine();
    }

    /// <summary>Whether the process still takes jobs.</summary>
    public bool Alive { get; private set; } = true;

    /// <summary>The compiled shader, or null, and the compiler's errors and warnings, " | " between them.</summary>
    public (byte[]? Code, string Messages) Compile(string text, string entryPoint, string profile)
    {
        string id = _jobs++.ToString();
        string source = Path.Combine(_folder, id + ".hlsl");
        string output = Path.Combine(_folder, id + ".dxbc");
        File.WriteAllText(source, text);
        try
        {
            string[] fields = Ask(id, $"{id}\t{id}.hlsl\t{entryPoint}\t{profile}\t{id}.dxbc").Split('\t');
            bool good = fields[1] == "ok" && File.Exists(output);
            return (good ? File.ReadAllBytes(output) : null, fields.Length > 6 ? fields[6].Trim() : "");
        }
        finally
        {
            File.Delete(source);
            File.Delete(output);
        }
    }

    public void Dispose()
    {
        Alive = false;
        try
        {
            _process.StandardInput.Close();
            if (!_process.WaitForExit(TimeSpan.FromSeconds(5)))
            {
                _process.Kill();
            }
        }
        catch (IOException)
        {
            // It has ended already.
        }
        _process.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    private string Ask(string id, string job)
    {
        try
        {
            _process.StandardInput.Write(job + "\n");
            _process.StandardInput.Flush();
        }
        catch (IOException)
        {
            Alive = false;
            return _toolchain.Crashed(id);
        }
        while (true)
        {
            Task<string?> line = _process.StandardOutput.ReadLineAsync();
            if (!line.Wait(Limit))
            {
                _process.Kill();
                Alive = false;
                return _toolchain.Crashed(id).Replace("crashed", $"did not finish in {Limit.TotalMinutes} minutes");
            }
            if (line.Result is null)
            {
                Alive = false;
                return _toolchain.Crashed(id);
            }
            if (WineToolchain.IsResult(line.Result))
            {
                return line.Result;
            }
        }
    }
}

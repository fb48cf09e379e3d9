namespace Headless.Shaders.Direct3D;

/// <summary>A small C program that hands a list of jobs to one of Microsoft's shader compilers.</summary>
/// <param name="Name">Of the program, and of its source without ".c".</param>
/// <param name="Library">The compiler.</param>
/// <param name="Folder">Below the cache folder, for the program and Wine's files.</param>
/// <param name="Overrides">Which of Wine's own libraries are used (WINEDLLOVERRIDES).</param>
/// <param name="NoFigures">What a line of results has between "failed" and the message.</param>
internal sealed record WineDriver(string Name, string Library, string Folder, string Overrides, string NoFigures)
{
    /// <summary>The compiler that Unity uses for Direct3D 11.</summary>
    public static readonly WineDriver Fxc = new("fxc_jobs", "d3dcompiler_47.dll", "fxc", "d3dcompiler_47=n;mscoree=;mshtml=", "0\t0\t0\t0");

    /// <summary>The compiler of shader model 6, which Unity uses for "#pragma use_dxc" and for consoles.</summary>
    public static readonly WineDriver Dxc = new("dxc_jobs", "dxcompiler.dll", "dxc", "mscoree=;mshtml=", "0");
}
